// Which vertices lie on an open edge.
#pragma once

#include <vector>

#include "base/types.hpp"

namespace mien {

/// Per vertex, 1 where an edge with a single triangle ends. O(F log F).
std::vector<char> border_vertices(const TrianglesRef& triangles, Index num_vertices);

/// True when a place given by barycentric coordinates lies on a border edge or border vertex.
bool on_border(const std::vector<char>& border, const TrianglesRef& triangles,
               std::uint32_t triangle, const Vector3& barycentric);

}  // namespace mien
