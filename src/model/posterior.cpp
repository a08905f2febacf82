#include "model/posterior.hpp"

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "model/low_rank.hpp"

namespace mien {
namespace {

constexpr double kLeastNoise = 1e-6;

struct Storage {
    Eigen::MatrixXf basis, pca_modes;
};

void check(const DeformationModel& model, const std::vector<LandmarkObservation>& observations) {
    if (observations.empty())
        fail(Status::invalid_argument, "a posterior model needs at least one landmark");
    for (std::size_t i = 0; i < observations.size(); ++i) {
        const LandmarkObservation& seen = observations[i];
        const auto at = static_cast<std::int64_t>(i);
        if (static_cast<Index>(seen.vertex) >= model.num_vertices())
            fail_at(Status::invalid_argument, at, "landmark %zu is vertex %lld of %lld", i,
                    static_cast<long long>(seen.vertex),
                    static_cast<long long>(model.num_vertices()));
        if (!seen.displacement_mm.allFinite())
            fail_at(Status::invalid_argument, at, "the displacement of landmark %zu is not finite",
                    i);
        if (!(seen.noise_mm >= kLeastNoise) || !std::isfinite(seen.noise_mm))
            fail_at(Status::invalid_argument, at,
                    "landmark %zu has a noise of %g mm; give at least %g", i, seen.noise_mm,
                    kLeastNoise);
    }
    if (model.prior_variance.rows() != 0 &&
        (model.prior_variance.array() - 1).abs().maxCoeff() > 1e-12)
        fail(
            Status::unsupported_option,
            "a model with a mirror correlation has no posterior in one scalar basis; build it with "
            "correlation 0");
}

/// Symmetric square root of a positive definite matrix.
Matrix square_root(const Matrix& matrix) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the posterior covariance of the vector modes did not converge");
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace

std::shared_ptr<const DeformationModel> condition_model(
    const DeformationModel& model, const std::vector<LandmarkObservation>& observations,
    const Context& context) {
    check(model, observations);
    const Index n = model.num_vertices(), r = model.basis.cols, p = model.pca_modes.cols;
    const Index h = static_cast<Index>(observations.size());
    context.require_memory(
        static_cast<std::size_t>(n) * static_cast<std::size_t>(2 * r + 3 * p) * 12,
        "a posterior model");
    context.progress(Stage::basis, 0);
    const auto basis = model.basis.map();
    const auto modes = model.pca_modes.map();

    // Everything at the landmarks, divided by their noise.
    Matrix f(h, r), seen(h, 3);
    Matrix p_seen[3] = {Matrix(h, p), Matrix(h, p), Matrix(h, p)};
    for (Index i = 0; i < h; ++i) {
        const LandmarkObservation& o = observations[static_cast<std::size_t>(i)];
        const Index v = static_cast<Index>(o.vertex);
        f.row(i) = basis.row(v).cast<double>() / o.noise_mm;
        seen.row(i) = o.displacement_mm.transpose() / o.noise_mm;
        if (model.mean_displacement.rows() != 0)
            seen.row(i) -= model.mean_displacement.row(v) / o.noise_mm;
        for (int c = 0; c < 3; ++c)
            p_seen[c].row(i) = modes.row(3 * v + c).cast<double>() / o.noise_mm;
    }
    // C = I + F F' is the covariance of what is seen, in units of the noise.
    const Matrix covariance = Matrix::Identity(h, h) + f * f.transpose();
    const Eigen::LLT<Matrix> factor(covariance);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the landmarks' covariance is not positive definite");

    // Vector modes first, by their marginal posterior.
    Vector c_mean = Vector::Zero(p);
    Matrix c_root = Matrix::Identity(p, p);
    if (p != 0) {
        Matrix precision = Matrix::Identity(p, p);
        Vector right = Vector::Zero(p);
        for (int c = 0; c < 3; ++c) {
            const Matrix solved = factor.solve(p_seen[c]);
            precision += p_seen[c].transpose() * solved;
            right += solved.transpose() * seen.col(c);
        }
        const Matrix c_covariance = precision.llt().solve(Matrix::Identity(p, p));
        c_mean = c_covariance * right;
        c_root = square_root(c_covariance);
    }
    Matrix rest = seen;
    for (int c = 0; c < 3; ++c) rest.col(c) -= p_seen[c] * c_mean;
    const Matrix a_mean = f.transpose() * factor.solve(rest);

    auto storage = std::make_shared<Storage>();
    auto result = std::make_shared<DeformationModel>();
    result->template_mesh = model.template_mesh;
    result->landmarks = model.landmarks;
    result->zones = model.zones;
    result->info = model.info;
    result->info["posterior_landmarks"] = std::to_string(h);
    const Matrix full = basis.cast<double>();
    Points mean =
        model.mean_displacement.rows() != 0 ? model.mean_displacement : Points::Zero(n, 3);
    mean += full * a_mean;
    storage->pca_modes.resize(3 * n, p);
    if (p != 0) {
        for (int c = 0; c < 3; ++c) {
            const Matrix bend = full * (f.transpose() * factor.solve(p_seen[c]));  // Phi B
            Matrix own(n, p);
            for (Index v = 0; v < n; ++v) own.row(v) = modes.row(3 * v + c).cast<double>();
            mean.col(c) += own * c_mean;
            own = ((own - bend) * c_root).eval();
            for (Index v = 0; v < n; ++v)
                storage->pca_modes.row(3 * v + c) = own.row(v).cast<float>();
        }
    }
    context.progress(Stage::basis, 0.3);

    if (r != 0) {
        // Phi S^1/2 without any r x r eigenproblem.
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(covariance);
        if (eigen.info() != Eigen::Success)
            fail(Status::no_solution, "the landmarks' covariance did not converge");
        // eigenvalues are 1 + D; directions with D = 0 lie outside the basis' reach.
        const Vector d = (eigen.eigenvalues().array() - 1).max(0.0);
        Vector shrink(h), inverse_length(h);
        for (Index i = 0; i < h; ++i) {
            const bool counts = d[i] > 1e-12 * d[h - 1] && d[i] > 0;
            shrink[i] = counts ? 1 - 1 / std::sqrt(1 + d[i]) : 0;
            inverse_length[i] = counts ? 1 / std::sqrt(d[i]) : 0;
        }
        const Matrix v = f.transpose() * eigen.eigenvectors() * inverse_length.asDiagonal();
        Matrix reduced = full;
        const Matrix along = full * v * shrink.asDiagonal();
        dense::multiply(context, -1.0, along, dense::Op::none, v, dense::Op::transpose, 1.0,
                        reduced);
        RankOptions rank;
        rank.num_modes = r;
        LowRankBasis principal =
            principal_basis(reduced, reduced.rowwise().squaredNorm(), rank, context);
        storage->basis = std::move(principal.basis);
        result->eigenvalues = principal.eigenvalues;
    } else {
        storage->basis.resize(n, 0);
    }
    result->mean_displacement = mean;
    result->basis = {storage->basis.data(), n, storage->basis.cols()};
    result->pca_modes = {storage->pca_modes.data(), 3 * n, p};
    result->storage = storage;
    context.progress(Stage::basis, 1);
    return result;
}

}  // namespace mien
