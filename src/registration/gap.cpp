#include "registration/gap.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"

namespace mien {
Vector raise_field(const ScanView& scan, const Triangles& triangles, const VertexRings& rings,
                   const Vector& trust, const CorrespondenceSettings& match, double robust_scale_mm,
                   const GapSettings& settings, Points& places, const Context& context) {
    const Index n = places.rows();
    CorrespondenceSettings filter = match;
    filter.robust_scale_mm = robust_scale_mm;
    filter.max_distance_mm = settings.reach * robust_scale_mm;
    Correspondences found;
    Vector weight(n), gap(n);
    std::vector<std::uint8_t> left_out(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) left_out[static_cast<std::size_t>(i)] = trust[i] == 0;
    GapField field(rings);
    for (int round = 0; round < settings.rounds; ++round) {
        context.progress(Stage::refining, static_cast<double>(round) / settings.rounds);
        const Points normals = vertex_normals(places, triangles);
        find_correspondences(scan, places, normals, filter, found, context, left_out);
        for (Index i = 0; i < n; ++i) {
            weight[i] = found.weight[i] * trust[i];
            // The gap to the plane through the hit, seen along the template's normal.
            const SurfaceHit& hit = found.hits[static_cast<std::size_t>(i)];
            const Vector3 to_hit = hit.valid() ? Vector3(hit.point - places.row(i).transpose())
                                               : Vector3(Vector3::Zero());
            gap[i] = to_hit.dot(normals.row(i).transpose());
        }
        const Vector delta = field.solve(weight, gap, settings.field, context);
        if (!delta.allFinite())
            fail(Status::no_solution,
                 "registration: the field that closes the gap is not finite; check the scan's "
                 "unit");
        for (Index i = 0; i < n; ++i)
            places.row(i) +=
                std::clamp(delta[i], -settings.max_step_mm, settings.max_step_mm) * normals.row(i);
    }
    context.progress(Stage::refining, 1);
    return weight;
}

Index undo_turns(const Points& before, const Triangles& triangles, const VertexRings& rings,
                 const GapSettings& settings, Points& places) {
    const double ramp = settings.turn_ramp;
    const Points normals_before = triangle_normals(before, triangles);
    Index undone = 0;
    for (int round = 0; round < settings.undo_rounds; ++round) {
        const Points normals = triangle_normals(places, triangles);
        Vector back = Vector::Zero(places.rows());
        Index turned = 0;
        for (Index t = 0; t < triangles.rows(); ++t) {
            const double scale = normals.row(t).norm() * normals_before.row(t).norm();
            const double excess =
                settings.turn_cosine + ramp -
                (scale > 0 ? normals.row(t).dot(normals_before.row(t)) / scale : 1);
            if (!(excess > 0)) continue;
            turned += excess >= ramp;
            const double share = fade(excess / (2 * ramp));
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t v = triangles(t, k);
                back[v] = std::max(back[v], share);
                if (round == 0) continue;
                for (const std::uint32_t j : rings.of(v)) back[j] = std::max(back[j], share);
            }
        }
        undone += turned;
        if (back.maxCoeff() == 0) break;
        for (Index v = 0; v < places.rows(); ++v)
            if (back[v] > 0) places.row(v) += back[v] * (before.row(v) - places.row(v));
    }
    return undone;
}

GapState close_gap(const DeformationModel& model, const ScanView& scan, const PriorState& prior,
                   const FitState& state, const VertexRings& rings,
                   const CorrespondenceSettings& match, double sigma_mm,
                   const GapSettings& settings, const Context& context) {
    GapState gap;
    gap.places = state.places;
    if (!settings.enabled) return gap;
    const Triangles& triangles = model.template_mesh.triangles;
    Vector open(gap.places.rows());
    for (Index i = 0; i < open.size(); ++i)
        open[i] = prior.inner[static_cast<std::size_t>(i)] ? 0 : 1;
    gap.weight = raise_field(scan, triangles, rings, open, match, settings.robust_sigmas * sigma_mm,
                             settings, gap.places, context);
    if (settings.undo_turns)
        gap.undone = undo_turns(state.places, triangles, rings, settings, gap.places);
    return gap;
}

}  // namespace mien
