// Points with exactly equal coordinates become one vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

/// For each point the number of its class; classes are numbered in order of their first point, so
/// the order of distinct points is kept. -0 equals 0; a point that is not a number equals none.
/// Expected time O(n).
struct WeldedPoints {
    std::vector<std::uint32_t> class_of;     ///< n
    std::vector<std::uint32_t> first_point;  ///< one per class, ascending
};

WeldedPoints weld_points(const PointsRef& points, const Context& context);

}  // namespace mien
