#include "model/known_fit.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "geometry/alignment.hpp"

namespace mien {
namespace {

constexpr double kDamping = 1e-12;  ///< of the largest diagonal entry

Index chosen_modes(Index asked, Index available, const char* what) {
    if (asked < -1)
        fail(Status::invalid_argument, "%lld %s modes; give -1 for all, or a number from 0 on",
             static_cast<long long>(asked), what);
    return asked < 0 ? available : std::min(asked, available);
}

void check(const DeformationModel& model, const PointsRef& target, const KnownFitOptions& options) {
    if (target.rows() < 1 || target.rows() > model.num_vertices())
        fail(Status::mismatch,
             "the target has %lld vertices, the model's template %lld; a fit with known "
             "correspondence needs the template's, or its first ones",
             static_cast<long long>(target.rows()), static_cast<long long>(model.num_vertices()));
    for (Index v = 0; v < target.rows(); ++v)
        if (!target.row(v).allFinite())
            fail_at(Status::invalid_mesh, v, "vertex %lld of the target is not finite",
                    static_cast<long long>(v));
    if (!(options.ridge_mm2 >= 0) || !std::isfinite(options.ridge_mm2))
        fail(Status::invalid_argument, "ridge %g mm^2 must be a number >= 0", options.ridge_mm2);
    const Vector& weights = options.weights;
    if (weights.size() == 0) return;
    if (weights.size() != target.rows())
        fail(Status::mismatch, "%lld weights for a target of %lld vertices",
             static_cast<long long>(weights.size()), static_cast<long long>(target.rows()));
    for (Index v = 0; v < weights.size(); ++v)
        if (!(weights[v] >= 0) || !std::isfinite(weights[v]))
            fail_at(Status::invalid_argument, v, "weight %g of vertex %lld must be a number >= 0",
                    weights[v], static_cast<long long>(v));
    if (weights.maxCoeff() <= 0) fail(Status::invalid_argument, "all weights are zero");
}

/// Factors A' W^2 A + ridge, and says what to do when it cannot be.
void factor(Matrix& system) {
    system.diagonal().array() += kDamping * std::max(system.diagonal().maxCoeff(), 1e-300);
    if (!dense::factor_spd(system))
        fail(Status::no_solution,
             "the fit with known correspondence has no unique solution; give a larger ridge");
}

/// The displacements that the target asks for, beyond the model's mean.
Points asked_displacement(const DeformationModel& model, const PointsRef& target,
                          const KnownFitOptions& options, Similarity& motion) {
    const Index n = target.rows();
    Points mean = model.template_mesh.vertices.topRows(n);
    if (model.mean_displacement.rows() != 0) mean += model.mean_displacement.topRows(n);
    if (!options.align) return target - mean;
    const Vector squared = options.weights.array().square().matrix();
    motion = align_points(target, mean, squared, false);
    return motion.apply(target) - mean;
}

}  // namespace

KnownFit fit_known(const DeformationModel& model, const PointsRef& target,
                   const KnownFitOptions& options, const Context& context) {
    check(model, target, options);
    const Index n = target.rows();
    const Index r = chosen_modes(options.num_scalar_modes, model.basis.cols, "scalar");
    const Index p = chosen_modes(options.num_vector_modes, model.pca_modes.cols, "vector");
    context.require_memory(static_cast<std::size_t>(n) * static_cast<std::size_t>(r + 6 * p) * 8 +
                               static_cast<std::size_t>(r * r * 2 + 3 * r * p + p * p) * 8,
                           "the fit with known correspondence");
    KnownFit fit;
    const Points y = asked_displacement(model, target, options, fit.target_motion);
    const Vector weights =
        options.weights.size() != 0 ? Vector(options.weights.array().square()) : Vector::Ones(n);
    const Points weighted = (y.array().colwise() * weights.array()).matrix();
    const double rho = options.ridge_mm2;

    // The kernel's block, its right sides, and what couples it with the vector modes.
    const Matrix basis = model.basis.map().topLeftCorner(n, r).cast<double>();
    Matrix gram = Matrix::Zero(r, r), right = Matrix::Zero(r, 3);
    if (r > 0) {
        dense::weighted_gram(context, basis, weights, gram);
        dense::multiply(context, 1.0, basis, dense::Op::transpose, Matrix(weighted),
                        dense::Op::none, 0.0, right);
    }
    const Matrix modes = model.pca_modes.map().topLeftCorner(3 * n, p).cast<double>();
    Matrix schur = Matrix::Zero(p, p);
    Vector vector_right = Vector::Zero(p);
    if (p > 0) {
        Vector per_coordinate(3 * n);
        for (Index v = 0; v < n; ++v) per_coordinate.segment(3 * v, 3).setConstant(weights[v]);
        dense::weighted_gram(context, modes, per_coordinate, schur);
        schur.diagonal().array() += rho;
        // Row-major points run x0 y0 z0 x1 ..., as the rows of the modes do.
        vector_right = modes.transpose() * Eigen::Map<const Vector>(weighted.data(), 3 * n);
    }
    std::vector<Matrix> factors, coupling;
    for (int c = 0; c < 3; ++c) {
        if (c == 0 || model.prior_variance.rows() != 0) {
            Matrix system = gram;
            for (Index j = 0; j < r; ++j)
                system(j, j) += model.prior_variance.rows() != 0
                                    ? rho / std::max(model.prior_variance(j, c), 1e-12)
                                    : rho;
            if (r > 0) factor(system);
            factors.push_back(std::move(system));
        }
        Matrix cross = Matrix::Zero(r, p);
        if (r > 0 && p > 0) {
            Matrix axis(n, p);
            for (Index v = 0; v < n; ++v) axis.row(v) = weights[v] * modes.row(3 * v + c);
            dense::multiply(context, 1.0, basis, dense::Op::transpose, axis, dense::Op::none, 0.0,
                            cross);
            Matrix solved = cross;
            dense::solve_factored(factors.back(), solved);
            schur.noalias() -= cross.transpose() * solved;
            vector_right.noalias() -= solved.transpose() * right.col(c);
        }
        coupling.push_back(std::move(cross));
    }
    Matrix pca = vector_right;
    if (p > 0) {
        factor(schur);
        dense::solve_factored(schur, pca);
    }
    fit.coefficients.pca = pca;
    fit.coefficients.kernel.resize(r, 3);
    for (int c = 0; c < 3 && r > 0; ++c) {
        Matrix side = right.col(c);
        if (p > 0) side -= coupling[static_cast<std::size_t>(c)] * pca;
        dense::solve_factored(
            factors[std::min<std::size_t>(static_cast<std::size_t>(c), factors.size() - 1)], side);
        fit.coefficients.kernel.col(c) = side;
    }
    const Points made = displacement(model, fit.coefficients, context).topRows(n);
    Points mean = Points::Zero(n, 3);
    if (model.mean_displacement.rows() != 0) mean = model.mean_displacement.topRows(n);
    const Vector squared = (y - (made - mean)).rowwise().squaredNorm();
    fit.residual_rms_mm = std::sqrt(squared.dot(weights) / weights.sum());
    return fit;
}

}  // namespace mien
