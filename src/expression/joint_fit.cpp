#include "expression/joint_fit.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "expression/joint_system.hpp"

namespace mien {
namespace {

void check_options(const ExpressionModel& model, const JointFitOptions& options, bool joint) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(options.normal_noise_mm2) || !positive(options.tangential_noise_mm2) ||
        !positive(options.face_noise_share))
        fail(Status::invalid_argument,
             "the joint fit's noise is %g and %g mm^2 along and across the normal, and a share of "
             "%g; all must be positive",
             options.normal_noise_mm2, options.tangential_noise_mm2, options.face_noise_share);
    const JointSearch& search = options.search;
    if (search.speakers < 1 || search.pose_steps < 0 || search.pose_steps > 20 ||
        !positive(search.far_mm) || search.candidates < 1 || search.max_rounds < 1)
        fail(Status::invalid_argument, "a setting of the joint fit's search is out of range");
    if (joint && options.fit.method != FitMethod::mixture && options.fit.method != FitMethod::map)
        fail(Status::invalid_argument,
             "faces are fitted together with a prior only: use the fits 'mixture' or 'map'");
    if (options.noise == JointNoise::along_normal && model.triangles.rows() == 0)
        fail(Status::invalid_argument,
             "the expression model has no triangles; noise along normals needs surfaces");
    for (const std::uint32_t vertex : options.treated)
        if (vertex >= static_cast<std::uint64_t>(model.num_vertices()))
            fail(Status::mismatch, "the treated zone names vertex %u of %lld", vertex,
                 static_cast<long long>(model.num_vertices()));
}

/// The likeliest components of a face's own fit, best first.
std::vector<std::size_t> likeliest(const std::vector<double>& probabilities, Index count) {
    std::vector<std::size_t> order(probabilities.size());
    for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return probabilities[a] > probabilities[b];
    });
    order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
    return order;
}

/// Every face by itself.
void start(const Context& context, const ExpressionModel& model,
           const std::vector<JointFace>& faces, const std::vector<Vector>& weights,
           const JointFitOptions& options, JointFit& result) {
    Context quiet = context;
    quiet.progress_function = nullptr;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        result.alone.push_back(
            place_and_fit(quiet, model, faces[k].vertices, weights[k], options.fit, options.pose));
        const PlacedFit& alone = result.alone.back();
        result.poses.push_back(alone.to_model.inverse());
        result.placed.push_back(result.poses.back().inverse().apply(PointsRef(faces[k].vertices)));
        const auto order = likeliest(alone.fit.part_probabilities, options.search.candidates);
        if (options.fit.method == FitMethod::mixture)
            result.chosen.push_back(order.empty() ? 0 : order[0]);
        context.progress(Stage::neutralizing,
                         0.5 * static_cast<double>(k + 1) / static_cast<double>(faces.size()));
    }
}

/// A single isotropic face: its own fit is the posterior over all components.
void take_alone(const ExpressionModel& model, JointFit& result) {
    const FitResult& fit = result.alone.front().fit;
    const Index q = model.num_expression_modes();
    result.identity = fit.identity;
    result.expressions = {fit.expression};
    if (fit.covariance.size() != 0) result.covariance = fit.covariance.bottomRightCorner(q, q);
}

/// Coordinates along the smooth modes that a fit did not know.
void pad_identity(Index identity_modes, JointFit& result) {
    const Vector none = Vector::Zero(identity_modes);
    result.identity.conservativeResizeLike(none);
    for (PlacedFit& alone : result.alone) {
        alone.fit.identity.conservativeResizeLike(none);
        alone.fit.covariance.resize(0, 0);  // of other coordinates
    }
}

}  // namespace

Vector witness_weights(const Vector& weights, Index num_vertices,
                       const std::vector<std::uint32_t>& treated) {
    if (treated.empty()) return weights;
    Vector witnesses = weights.size() != 0 ? weights : Vector(Vector::Ones(num_vertices));
    for (const std::uint32_t vertex : treated) witnesses[vertex] = 0.0;
    return witnesses;
}

JointFit fit_faces(const Context& context, const ExpressionModel& model,
                   const std::vector<JointFace>& faces, const JointFitOptions& options) {
    if (faces.empty()) fail(Status::invalid_argument, "there is no face to fit");
    const bool along_normal = options.noise == JointNoise::along_normal;
    const bool joint = along_normal || faces.size() > 1;
    check_options(model, options, joint);
    const bool by_prior =
        options.fit.method == FitMethod::mixture || options.fit.method == FitMethod::map;
    if (model.people != nullptr && (joint || !by_prior)) {
        JointFit result = fit_faces(context, *model.people, faces, options);
        pad_identity(model.num_identity_modes(), result);
        return result;
    }
    for (const JointFace& face : faces) {
        check_face(model, face.vertices, face.weights);
        if (along_normal) check_face(model, face.vertices, Vector());  // surfaces need every vertex
    }
    const Index n = model.num_vertices();
    const Index stride = along_normal ? std::max<Index>(1, n / options.search.speakers) : 1;
    std::vector<Vector> weights;
    const bool plain = !along_normal && options.treated.empty() &&
                       std::all_of(faces.begin(), faces.end(),
                                   [](const JointFace& face) { return face.weights.size() == 0; });
    for (const JointFace& face : faces) {
        weights.push_back(witness_weights(face.weights, n, options.treated));
        if (weights.back().size() == 0 && !plain) weights.back() = Vector::Ones(n);
        if (along_normal) weights.back() *= static_cast<double>(stride);  // for the neighbours
    }
    JointFit result;
    start(context, model, faces, weights, options, result);
    if (!joint) {
        take_alone(model, result);
        return result;
    }

    JointSystem system(context, model, options, weights, stride);
    std::vector<std::vector<std::size_t>> candidates;
    for (const PlacedFit& alone : result.alone)
        candidates.push_back(likeliest(alone.fit.part_probabilities, options.search.candidates));
    std::vector<std::size_t> chosen =
        result.chosen.empty() ? std::vector<std::size_t>(faces.size(), 0) : result.chosen;
    const int steps = along_normal ? options.search.pose_steps : 0;
    for (int step = 0;; ++step) {
        system.gather(result.placed);
        system.choose(chosen, candidates);
        context.progress(Stage::neutralizing, 0.5 + 0.45 * (step + 1) / (steps + 1));
        if (step == steps) break;
        for (std::size_t k = 0; k < faces.size(); ++k)
            system.settle(static_cast<Index>(k), result.placed, result.poses[k]);
    }
    if (!model.components.empty() && options.fit.method == FitMethod::mixture)
        result.chosen = chosen;
    else
        result.chosen.clear();
    result.identity = system.identity();
    for (std::size_t k = 0; k < faces.size(); ++k)
        result.expressions.push_back(system.expression(static_cast<Index>(k)));
    result.covariance = system.covariance(chosen);
    return result;
}

}  // namespace mien
