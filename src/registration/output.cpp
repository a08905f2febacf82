#include "registration/output.hpp"

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "registration/self_intersections.hpp"

namespace mien {
namespace {

// Nearest places of the scan, and the signed distances to them.
void find_residuals(const FinishedStages& stages, const Points& normals, RegistrationResult& result,
                    const Context& context) {
    // Farther than any scan: an absurd start pose, or a fit that blew up.
    constexpr double kBeyondReach_mm = 1e30;
    const Points& places = stages.inner.places;
    stages.scan.surface.tree.closest(places, kBeyondReach_mm, result.correspondence, context);
    result.residual_mm.resize(places.rows());
    for (Index i = 0; i < places.rows(); ++i) {
        const SurfaceHit& hit = result.correspondence[static_cast<std::size_t>(i)];
        if (!hit.valid())
            fail_at(Status::no_solution, i,
                    "registration: the fit ended beyond reach of the scan; check the start pose "
                    "and the unit");
        const double side = normals.row(i).dot(hit.point.transpose() - places.row(i));
        result.residual_mm[i] = side < 0 ? -hit.distance() : hit.distance();
    }
}

Verdict find_verdict(const FinishedStages& stages, const Points& normals,
                     const RegistrationResult& result, const RegistrationSettings& settings,
                     const Context& context) {
    const Points& places = stages.inner.places;
    const FoldCounts& folds = stages.inner.folds;
    Verdict verdict;
    verdict.unit_to_mm = stages.scan.unit_to_mm;
    verdict.search_score = stages.start.search_score;
    verdict.searched = stages.start.searched;
    verdict.turned_over = stages.start.scan.turned_over();
    verdict.turned_triangles = static_cast<int>(stages.scan.num_turned);
    verdict.notes = stages.start.notes;
    if (!stages.scan.pieces.note.empty()) verdict.notes.push_back(stages.scan.pieces.note);
    verdict.two_surfaces = stages.scan.pieces.doubt;
    verdict.landmarks_rejected = stages.start.rejected;
    verdict.colors_left_out = stages.start.colors_left_out;
    verdict.repaired_triangles = static_cast<int>(stages.gap.undone + folds.before - folds.after);
    verdict.flipped_triangles = static_cast<int>(folds.after);
    verdict.self_intersections = static_cast<int>(
        count_self_intersections(places, stages.model.template_mesh.triangles, context));
    verdict.colors = stages.prior.colors.agreements(stages.start.scan, places, normals,
                                                    settings.fit.loop.match, context);
    measure_fit({stages.model, stages.prior, stages.start, stages.fit, places,
                 result.correspondence, result.weight, result.confidence_mm},
                settings.start.landmark_sigma_mm, settings.verdict.measure, context, verdict);
    judge(verdict, settings.verdict.limits);
    return verdict;
}

}  // namespace

RegistrationResult make_result(const FinishedStages& stages, const RegistrationSettings& settings,
                               const Context& context) {
    const FitState& state = stages.fit.state;
    const FitTrace& trace = stages.fit.trace;
    const TriMesh& mesh = stages.model.template_mesh;
    const Points& places = stages.inner.places;
    const Points normals = vertex_normals(places, mesh.triangles);
    const Points normals_model = normals * state.motion.rotation;
    RegistrationResult result;
    // By the fit's weights and not the gap's: where the modes could not follow, the place along the
    // skin is not known, though the surface is.
    result.confidence_mm =
        place_deviation(stages.model, state, stages.prior.freedom, trace.weight, normals_model,
                        stages.start.pins, trace.sigma_mm, settings.confidence, context);
    result.weight = stages.gap.weight.size() > 0 ? Vector(trace.weight.cwiseMax(stages.gap.weight))
                                                 : trace.weight;
    find_residuals(stages, normals, result, context);
    result.verdict = find_verdict(stages, normals, result, settings, context);
    for (SurfaceHit& hit : result.correspondence) {
        hit.barycentric = stages.scan.raw_barycentric(hit);
        hit.triangle = stages.scan.raw_primitive(hit);
    }
    result.energy = trace.energy;
    result.iterations = trace.rounds;
    result.sigma_mm = trace.sigma_mm;
    result.start = stages.start.motion;
    result.motion = state.motion;
    result.unknown_landmarks = stages.start.unknown;
    result.fitted.vertices = places;
    result.fitted.triangles = mesh.triangles;
    result.fitted.texture = mesh.texture;
    result.fitted.texture_triangles = mesh.texture_triangles;
    return result;
}

}  // namespace mien
