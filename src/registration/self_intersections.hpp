// Triangles of a fitted template that cross: lips pressed together, lids, a fold that was left.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

/// Pairs of triangles that cross without sharing a vertex, counted by edges through triangles; each
/// edge finds its first crossing alone. O(F log F).
Index count_self_intersections(const PointsRef& places, const Triangles& triangles,
                               const Context& context);

}  // namespace mien
