// Scans are seldom manifold: fans of triangles that touch in one vertex, edges of three triangles.
// What needs a manifold works on a copy in which each fan has a vertex of its own.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct ManifoldMesh {
    TriMesh mesh;                              ///< vertices and triangles only
    std::vector<std::uint32_t> vertex_to_old;  ///< #V; split vertices share their old one
    Index num_split = 0;                       ///< vertices more than before
    Index num_dropped = 0;                     ///< triangles that fit into no manifold
};

/// An oriented manifold of the same triangles: vertices are split into one per fan of triangles
/// that are joined across edges of two sides in opposite directions; what still does not fit goes.
/// Unused vertices go. `mesh` must have passed check_mesh(). Throws Status::invalid_mesh when no
/// triangle is left. O(F log degree).
ManifoldMesh make_manifold(const TriMesh& mesh, const Context& context);

}  // namespace mien
