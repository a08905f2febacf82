#include "measure/score_features.hpp"

#include <algorithm>

#include "geometry/curvature.hpp"

namespace mien {

RigidZoneResult pose_of(const PointsRef& face, const PointsRef& mean, const TrianglesRef& triangles,
                        const std::vector<std::uint32_t>& stable_zone) {
    RigidZoneOptions options;
    options.tangential = 1.0;
    options.iterations = 6;
    return align_on_zone(face, mean, triangles, stable_zone, options);
}

Points align_face(const PointsRef& face, const PointsRef& mean, const TrianglesRef& triangles,
                  const std::vector<std::uint32_t>& stable_zone) {
    return pose_of(face, mean, triangles, stable_zone).motion.apply(face);
}

Index displacement_count(const FeatureScales& scales) {
    return (scales.displacement.array() > 0).count() * 3;
}

Index feature_count(const FeatureScales& scales) {
    const Index displacements = displacement_count(scales);
    return scales.curvature.maxCoeff() > 0 ? displacements / 3 * 5 : displacements;
}

void features_of(const Points& aligned, const PointsRef& mean, const TrianglesRef& triangles,
                 const FeatureScales& scales, Eigen::Ref<Eigen::RowVectorXd> row) {
    Index next = 0;
    for (Index v = 0; v < aligned.rows(); ++v)
        if (scales.displacement[v] > 0) {
            row.segment<3>(next) = scales.displacement[v] * (aligned.row(v) - mean.row(v));
            next += 3;
        }
    if (next == row.size()) return;
    CurvatureOptions options;
    options.radius_mm = scales.curvature_radius_mm;
    options.robust = false;  // fitted templates have no spikes
    const CurvatureField field = estimate_curvature(aligned, triangles, options, Context());
    const double bound =
        1.0 / scales.curvature_radius_mm;  // what a fit over this radius can resolve
    for (Index v = 0; v < aligned.rows(); ++v)
        if (scales.displacement[v] > 0) {
            row[next++] = scales.curvature[v] * std::clamp(field.maximal[v], -bound, bound);
            row[next++] = scales.curvature[v] * std::clamp(field.minimal[v], -bound, bound);
        }
}

Vector repeated_for_features(const Vector& per_vertex, const Vector& displacement_scale,
                             Index count) {
    Vector result(count);
    Index next = 0;
    for (const Index repeats : {3, 2})
        for (Index v = 0; v < per_vertex.size() && next < count; ++v)
            if (displacement_scale[v] > 0)
                for (Index k = 0; k < repeats; ++k) result[next++] = per_vertex[v];
    return result;
}

}  // namespace mien
