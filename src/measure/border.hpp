// Whether a place on a surface lies on its open edge, where the closest point of a missing part
// ends up.
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// True when a place given by barycentric coordinates lies on a border edge or border vertex.
/// `border`: #V, border_vertices() of mesh/topology.hpp. O(1).
bool on_border(const std::vector<std::uint8_t>& border, const TrianglesRef& triangles,
               std::uint32_t triangle, const Vector3& barycentric);

}  // namespace mien
