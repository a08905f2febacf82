// The surface without the vertices that carry no shape: those inside a flat fan of triangles and
// those on a straight crease or border. Splitting triangles at their centroids or at the middles of
// their sides adds such vertices and nothing else, so a measure of shape that is taken afterwards
// sees the same surface.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct ReducedSurface {
    TriMesh mesh;                     ///< the kept vertices in their order, and their triangles
    std::vector<std::uint32_t> into;  ///< #V: kept vertex (of `mesh`) that stands for each vertex
};

/// Half-edge collapses that leave every triangle in its plane, to within what rounding to float32
/// moves a vertex (2^-22 of the largest coordinate). Vertices at edges of more than two triangles,
/// of inconsistent winding or without triangles stay. In the order of the vertices, so equal input
/// gives equal output. O(#V + #F) for surfaces with few such vertices.
ReducedSurface without_flat_vertices(const TriMesh& mesh, const Context& context);

}  // namespace mien
