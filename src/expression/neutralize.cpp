#include "expression/neutralize.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "expression/placed_fit.hpp"

namespace mien {
namespace {

/// out += [P Q] along; a half that is all zero costs nothing.
void add_coordinates(const Context& context, const ExpressionModel& model, const Vector& along,
                     Eigen::Ref<Vector> out) {
    const Vector a = along.head(model.num_identity_modes()), b = along.tail(model.num_expression_modes());
    if (!a.isZero(0.0)) add_modes(context, model.identity_modes, a, 1.0, out);
    if (!b.isZero(0.0)) add_modes(context, model.expression_modes, b, 1.0, out);
}

}  // namespace

Vector expression_uncertainty(const Context& context, const ExpressionModel& model,
                              const Matrix& covariance) {
    // A few directions carry the posterior; the rest below 1e-6 of it is not worth its products.
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(covariance);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the posterior covariance of the expression is damaged");
    const Vector values = eigen.eigenvalues().reverse().cwiseMax(0.0);
    const double total = values.sum();
    Index rank = 0;
    for (double held = 0.0; rank < values.size() && held < (1.0 - 1e-6) * total; ++rank)
        held += values[rank];
    const Matrix root = eigen.eigenvectors().rowwise().reverse().leftCols(rank) *
                        values.head(rank).cwiseSqrt().asDiagonal();
    const Eigen::MatrixXf half = root.cast<float>();
    Eigen::MatrixXf spilled;
    if (!model.spill.empty()) spilled = (model.spill.expression * root).cast<float>();
    const Index n = model.num_vertices();
    Vector deviation = Vector::Zero(n);
    parallel_for(context, static_cast<std::size_t>(n), 1024, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
        Eigen::MatrixXf rows = model.expression_modes.map().middleRows(3 * first, 3 * size) * half;
        if (spilled.size() != 0)
            rows.noalias() += model.identity_modes.map().middleRows(3 * first, 3 * size) * spilled;
        const Eigen::VectorXf squares = rows.rowwise().squaredNorm();
        for (Index i = 0; i < size; ++i)
            deviation[first + i] =
                std::sqrt(static_cast<double>(squares.segment<3>(3 * i).sum()));
    });
    return deviation;
}

void check_topology(const ExpressionModel& model, Index num_vertices, const TrianglesRef& triangles) {
    if (num_vertices != model.num_vertices())
        fail(Status::mismatch, "the face has %lld vertices, the expression model %lld",
             static_cast<long long>(num_vertices), static_cast<long long>(model.num_vertices()));
    if (triangles.rows() == 0 || model.triangles.rows() == 0) return;
    if (triangles.rows() != model.triangles.rows() || triangles != model.triangles)
        fail(Status::mismatch,
             "the face has the model's %lld vertices but other triangles: it is in another topology",
             static_cast<long long>(num_vertices));
}

Points synthesize_face(const Context& context, const ExpressionModel& model, const Vector& identity,
                       const Vector& expression, FitMethod method) {
    if ((identity.size() != 0 && identity.size() != model.num_identity_modes()) ||
        (expression.size() != 0 && expression.size() != model.num_expression_modes()))
        fail(Status::mismatch, "the model has %lld identity and %lld expression modes, not %lld and %lld",
             static_cast<long long>(model.num_identity_modes()),
             static_cast<long long>(model.num_expression_modes()),
             static_cast<long long>(identity.size()), static_cast<long long>(expression.size()));
    Points face = model.mean;
    Eigen::Map<Vector> flat(face.data(), face.size());
    add_coordinates(context, model, mode_coordinates(model, method, identity, expression), flat);
    return face;
}

Vector expression_displacement(const Context& context, const ExpressionModel& model,
                               const Vector& expression, FitMethod method) {
    Vector moved = Vector::Zero(3 * model.num_vertices());
    add_coordinates(context, model, mode_coordinates(model, method, Vector(), expression), moved);
    return moved;
}

NeutralizationResult neutralize(const Context& context, const ExpressionModel& model,
                                const PointsRef& vertices, const Vector& weights,
                                const NeutralizeOptions& options) {
    context.progress(Stage::neutralizing, 0.0);
    const Index n = model.num_vertices();
    check_face(model, vertices, weights);
    PlacedFit placed = place_and_fit(context, model, vertices, weights, options.fit, options.pose);
    FitResult& fit = placed.fit;
    const Similarity& to_model = placed.to_model;

    NeutralizationResult result;
    Vector moved = -expression_displacement(context, model, fit.expression, options.fit.method);
    Eigen::Map<Points> displacement(moved.data(), n, 3);
    if (to_model.rotation != Matrix3::Identity())
        displacement = (displacement * to_model.rotation).eval();  // rows: R' d
    result.pose = to_model.inverse();
    result.neutral_vertices = vertices + displacement;
    if (weights.size() != 0) {
        // Where there was nothing to see, not even a finite place, the model's own face stands in.
        Points own;
        for (Index i = 0; i < n; ++i) {
            if (weights[i] != 0.0 || vertices.row(i).allFinite()) continue;
            if (own.rows() == 0)
                own = result.pose.apply(
                    PointsRef(synthesize_face(context, model, fit.identity, Vector(), options.fit.method)));
            result.neutral_vertices.row(i) = own.row(i);
        }
    }
    const Vector lengths = displacement.rowwise().norm();
    result.mean_displacement_mm = lengths.mean();
    result.max_displacement_mm = lengths.maxCoeff();
    if (options.uncertainty && fit.expression_covariance.size() != 0)
        result.uncertainty_mm = expression_uncertainty(context, model, fit.expression_covariance);

    result.residual_rms_mm = placed.residual_rms_mm;
    result.noise_mm2 = placed.noise_mm2;
    result.doubted_share = placed.doubted_share;
    result.identity = std::move(fit.identity);
    result.expression = std::move(fit.expression);
    result.component_probabilities = std::move(fit.component_probabilities);
    result.sweeps = fit.sweeps;
    result.converged = fit.converged;
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

}  // namespace mien
