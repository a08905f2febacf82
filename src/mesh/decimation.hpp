// Quadric edge collapse (Garland & Heckbert 1997) to a number of vertices. Collapses go into
// existing vertices, so each coarse vertex is one of the fine ones.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct DecimatedMesh {
    TriMesh mesh;                     ///< vertices and triangles only
    std::vector<std::uint32_t> kept;  ///< fine index of each coarse vertex, ascending
};

/// Collapses edges of least quadric error until num_vertices remain or no collapse is legal.
/// Borders collapse along themselves only. The mesh must be an orientable manifold:
/// Status::invalid_mesh with the first triangle that does not fit. Deterministic. Throws
/// invalid_argument for num_vertices < 4.
DecimatedMesh decimate(const TriMesh& mesh, Index num_vertices, const Context& context);

}  // namespace mien
