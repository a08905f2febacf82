#include "expression/visits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "geometry/normals.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kLargestSlideMm = 5.0;  ///< a foot farther off is on another part of the face
constexpr double kFarFactor = 1.5;       ///< of the residual that 95 % of new people stay under

/// `neutral` with each vertex where the person's own face says it is: the foot of base + moved on
/// the face.
Points without_slide(const Context& context, const Points& base, const Points& moved,
                     const Points& face, const TrianglesRef& triangles, const Vector& seen_first,
                     const Vector& seen) {
    const Points expected = base + moved;
    const TriangleTree tree(face, triangles, context);
    std::vector<SurfaceHit> feet;
    tree.closest(expected, std::numeric_limits<double>::infinity(), feet, context);
    const Points normals = vertex_normals(face, triangles),
                 flat = triangle_normals(face, triangles);
    Points neutral = face - moved;
    for (Index v = 0; v < face.rows(); ++v) {
        const SurfaceHit& foot = feet[static_cast<std::size_t>(v)];
        const double share = std::min(
            {1.0, seen_first.size() != 0 ? seen_first[v] : 1.0, seen.size() != 0 ? seen[v] : 1.0});
        if (!foot.valid() || !(share > 0)) continue;
        const Vector3 slide = foot.point - Vector3(face.row(v));
        // A foot on the other lip, or inside the nose, is no place of this vertex.
        if (slide.norm() > kLargestSlideMm ||
            Vector3(flat.row(foot.triangle)).dot(Vector3(normals.row(v))) <= 0)
            continue;
        neutral.row(v) += share * slide;
    }
    return neutral;
}

/// Neutral faces in the training's frame.
std::vector<Points> neutral_faces(const Context& context, const ExpressionModel& model,
                                  const std::vector<JointFace>& faces,
                                  const JointFitOptions& options, const JointFit& fit) {
    std::vector<Points> neutrals;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const Points& placed = fit.placed[k];
        const Vector flat =
            expression_displacement(context, model, fit.expressions[k], options.fit.method);
        const Points moved = Eigen::Map<const Points>(flat.data(), model.num_vertices(), 3);
        if (k == 0 || options.noise == JointNoise::isotropic)
            neutrals.push_back(placed - moved);
        else
            neutrals.push_back(without_slide(context, neutrals[0], moved, placed, model.triangles,
                                             faces[0].weights, faces[k].weights));
    }
    return neutrals;
}

/// The mean of what the faces show, and the model's face where none shows anything.
Points shared_face(const Context& context, const ExpressionModel& model,
                   const std::vector<JointFace>& faces, const std::vector<Points>& neutrals,
                   const JointFit& fit, FitMethod method) {
    Points shared = synthesize_face(context, model, fit.identity, Vector(), method);
    for (Index i = 0; i < shared.rows(); ++i) {
        Vector3 sum = Vector3::Zero();
        double total = 0.0;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const double weight = faces[k].weights.size() != 0 ? faces[k].weights[i] : 1.0;
            if (weight == 0.0) continue;
            sum += weight * neutrals[k].row(i).transpose();
            total += weight;
        }
        if (total > 0.0) shared.row(i) = sum.transpose() / total;
    }
    return shared;
}

/// Root mean square distance from the shared face, by the vertices that may speak.
double distance_to_shared(const Points& neutral, const Points& shared, const Vector& witnesses) {
    double squares = 0.0, seen = 0.0;
    for (Index i = 0; i < neutral.rows(); ++i) {
        const double weight = witnesses.size() != 0 ? witnesses[i] : 1.0;
        if (weight == 0.0) continue;
        squares += weight * (neutral.row(i) - shared.row(i)).squaredNorm();
        seen += weight;
    }
    return seen > 0.0 ? std::sqrt(squares / seen) : 0.0;
}

}  // namespace

VisitsResult neutralize_visits(const Context& context, const ExpressionModel& model,
                               const std::vector<VisitFace>& faces, const VisitsOptions& options) {
    JointFit fit = fit_faces(context, model, faces, options);
    std::vector<Points> neutrals = neutral_faces(context, model, faces, options, fit);
    VisitsResult result;
    result.shared_vertices = shared_face(context, model, faces, neutrals, fit, options.fit.method);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        Points& neutral = neutrals[k];
        result.distances_mm.push_back(distance_to_shared(
            neutral, result.shared_vertices,
            witness_weights(faces[k].weights, model.num_vertices(), options.treated)));
        for (Index i = 0; i < neutral.rows(); ++i)
            if (!neutral.row(i).allFinite()) neutral.row(i) = result.shared_vertices.row(i);
        result.neutral_vertices.push_back(fit.poses[k].apply(PointsRef(neutral)));
        result.residuals_mm.push_back(fit.alone[k].residual_rms_mm);
        if (!fit.chosen.empty() && !model.components.empty())
            result.components.push_back(
                model.components[model.plan->components[fit.chosen[k]].component].name);
    }
    result.identity = std::move(fit.identity);
    result.expressions = std::move(fit.expressions);
    result.poses = std::move(fit.poses);
    result.covariance = std::move(fit.covariance);
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

std::vector<std::string> visit_warnings(const ExpressionModel& model, const VisitsResult& result,
                                        std::size_t k) {
    std::vector<std::string> warnings;
    const double expected = people_of(model).expected_residual_mm;
    if (expected > 0.0 && result.residuals_mm[k] > kFarFactor * expected)
        warnings.push_back(
            "the face lies farther from the model than faces of new people do: it was fitted "
            "badly, or is unlike the training faces");
    if (expected > 0.0 && result.distances_mm[k] > expected)
        warnings.push_back(
            "without its expression the face still differs from the others: it was fitted badly, "
            "shows an expression that the model does not know, or is another person");
    if (!result.components.empty() && result.components[k] == "any")
        warnings.push_back("the expression is none of the trained ones");
    return warnings;
}

RemovedVolume removed_volume(const Context& context, const ExpressionModel& model,
                             const VisitsResult& visits, std::size_t first, std::size_t second,
                             const std::vector<std::uint32_t>& zone) {
    const Index q = model.num_expression_modes(), n = model.num_vertices();
    if (first >= visits.expressions.size() || second >= visits.expressions.size())
        fail(Status::not_found, "visits %zu and %zu of %zu", first, second,
             visits.expressions.size());
    std::vector<char> inside(static_cast<std::size_t>(n), 0);
    for (const std::uint32_t vertex : zone)
        if (vertex < static_cast<std::uint64_t>(n)) inside[vertex] = 1;
    // Area normals of the first neutral face in the training's frame; a vertex has a third of its
    // triangles'.
    const Points base =
        visits.poses[first].inverse().apply(PointsRef(visits.neutral_vertices[first].topRows(n)));
    const Points doubled = triangle_normals(base, model.triangles);
    Vector gradient = Vector::Zero(3 * n);  // mm^3 per mm
    for (Index t = 0; t < model.triangles.rows(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const Index v = model.triangles(t, corner);
            if (inside[static_cast<std::size_t>(v)])
                gradient.segment<3>(3 * v) += doubled.row(t).transpose() / 6.0;
        }
    Vector along(model.num_identity_modes() + q);
    along << project_modes(context, model.identity_modes, gradient),
        project_modes(context, model.expression_modes, gradient);
    const Vector slope = 1e-3 * model.spill.pull_vector(along).tail(q);
    RemovedVolume result;
    result.removed_ml = slope.dot(visits.expressions[second] - visits.expressions[first]);
    const auto block = [&](std::size_t k, std::size_t l) {
        return visits.covariance.block(static_cast<Index>(k) * q, static_cast<Index>(l) * q, q, q);
    };
    const Matrix spread =
        block(first, first) + block(second, second) - block(first, second) - block(second, first);
    result.sd_ml = std::sqrt(std::max(0.0, slope.dot(spread * slope)));
    return result;
}

}  // namespace mien
