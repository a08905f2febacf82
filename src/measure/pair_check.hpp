// What every measure of two faces in correspondence asks of its input.
#pragma once

#include "mesh/tri_mesh.hpp"

namespace mien {

/// Throws Status::invalid_mesh (first offending vertex or triangle) or Status::mismatch.
void check_faces_in_correspondence(const PointsRef& before, const PointsRef& after,
                                   const TrianglesRef& triangles);
/// One surface: finite vertices, indices in range, at least one triangle.
void check_surface(const PointsRef& vertices, const TrianglesRef& triangles, const char* what);
/// Throws Status::mismatch naming the zone and the vertex.
void check_zones(const std::vector<Zone>& zones, Index num_vertices);
/// The same, and that zones are patches of these triangles: Status::mismatch for a zone of
/// twenty vertices or more of which most lie in no triangle of the zone, as the numbers of
/// another template do. For what is summed over a surface; distances may be asked of scattered
/// points. O(#F + zones).
void check_patches(const std::vector<Zone>& zones, const TrianglesRef& triangles,
                   Index num_vertices);
/// Per vertex, 1 where it belongs to the set.
std::vector<char> membership(const std::vector<std::uint32_t>& vertices, Index num_vertices);

}  // namespace mien
