#include "expression/neutralize.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "expression/joint_fit.hpp"

namespace mien {
namespace {

/// out += [P Q] along; a half that is all zero costs nothing.
void add_coordinates(const Context& context, const ExpressionModel& model, const Vector& along,
                     Eigen::Ref<Vector> out) {
    const Vector a = along.head(model.num_identity_modes()),
                 b = along.tail(model.num_expression_modes());
    if (!a.isZero(0.0)) add_modes(context, model.identity_modes, a, out);
    if (!b.isZero(0.0)) add_modes(context, model.expression_modes, b, out);
}

constexpr double kMuchUnseen =
    0.4;  ///< share of a face above which a result says that it was not seen

constexpr double kMuchDoubtMm = 0.3;  ///< root mean square of what may be left of an expression

/// Columns whose outer products sum to the covariance; directions below 1e-6 of it are not worth
/// their products.
Matrix root_of(const Matrix& covariance) {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(covariance);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the posterior covariance of the face's coordinates is damaged");
    const Vector values = eigen.eigenvalues().reverse().cwiseMax(0.0);
    const double total = values.sum();
    Index rank = 0;
    for (double held = 0.0; rank < values.size() && held < (1.0 - 1e-6) * total; ++rank)
        held += values[rank];
    return eigen.eigenvectors().rowwise().reverse().leftCols(rank) *
           values.head(rank).cwiseSqrt().asDiagonal();
}

/// Sum over the columns of [P Q] (along_p, along_q) of their squared lengths per vertex; an empty
/// part is zero.
Vector squared_lengths(const Context& context, const ExpressionModel& model, const Matrix& along_p,
                       const Matrix& along_q) {
    const Eigen::MatrixXf p = along_p.cast<float>(), q = along_q.cast<float>();
    const Index n = model.num_vertices();
    Vector squares = Vector::Zero(n);
    parallel_for(
        context, static_cast<std::size_t>(n), 1024, [&](std::size_t begin, std::size_t end) {
            const Index first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
            Eigen::MatrixXf rows = Eigen::MatrixXf::Zero(3 * size, std::max(p.cols(), q.cols()));
            if (p.size() != 0)
                rows.noalias() += model.identity_modes.map().middleRows(3 * first, 3 * size) * p;
            if (q.size() != 0)
                rows.noalias() += model.expression_modes.map().middleRows(3 * first, 3 * size) * q;
            const Eigen::VectorXf sums = rows.rowwise().squaredNorm();
            for (Index i = 0; i < size; ++i)
                squares[first + i] = static_cast<double>(sums.segment<3>(3 * i).sum());
        });
    return squares;
}

/// What is not known of the neutral face: of a vertex that was seen the expression that was taken
/// off it, of one that was not seen the person, and what no model knows of a new person.
Vector deviation_per_vertex(const Context& context, const ExpressionModel& model,
                            const Matrix& covariance, const Vector& weights) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    const Matrix expression = root_of(covariance.bottomRightCorner(q, q));
    Vector squares = squared_lengths(
        context, model,
        model.spill.empty() ? Matrix() : Matrix(model.spill.expression * expression), expression);
    if (weights.size() != 0 && (weights.array() == 0.0).any()) {
        const Matrix identity = root_of(covariance.topLeftCorner(p, p));
        const Vector unseen = squared_lengths(
            context, model, identity,
            model.spill.empty() ? Matrix() : Matrix(model.spill.identity * identity));
        const double rest = model.expected_residual_mm * model.expected_residual_mm;
        for (Index i = 0; i < squares.size(); ++i)
            if (weights[i] == 0.0) squares[i] = unseen[i] + rest;
    }
    return squares.cwiseSqrt();
}

}  // namespace

std::vector<std::string> neutralization_warnings(const ExpressionModel& model,
                                                 const NeutralizationResult& result) {
    std::vector<std::string> warnings;
    if (model.expected_residual_mm > 0.0 &&
        result.residual_rms_mm > 1.5 * model.expected_residual_mm)
        warnings.push_back(
            "the face lies farther from the model than faces of new people do: it was fitted "
            "badly, or is "
            "unlike the training faces");
    if (!result.component_probabilities.empty() && !model.components.empty() &&
        model.components.back().name == "any" && result.component_probabilities.back() > 0.5)
        warnings.push_back("the expression is none of the trained ones");
    char text[160];
    if (result.rms_uncertainty_mm > std::max(kMuchDoubtMm, result.rms_displacement_mm)) {
        std::snprintf(
            text, sizeof text,
            "it is not certain that the face is neutral now: some %.2f mm (root mean square) of an "
            "expression may be left on it",
            result.rms_uncertainty_mm);
        warnings.push_back(text);
    }
    if (result.unseen_share > kMuchUnseen) {
        std::snprintf(text, sizeof text,
                      "%.0f %% of the face's vertices had no data: their neutral places are the "
                      "model's guess",
                      100.0 * result.unseen_share);
        warnings.push_back(text);
    }
    if (!result.converged) warnings.push_back("the alternating fit has not converged");
    return warnings;
}

void check_topology(const ExpressionModel& model, Index num_vertices,
                    const TrianglesRef& triangles) {
    if (num_vertices != model.num_vertices())
        fail(Status::mismatch, "the face has %lld vertices, the expression model %lld",
             static_cast<long long>(num_vertices), static_cast<long long>(model.num_vertices()));
    if (triangles.rows() == 0 || model.triangles.rows() == 0) return;
    if (triangles.rows() != model.triangles.rows() || triangles != model.triangles)
        fail(
            Status::mismatch,
            "the face has the model's %lld vertices but other triangles: it is in another topology",
            static_cast<long long>(num_vertices));
}

Points synthesize_face(const Context& context, const ExpressionModel& model, const Vector& identity,
                       const Vector& expression, FitMethod method) {
    if ((identity.size() != 0 && identity.size() != model.num_identity_modes()) ||
        (expression.size() != 0 && expression.size() != model.num_expression_modes()))
        fail(Status::mismatch,
             "the model has %lld identity and %lld expression modes, not %lld and %lld",
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
    JointFitOptions single;
    single.fit = options.fit;
    single.pose = options.pose;
    single.noise = JointNoise::isotropic;
    single.treated = options.treated;
    PlacedFit placed =
        std::move(fit_faces(context, model, {{vertices, weights}}, single).alone.front());
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
        result.unseen_share =
            static_cast<double>((weights.array() == 0.0).count()) / static_cast<double>(n);
        // Where there was nothing to see, not even a finite place, the model's own face stands in.
        Points own;
        for (Index i = 0; i < n; ++i) {
            if (weights[i] != 0.0 || vertices.row(i).allFinite()) continue;
            if (own.rows() == 0)
                own = result.pose.apply(PointsRef(
                    synthesize_face(context, model, fit.identity, Vector(), options.fit.method)));
            result.neutral_vertices.row(i) = own.row(i);
        }
    }
    const Vector lengths = displacement.rowwise().norm();
    result.mean_displacement_mm = lengths.mean();
    result.max_displacement_mm = lengths.maxCoeff();
    result.rms_displacement_mm = std::sqrt(lengths.squaredNorm() / static_cast<double>(n));
    if (fit.covariance.size() != 0) {
        const Index q = model.num_expression_modes();
        const double variance =
            fit.covariance.bottomRightCorner(q, q).cwiseProduct(model.plan->expression_gram).sum();
        result.rms_uncertainty_mm = std::sqrt(std::max(0.0, variance) / static_cast<double>(n));
        if (options.uncertainty)
            result.uncertainty_mm = deviation_per_vertex(context, model, fit.covariance, weights);
    }

    result.residual_rms_mm = placed.residual_rms_mm;
    result.noise_mm2 = placed.noise_mm2;
    result.doubted_share = placed.doubted_share;
    result.identity = std::move(fit.identity);
    result.expression = std::move(fit.expression);
    result.component_probabilities = std::move(fit.component_probabilities);
    result.intensity = fit.intensity;
    result.sweeps = fit.sweeps;
    result.converged = fit.converged;
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

}  // namespace mien
