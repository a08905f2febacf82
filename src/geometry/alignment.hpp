// Rigid and similarity alignment of point sets in correspondence (2.36; Horn, Umeyama).
#pragma once

#include "base/types.hpp"

namespace mien {

/// Least-squares motion with target ~ scale * R * source + t, weights >= 0 (empty: all one). The
/// scale stays 1 unless with_scale. Throws Status::no_solution when the weighted points do not span
/// at least a line-free plane (fewer than 3 points, collinear).
Similarity align_points(const PointsRef& source, const PointsRef& target, const Vector& weights,
                        bool with_scale);

}  // namespace mien
