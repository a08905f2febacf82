#include "registration/solver.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "registration/fit_system.hpp"

namespace mien {
namespace {

constexpr double kNothing = 1e-30;  // a right-hand side of zeros has nothing to reduce

// The small motion about `centre` that the last unknowns of `theta` say: turn, shift, growth.
Similarity small_motion(const Eigen::VectorXd& g, const Vector3& centre, double radius) {
    Similarity motion;
    const Vector3 w = g.head<3>() / radius;
    motion.scale = g.size() == 7 ? std::exp(g[6] / radius) : 1.0;
    if (w.norm() > 0)
        motion.rotation = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
    motion.translation = centre + g.segment<3>(3) - motion.scale * (motion.rotation * centre);
    return motion;
}

}  // namespace

FitSolver::FitSolver(const DeformationModel& model)
    : model_(model), num_rows_(model.num_vertices()) {}

FitSolver::ConstMap FitSolver::basis() const {
    if (rows_.empty())
        return ConstMap(model_.basis.data, num_rows_, model_.basis.cols,
                        Eigen::OuterStride<>(num_rows_));
    return ConstMap(packed_basis_.data(), num_rows_, packed_basis_.cols(),
                    Eigen::OuterStride<>(num_rows_));
}

FitSolver::ConstMap FitSolver::pca() const {
    if (rows_.empty())
        return ConstMap(model_.pca_modes.data, 3 * num_rows_, model_.pca_modes.cols,
                        Eigen::OuterStride<>(3 * num_rows_));
    return ConstMap(packed_pca_.data(), 3 * num_rows_, packed_pca_.cols(),
                    Eigen::OuterStride<>(3 * num_rows_));
}

void FitSolver::use_rows(std::vector<Index> rows, Index scalar_modes, Index pca_modes,
                         const Context& context) {
    // The cached Phi' W Phi stays: of other rows it preconditions as well, once scaled by weight.
    rows_ = std::move(rows);
    num_rows_ = rows_.empty() ? model_.num_vertices() : static_cast<Index>(rows_.size());
    if (rows_.empty()) {
        packed_basis_.resize(0, 0);
        packed_pca_.resize(0, 0);
        return;
    }
    context.require_memory(static_cast<std::size_t>(num_rows_ * (scalar_modes + 3 * pca_modes)) * 4,
                           "the fit");
    packed_basis_.resize(num_rows_, scalar_modes);
    packed_pca_.resize(3 * num_rows_, pca_modes);
    const Index n = model_.num_vertices();
    parallel_for(
        context, static_cast<std::size_t>(scalar_modes + pca_modes), 8,
        [&](std::size_t b, std::size_t e) {
            for (Index j = static_cast<Index>(b); j < static_cast<Index>(e); ++j)
                for (Index k = 0; k < num_rows_; ++k) {
                    const Index i = rows_[static_cast<std::size_t>(k)];
                    if (j < scalar_modes)
                        packed_basis_(k, j) = model_.basis.data[j * n + i];
                    else
                        for (int axis = 0; axis < 3; ++axis)
                            packed_pca_(3 * k + axis, j - scalar_modes) =
                                model_.pca_modes.data[(j - scalar_modes) * 3 * n + 3 * i + axis];
                }
        });
}

Similarity FitSolver::step(const FitTerms& terms, const PointsRef& current,
                           const FitStepOptions& options, FitCoefficients& coefficients,
                           const Context& context) {
    const FitLayout layout{std::min(options.scalar_modes, coefficients.kernel.rows()),
                           std::min(options.pca_modes, coefficients.pca.size()),
                           options.move ? (options.scale ? 7 : 6) : 0};
    const Index r = layout.r, p = layout.p;
    Similarity motion;
    if (layout.size() == 0) return motion;
    FitSystem system(basis(), pca(), model_.prior_variance, cache_, terms, current, options, layout,
                     context);

    Eigen::VectorXf theta = Eigen::VectorXf::Zero(layout.size());
    for (int axis = 0; axis < 3; ++axis)
        theta.segment(axis * r, r) = coefficients.kernel.col(axis).head(r);
    theta.segment(3 * r, p) = coefficients.pca.head(p);

    Eigen::VectorXf rhs, residual, z, direction, image;
    system.load_pull();
    system.project(rhs);
    system.add_expected(rhs);
    system.apply(theta, image);
    residual = rhs - image;
    system.precondition(rhs, z);
    const double whole = rhs.cast<double>().dot(z.cast<double>());
    system.precondition(residual, z);
    direction = z;
    double rz = residual.cast<double>().dot(z.cast<double>());
    // Relative to where this step began, but not below what single precision can tell apart.
    const double limit = std::max({options.tolerance * options.tolerance * rz,
                                   options.solver.single_precision * whole, kNothing});
    iterations_ = 0;
    while (iterations_ < options.solver.most_iterations && rz > limit) {
        system.apply(direction, image);
        const double curvature = direction.cast<double>().dot(image.cast<double>());
        if (!(curvature > 0)) break;
        const float step_length = static_cast<float>(rz / curvature);
        theta += step_length * direction;
        residual -= step_length * image;
        system.precondition(residual, z);
        const double next = residual.cast<double>().dot(z.cast<double>());
        direction = z + static_cast<float>(next / rz) * direction;
        rz = next;
        ++iterations_;
    }
    if (!theta.allFinite())
        fail(Status::no_solution, "the fit's equations gave values that are not finite");

    for (int axis = 0; axis < 3; ++axis)
        coefficients.kernel.col(axis).head(r) = theta.segment(axis * r, r);
    coefficients.pca.head(p) = theta.segment(3 * r, p);
    if (layout.g > 0)
        motion =
            small_motion(theta.tail(layout.g).cast<double>(), system.centre(), system.radius());
    return motion;
}

Points FitSolver::displacement(const FitCoefficients& coefficients, const Context& context) const {
    const Index n = model_.num_vertices(), r = coefficients.kernel.rows(),
                p = coefficients.pca.size();
    Points u = model_.mean_displacement.rows() == n ? model_.mean_displacement : Points::Zero(n, 3);
    if (r > 0) {
        dense::Field moved = dense::Field::Zero(n, 3);
        dense::add_thin_product(context, model_.basis.map().leftCols(r), coefficients.kernel,
                                moved);
        u += moved.cast<double>();
    }
    if (p > 0) {
        dense::add_product(context, model_.pca_modes.map().leftCols(p),
                           coefficients.pca.cast<double>(), Eigen::Map<Vector>(u.data(), 3 * n));
    }
    return u;
}

}  // namespace mien
