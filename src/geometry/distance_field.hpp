// How far every vertex of a surface is from the nearest of some source vertices, along the surface,
// by the heat method (heat_method.hpp): one field per source, and the least of them at each vertex.
// That is the distance of the nearest source exactly, where one heat flow from all sources at once
// would blur the places half way between two of them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"
#include "geometry/heat_method.hpp"

namespace mien {

/// #V, mm; infinity where no source is on the vertex's connected component; zero at the sources.
/// Throws Status::invalid_argument for no source or one out of range, and what HeatGeodesics
/// throws. One factorisation, O(#V^1.5), and O(#V log #V) per source; 60 numbers a vertex.
Vector distance_field(const PointsRef& vertices, const TrianglesRef& triangles,
                      const std::vector<std::uint32_t>& sources, const HeatOptions& options,
                      const Context& context);

}  // namespace mien
