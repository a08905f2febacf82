#include "expression/neutralize.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {

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
    const Eigen::MatrixXf half =
        (eigen.eigenvectors().rowwise().reverse().leftCols(rank) *
         values.head(rank).cwiseSqrt().asDiagonal())
            .cast<float>();
    const Index n = model.num_vertices();
    Vector deviation = Vector::Zero(n);
    parallel_for(context, static_cast<std::size_t>(n), 1024, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
        const Eigen::VectorXf squares =
            (model.expression_modes.map().middleRows(3 * first, 3 * size) * half)
                .rowwise()
                .squaredNorm();
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
                       const Vector& expression) {
    if ((identity.size() != 0 && identity.size() != model.num_identity_modes()) ||
        (expression.size() != 0 && expression.size() != model.num_expression_modes()))
        fail(Status::mismatch, "the model has %lld identity and %lld expression modes, not %lld and %lld",
             static_cast<long long>(model.num_identity_modes()),
             static_cast<long long>(model.num_expression_modes()),
             static_cast<long long>(identity.size()), static_cast<long long>(expression.size()));
    Points face = model.mean;
    Eigen::Map<Vector> flat(face.data(), face.size());
    if (identity.size() != 0) add_modes(context, model.identity_modes, identity, 1.0, flat);
    if (expression.size() != 0) add_modes(context, model.expression_modes, expression, 1.0, flat);
    return face;
}

NeutralizationResult neutralize(const Context& context, const ExpressionModel& model,
                                const PointsRef& vertices, const Vector& weights,
                                const NeutralizeOptions& options) {
    context.progress(Stage::neutralizing, 0.0);
    const FaceEvidence evidence = gather_evidence(context, model, vertices, weights);
    FitResult fit = fit_face(model, evidence, options.fit);

    NeutralizationResult result;
    const Index n = model.num_vertices();
    Vector moved = Vector::Zero(3 * n);
    add_modes(context, model.expression_modes, fit.expression, -1.0, moved);
    result.neutral_vertices = vertices + Eigen::Map<const Points>(moved.data(), n, 3);
    const Vector lengths = Eigen::Map<const Points>(moved.data(), n, 3).rowwise().norm();
    result.mean_displacement_mm = lengths.mean();
    result.max_displacement_mm = lengths.maxCoeff();
    if (options.uncertainty && fit.expression_covariance.size() != 0)
        result.uncertainty_mm = expression_uncertainty(context, model, fit.expression_covariance);

    // || v - mean - B c ||^2 in the weighted norm from the small matrices alone.
    double energy = 0.0, total = 0.0;
    for (Index i = 0; i < n; ++i) {
        const double weight = weights.size() != 0 ? weights[i] : 1.0;
        if (weight == 0.0) continue;
        energy += weight * (vertices.row(i) - model.mean.row(i)).squaredNorm();
        total += weight;
    }
    Vector coordinates(fit.identity.size() + fit.expression.size());
    coordinates << fit.identity, fit.expression;
    const Matrix& gram = evidence.gram.size() != 0 ? evidence.gram : model.gram;
    energy += coordinates.dot(gram * coordinates - 2.0 * evidence.projection);
    result.residual_rms_mm = total > 0.0 ? std::sqrt(std::max(0.0, energy) / total) : 0.0;

    result.identity = std::move(fit.identity);
    result.expression = std::move(fit.expression);
    result.component_probabilities = std::move(fit.component_probabilities);
    result.sweeps = fit.sweeps;
    result.converged = fit.converged;
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

}  // namespace mien
