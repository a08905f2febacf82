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

struct PosteriorStorage {
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

/// The model at the landmarks, every row divided by the landmark's noise.
struct SeenModel {
    Matrix basis;               ///< F, h x r
    Matrix modes[3];            ///< of x, y and z, h x p
    Matrix displacement;        ///< h x 3, less the mean
    Matrix covariance;          ///< C = I + F F' of what is seen, in units of the noise
    Eigen::LLT<Matrix> factor;  ///< of C
};

SeenModel look_at(const DeformationModel& model,
                  const std::vector<LandmarkObservation>& observations) {
    const Index h = static_cast<Index>(observations.size()), r = model.basis.cols,
                p = model.pca_modes.cols;
    const auto basis = model.basis.map();
    const auto modes = model.pca_modes.map();
    SeenModel seen;
    seen.basis.resize(h, r);
    seen.displacement.resize(h, 3);
    for (Matrix& matrix : seen.modes) matrix.resize(h, p);
    for (Index i = 0; i < h; ++i) {
        const LandmarkObservation& o = observations[static_cast<std::size_t>(i)];
        const Index v = static_cast<Index>(o.vertex);
        if (r > 0) seen.basis.row(i) = basis.row(v).cast<double>() / o.noise_mm;
        seen.displacement.row(i) = o.displacement_mm.transpose() / o.noise_mm;
        if (model.mean_displacement.rows() != 0)
            seen.displacement.row(i) -= model.mean_displacement.row(v) / o.noise_mm;
        for (int c = 0; p > 0 && c < 3; ++c)  // a model without vector modes has no row of them
            seen.modes[c].row(i) = modes.row(3 * v + c).cast<double>() / o.noise_mm;
    }
    seen.covariance = Matrix::Identity(h, h) + seen.basis * seen.basis.transpose();
    seen.factor.compute(seen.covariance);
    if (seen.factor.info() != Eigen::Success)
        fail(Status::no_solution, "the landmarks' covariance is not positive definite");
    return seen;
}

/// Symmetric square root of a positive definite matrix.
Matrix square_root(const Matrix& matrix) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the posterior covariance of the vector modes did not converge");
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
           solver.eigenvectors().transpose();
}

/// Marginal posterior of the vector modes' coefficients c ~ N(mean, root root').
struct VectorPosterior {
    Vector mean;
    Matrix root;
};

VectorPosterior vector_posterior(const SeenModel& seen) {
    const Index p = seen.modes[0].cols();
    if (p == 0) return {Vector(), Matrix()};
    Matrix precision = Matrix::Identity(p, p);
    Vector right = Vector::Zero(p);
    for (int c = 0; c < 3; ++c) {
        const Matrix solved = seen.factor.solve(seen.modes[c]);
        precision += seen.modes[c].transpose() * solved;
        right += solved.transpose() * seen.displacement.col(c);
    }
    const Eigen::LLT<Matrix> factor(precision);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the vector modes' precision is not positive definite");
    const Matrix covariance = factor.solve(Matrix::Identity(p, p));
    return {covariance * right, square_root(covariance)};
}

/// Phi S^1/2 with S = (I + F'F)^-1 and without any r x r eigenproblem: F'F has the eigenvalues
/// that C = I + F F' has above 1, and S^1/2 shrinks their directions alone.
Matrix shrunk_basis(const SeenModel& seen, const Matrix& full, const Context& context) {
    const Index h = seen.covariance.rows();
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(seen.covariance);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the landmarks' covariance did not converge");
    // Eigenvalues are 1 + D; directions with D = 0 lie outside the basis' reach.
    const Vector d = (eigen.eigenvalues().array() - 1).max(0.0);
    Vector shrink(h), inverse_length(h);
    for (Index i = 0; i < h; ++i) {
        const bool counts = d[i] > 1e-12 * d[h - 1] && d[i] > 0;
        shrink[i] = counts ? 1 - 1 / std::sqrt(1 + d[i]) : 0;
        inverse_length[i] = counts ? 1 / std::sqrt(d[i]) : 0;
    }
    const Matrix v = seen.basis.transpose() * eigen.eigenvectors() * inverse_length.asDiagonal();
    Matrix reduced = full;
    const Matrix along = full * v * shrink.asDiagonal();
    dense::multiply(context, -1.0, along, dense::Op::none, v, dense::Op::transpose, 1.0, reduced);
    return reduced;
}

}  // namespace

std::shared_ptr<const DeformationModel> condition_model(
    const DeformationModel& model, const std::vector<LandmarkObservation>& observations,
    const Context& context) {
    check(model, observations);
    const Index n = model.num_vertices(), r = model.basis.cols, p = model.pca_modes.cols;
    context.require_memory(
        static_cast<std::size_t>(n) * static_cast<std::size_t>(2 * r + 3 * p) * 12,
        "a posterior model");
    context.progress(Stage::basis, 0);
    const SeenModel seen = look_at(model, observations);
    // Vector modes first; what they leave of the landmarks is the kernel's.
    const VectorPosterior c_posterior = vector_posterior(seen);
    Matrix rest = seen.displacement;
    if (p != 0)
        for (int c = 0; c < 3; ++c) rest.col(c) -= seen.modes[c] * c_posterior.mean;
    const Matrix a_mean = seen.basis.transpose() * seen.factor.solve(rest);

    auto storage = std::make_shared<PosteriorStorage>();
    auto result = std::make_shared<DeformationModel>();
    result->template_mesh = model.template_mesh;
    result->landmarks = model.landmarks;
    result->zones = model.zones;
    result->info = model.info;
    result->info.erase(kLeftOutInfo);  // of what the landmarks now tell
    result->info["posterior_landmarks"] = std::to_string(observations.size());
    const Matrix full = model.basis.map().cast<double>();
    Points mean =
        model.mean_displacement.rows() != 0 ? model.mean_displacement : Points::Zero(n, 3);
    mean += full * a_mean;
    storage->pca_modes.resize(3 * n, p);
    if (p != 0) {
        const auto modes = model.pca_modes.map();
        for (int c = 0; c < 3; ++c) {
            const Matrix bend =
                full * (seen.basis.transpose() * seen.factor.solve(seen.modes[c]));  // Phi B
            Matrix own(n, p);
            for (Index v = 0; v < n; ++v) own.row(v) = modes.row(3 * v + c).cast<double>();
            mean.col(c) += own * c_posterior.mean;
            own = ((own - bend) * c_posterior.root).eval();
            for (Index v = 0; v < n; ++v)
                storage->pca_modes.row(3 * v + c) = own.row(v).cast<float>();
        }
    }
    context.progress(Stage::basis, 0.3);
    if (r != 0) {
        const Matrix reduced = shrunk_basis(seen, full, context);
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
