#include "training/code_function.hpp"

#include <Eigen/Cholesky>
#include <limits>

#include "base/error.hpp"
#include "learning/face_features.hpp"

namespace mien::training {
namespace {

/// Codes and what they leave of their faces, a column a face, in the mean's frame.
struct Leftovers {
    Matrix codes, rest;
};

Leftovers leftovers_of(const RunContext& context, const FaceNetwork& pca,
                       const std::vector<Index>& faces) {
    const Index count = static_cast<Index>(faces.size()), size = 3 * pca.num_vertices();
    Leftovers left{Matrix(pca.code_size(), count), Matrix(size, count)};
    Points face;
    for (Index k = 0; k < count; ++k) {
        context.data.face(faces[static_cast<std::size_t>(k)], face);
        Similarity motion;
        const Points own = onto_mean_shape(face, pca.mean(), &motion);
        const Eigen::VectorXf code = pca.encode(face, nullptr, {});
        const Points rest = own - pca.decode(code, nullptr, {});
        left.codes.col(k) = code.cast<double>();
        left.rest.col(k) = Eigen::Map<const Vector>(rest.data(), size);
    }
    return left;
}

std::vector<Index> at_most(const std::vector<Index>& faces, Index most) {
    const Index count = static_cast<Index>(faces.size());
    if (count <= most) return faces;
    std::vector<Index> some;
    for (Index k = 0; k < most; ++k)
        some.push_back(faces[static_cast<std::size_t>(k * count / most)]);
    return some;
}

/// f(z) = weights' k(z), of whitened codes.
class CodeFunction {
  public:
    explicit CodeFunction(const Leftovers& left) : left_(left) {
        mean_ = left.codes.rowwise().mean();
        const Matrix centred = left.codes.colwise() - mean_;
        inverse_ = (centred.rowwise().squaredNorm() / static_cast<double>(centred.cols()))
                       .cwiseSqrt()
                       .cwiseMax(1e-300)
                       .cwiseInverse();
        codes_ = inverse_.asDiagonal() * centred;
        gram_ = kernel(codes_.transpose() * codes_);
    }

    void fit(double ridge) {
        Matrix system = gram_;
        system.diagonal().array() += ridge;
        const Eigen::LLT<Matrix> factor(system);
        if (factor.info() != Eigen::Success)
            fail(Status::no_solution, "the codes of the training faces determine no function");
        weights_ = factor.solve(left_.rest.transpose());
    }

    Points operator()(const Eigen::VectorXf& code) const {
        const Vector own = inverse_.cwiseProduct(code.cast<double>() - mean_);
        const Vector rest = weights_.transpose() * kernel(codes_.transpose() * own);
        return Eigen::Map<const Points>(rest.data(), rest.size() / 3, 3);
    }

  private:
    Matrix kernel(const Matrix& products) const {
        return (1.0 + products.array() / static_cast<double>(codes_.rows())).square();
    }

    const Leftovers& left_;
    Vector mean_, inverse_;
    Matrix codes_, gram_, weights_;
};

}  // namespace

nlohmann::json code_function_row(const RunContext& context, const FaceNetwork& pca,
                                 const CodeFunctionSettings& settings) {
    const bool neutral = context.configuration.data.neutral;
    const SubjectSplit& split = context.split;
    if (split.validation.empty()) return nullptr;
    const Leftovers left = leftovers_of(
        context, pca,
        at_most(chosen_faces(context.data, split.training, neutral), settings.most_faces));
    CodeFunction function(left);
    const auto reconstruct = [&](const Points& face) {
        Similarity motion;
        const Eigen::VectorXf code = pca.encode(face, &motion, {});
        const Points whole = pca.decode(code, nullptr, {}) + function(code);
        return Points(motion.inverse().apply(whole));
    };
    const auto errors = [&](const std::vector<std::int32_t>& people, bool perceptual) {
        return reconstruction_errors(context.data, chosen_faces(context.data, people, neutral),
                                     reconstruct, perceptual, {});
    };
    double least = std::numeric_limits<double>::infinity(), chosen = settings.ridges.front();
    for (const double ridge : settings.ridges) {
        function.fit(ridge);
        const double l1 = ReconstructionErrors::mean(errors(split.validation, false).l1_mm);
        if (l1 < least) least = l1, chosen = ridge;
    }
    function.fit(chosen);
    return {{"ridge", chosen}, {"test", errors_json(errors(split.test, true), pca.scale_mm())}};
}

}  // namespace mien::training
