// Lengths between places of a face: straight, and along the skin.
//
// Along the skin by the heat method (geometry/heat_method.hpp), the mean of the way there and the
// way back: within about one percent of the true geodesic. A straight length goes through the head.
// surface_lengths() also says how a length changes when an end moves: the unit direction, in the
// tangent plane of that end, in which it grows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

struct PlaceLength {
    double straight_mm = 0.0;
    double geodesic_mm = 0.0;  ///< infinite where no surface joins the two
};

/// One length per pair of vertices. Throws Status::invalid_mesh for a damaged surface,
/// Status::mismatch for a vertex that does not exist. One factorisation, O(#V^1.5), and two solves
/// per distinct vertex.
std::vector<PlaceLength> measure_lengths(const PointsRef& vertices, const TrianglesRef& triangles,
                                         const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                         const Context& context);

/// Deviation of a length by the heat method, as a share of it: within about one percent either way,
/// evenly (0.01 / sqrt 3).
constexpr double kHeatLengthShare = 0.006;

struct SurfaceLength {
    double mm = 0.0;  ///< infinite where no surface joins the ends
    /// At the first and the second end; zero where the ends are one vertex.
    std::array<Vector3, 2> growth{{Vector3::Zero(), Vector3::Zero()}};
};

/// One per pair of vertices. Throws as measure_lengths(). One factorisation, O(#V^1.5), and one
/// solve per distinct vertex.
std::vector<SurfaceLength> surface_lengths(const PointsRef& vertices, const TrianglesRef& triangles,
                                           const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                           const Context& context);

}  // namespace mien
