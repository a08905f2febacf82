#include "expression/neutralize.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/alignment.hpp"

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

namespace {

constexpr int kPoseRounds = 8;
constexpr double kMaxNoiseFactor = 100.0;  ///< for faces that were measured worse than the training's

Similarity align_weighted(const PointsRef& from, const PointsRef& to, const Vector& weights) {
    if (weights.size() == 0) return align_points(from, to, weights, false);
    // Rows of weight zero may hold anything, which a product with zero would not silence.
    Points seen = from;
    for (Index i = 0; i < weights.size(); ++i)
        if (weights[i] == 0.0) seen.row(i) = to.row(i);
    return align_points(seen, to, weights, false);
}

Similarity align_stable(const ExpressionModel& model, const PointsRef& vertices) {
    const Index count = static_cast<Index>(model.stable_vertices.size());
    Points from(count, 3), to(count, 3);
    for (Index k = 0; k < count; ++k) {
        from.row(k) = vertices.row(model.stable_vertices[static_cast<std::size_t>(k)]);
        to.row(k) = model.mean.row(model.stable_vertices[static_cast<std::size_t>(k)]);
    }
    return align_points(from, to, Vector(), false);
}

bool is_far(const Similarity& motion, const PointsRef& mean) {
    const double cosine = std::min(1.0, std::max(-1.0, 0.5 * (motion.rotation.trace() - 1.0)));
    const Vector3 centre = mean.colwise().mean();
    return std::acos(cosine) > 3.0 * 3.14159265358979 / 180.0 ||
           (motion.apply(centre) - centre).norm() > 8.0;
}

bool identity_motion(const Similarity& motion) {
    return motion.rotation == Matrix3::Identity() && motion.translation == Vector3::Zero();
}

/// A face placed in the training's frame, taken apart.
struct PlacedFit {
    Similarity to_model;
    FitResult fit;
    double residual_rms_mm = 0;  ///< distance of the face from the fitted model per vertex
    double noise_mm2 = 0;        ///< of the fit; 0 for fits without a prior
};

/// || v - mean - B c || per vertex from the small matrices alone.
double residual_of(const ExpressionModel& model, FitMethod method, const FitResult& fit,
                   const Matrix& gram, const Vector& projection, double energy, double total) {
    const Vector coordinates = mode_coordinates(model, method, fit.identity, fit.expression);
    const double rest = energy + coordinates.dot(gram * coordinates - 2.0 * projection);
    return total > 0.0 ? std::sqrt(std::max(0.0, rest) / total) : 0.0;
}

PlacedFit fit_placed(const Context& context, const ExpressionModel& model, const PointsRef& vertices,
                     const Vector& weights, const FitOptions& options, const Similarity& to_model) {
    PlacedFit placed;
    placed.to_model = to_model;
    const Points moved = identity_motion(to_model) ? Points(vertices) : to_model.apply(vertices);
    const FaceEvidence evidence = gather_evidence(context, model, moved, weights);
    placed.fit = fit_face(model, evidence, options);

    double energy = 0.0, total = 0.0;
    for (Index i = 0; i < model.num_vertices(); ++i) {
        const double weight = weights.size() != 0 ? weights[i] : 1.0;
        if (weight == 0.0) continue;
        energy += weight * (moved.row(i) - model.mean.row(i)).squaredNorm();
        total += weight;
    }
    const Matrix& gram = evidence.gram.size() != 0 ? evidence.gram : model.gram;
    placed.residual_rms_mm = residual_of(model, options.method, placed.fit, gram, evidence.projection,
                                         energy, total);
    if (options.method != FitMethod::mixture && options.method != FitMethod::map) return placed;

    placed.noise_mm2 = options.noise_mm2 > 0.0 ? options.noise_mm2
                       : options.method == FitMethod::mixture ? model.mixture_noise_mm2
                                                              : model.map_noise_mm2;
    const double excess = model.expected_residual_mm > 0.0
                              ? placed.residual_rms_mm / model.expected_residual_mm
                              : 0.0;
    if (options.noise_mm2 > 0.0 || excess <= 1.0) return placed;
    // A face that was measured worse than the training faces: trust it less, or its errors become an
    // expression. The modes absorb the larger part of a smooth error, so that the noise has to grow
    // faster than the square of the part that is left to see.
    FitOptions careful = options;
    careful.noise_mm2 = placed.noise_mm2 * std::min(kMaxNoiseFactor, excess * excess * excess * excess);
    placed.fit = fit_face(model, evidence, careful);
    placed.noise_mm2 = careful.noise_mm2;
    placed.residual_rms_mm = residual_of(model, options.method, placed.fit, gram, evidence.projection,
                                         energy, total);
    return placed;
}

/// Fit and pose in turns: the pose is that of what the model made of the face, so that an open mouth
/// turns no head.
PlacedFit fit_rigid(const Context& context, const ExpressionModel& model, const PointsRef& vertices,
                    const Vector& weights, const FitOptions& options, const Similarity& start) {
    PlacedFit placed = fit_placed(context, model, vertices, weights, options, start);
    for (int round = 0; round < kPoseRounds; ++round) {
        const Points made =
            synthesize_face(context, model, placed.fit.identity, placed.fit.expression, options.method);
        const Similarity next = align_weighted(vertices, made, weights);
        const double turned = (next.rotation - placed.to_model.rotation).norm() * 100.0 +
                              (next.translation - placed.to_model.translation).norm();
        placed = fit_placed(context, model, vertices, weights, options, next);
        if (turned < 1e-3) break;
    }
    return placed;
}

PlacedFit place_and_fit(const Context& context, const ExpressionModel& model,
                        const PointsRef& vertices, const Vector& weights,
                        const NeutralizeOptions& options) {
    if (options.pose == Pose::keep)
        return fit_placed(context, model, vertices, weights, options.fit, Similarity());
    if (options.pose == Pose::automatic && !model.stable_vertices.empty())
        return fit_placed(context, model, vertices, weights, options.fit,
                          align_stable(model, vertices));
    const Similarity start = align_weighted(vertices, model.mean, weights);
    if (options.pose == Pose::rigid)
        return fit_rigid(context, model, vertices, weights, options.fit, start);
    PlacedFit kept = fit_placed(context, model, vertices, weights, options.fit, Similarity());
    if (!is_far(start, model.mean)) return kept;
    // A wide open mouth may look like a turned head at first; what the model cannot explain decides.
    PlacedFit moved = fit_rigid(context, model, vertices, weights, options.fit, start);
    return moved.residual_rms_mm < 0.6 * kept.residual_rms_mm ? moved : kept;
}

}  // namespace

NeutralizationResult neutralize(const Context& context, const ExpressionModel& model,
                                const PointsRef& vertices, const Vector& weights,
                                const NeutralizeOptions& options) {
    context.progress(Stage::neutralizing, 0.0);
    const Index n = model.num_vertices();
    check_face(model, vertices, weights);
    PlacedFit placed = place_and_fit(context, model, vertices, weights, options);
    FitResult& fit = placed.fit;
    const Similarity& to_model = placed.to_model;

    NeutralizationResult result;
    Vector moved = -expression_displacement(context, model, fit.expression, options.fit.method);
    Eigen::Map<Points> displacement(moved.data(), n, 3);
    if (!identity_motion(to_model)) displacement = (displacement * to_model.rotation).eval();  // rows: R' d
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
    result.identity = std::move(fit.identity);
    result.expression = std::move(fit.expression);
    result.component_probabilities = std::move(fit.component_probabilities);
    result.sweeps = fit.sweeps;
    result.converged = fit.converged;
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

}  // namespace mien
