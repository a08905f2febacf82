// What a score sees of a face: a row of numbers (score_model.hpp, features).
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.hpp"
#include "geometry/rigid_zone.hpp"

namespace mien {

/// What a vertex gives beside its displacement where all features are asked for: k1, k2, mean and
/// Gaussian curvature, curvedness sqrt((k1^2 + k2^2) / 2), the change of its normal (3) and the
/// curvature tensor k1 d1 d1' + k2 d2 d2' (xx, yy, zz, xy, xz, yz).
constexpr Index kShapeFeatures = 14;

/// How much each vertex counts, and over how much skin its curvatures are taken.
struct FeatureScales {
    const Vector& displacement;  ///< #V, 0 outside the zone of interest
    const Vector& curvature;     ///< #V, all 0 without curvatures
    double curvature_radius_mm;
    const Vector& shape;  ///< kShapeFeatures factors; empty: k1 and k2 alone, as they are
};

/// Lays a face rigidly onto the mean by the stable zone; empty: by all of the face, robustly.
RigidZoneResult pose_of(const PointsRef& face, const PointsRef& mean, const TrianglesRef& triangles,
                        const std::vector<std::uint32_t>& stable_zone);
Points align_face(const PointsRef& face, const PointsRef& mean, const TrianglesRef& triangles,
                  const std::vector<std::uint32_t>& stable_zone);

/// Numbers a face gives: 3 a vertex that counts for its displacement, then 2 for its curvatures, or
/// kShapeFeatures.
Index displacement_count(const FeatureScales& scales);
Index feature_count(const FeatureScales& scales);

/// Displacements of scaled vertices, then their shape; `row` has feature_count() numbers.
void features_of(const Points& aligned, const PointsRef& mean, const TrianglesRef& triangles,
                 const FeatureScales& scales, Eigen::Ref<Eigen::RowVectorXd> row);

/// A factor of each vertex, repeated for its features in their order; `count` of them.
Vector repeated_for_features(const Vector& per_vertex, const Vector& displacement_scale,
                             Index count);

}  // namespace mien
