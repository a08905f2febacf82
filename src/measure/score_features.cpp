#include "measure/score_features.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "geometry/curvature.hpp"
#include "geometry/normals.hpp"

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
    if (!(scales.curvature.maxCoeff() > 0)) return displacements;
    return displacements / 3 * (3 + (scales.shape.size() != 0 ? kShapeFeatures : 2));
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
    const bool all = scales.shape.size() != 0;
    const Points mean_normals = all ? vertex_normals(mean, triangles) : Points();
    const Points normals = all ? vertex_normals(aligned, triangles) : Points();
    const double bound =
        1.0 / scales.curvature_radius_mm;  // what a fit over this radius can resolve
    for (Index v = 0; v < aligned.rows(); ++v) {
        if (!(scales.displacement[v] > 0)) continue;
        const double k1 = std::clamp(field.maximal[v], -bound, bound),
                     k2 = std::clamp(field.minimal[v], -bound, bound);
        if (!all) {
            row[next++] = scales.curvature[v] * k1;
            row[next++] = scales.curvature[v] * k2;
            continue;
        }
        const Vector3 first = field.direction.row(v).transpose(),
                      second = field.normals.row(v).transpose().cross(first);
        const Matrix3 tensor = k1 * first * first.transpose() + k2 * second * second.transpose();
        Eigen::Matrix<double, kShapeFeatures, 1> shape;
        shape << k1, k2, 0.5 * (k1 + k2), k1 * k2, std::sqrt(0.5 * (k1 * k1 + k2 * k2)),
            (normals.row(v) - mean_normals.row(v)).transpose(), tensor(0, 0), tensor(1, 1),
            tensor(2, 2), tensor(0, 1), tensor(0, 2), tensor(1, 2);
        row.segment<kShapeFeatures>(next) =
            scales.curvature[v] * scales.shape.cwiseProduct(shape).transpose();
        next += kShapeFeatures;
    }
}

Vector repeated_for_features(const Vector& per_vertex, const Vector& displacement_scale,
                             Index count) {
    Vector result(count);
    Index next = 0;
    const Index used = (displacement_scale.array() > 0).count();
    const Index rest = used > 0 ? count / used - 3 : 0;
    for (const Index repeats : {Index{3}, rest})
        for (Index v = 0; v < per_vertex.size() && next < count; ++v)
            if (displacement_scale[v] > 0)
                for (Index k = 0; k < repeats; ++k) result[next++] = per_vertex[v];
    return result;
}

}  // namespace mien
