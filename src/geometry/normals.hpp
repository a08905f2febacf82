// Triangle and vertex normals.
#pragma once

#include "base/types.hpp"

namespace mien {

/// #F x 3, length = twice the triangle's area; zero for degenerate triangles.
Points triangle_normals(const PointsRef& vertices, const TrianglesRef& triangles);
/// #V x 3 unit normals, area-weighted; zero for vertices without area.
Points vertex_normals(const PointsRef& vertices, const TrianglesRef& triangles);

}  // namespace mien
