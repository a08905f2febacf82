// Orders of a vertex' neighbourhood, which graph operators with a fixed place for each neighbour
// need: the walk that winds around a vertex ring by ring (Lim et al. 2018; Bouritsas et al. 2019;
// Gong et al. 2019).
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// The one-rings of all vertices in counter-clockwise order. At a border the walk begins where no
/// triangle comes before; where triangles form several fans, these follow each other. Any triangle
/// soup; deterministic. O(#F log degree).
std::vector<std::vector<std::uint32_t>> ordered_rings(const TriMesh& mesh);

/// Rows of `length` vertices for SpiralNet++: the vertex, its ring from its first entry, then the
/// second ring in the order in which the walk continues, and so on. A piece with too few vertices
/// is filled up with the nearest other vertices by distance, and with #V (padding) when the mesh
/// has too few. #V x length, row-major.
std::vector<std::uint32_t> spirals(const TriMesh& mesh, Index length);

/// Rows for Neural3DMM: `rings` rings, the first of which begins at the neighbour on the shortest
/// path to `reference`. With `dilation` d only every d-th entry stays, the vertex itself first.
/// Rows have the length mean + 2 standard deviations of all, rounded down, and end in #V (padding)
/// or are cut. `length` receives it.
std::vector<std::uint32_t> reference_spirals(const TriMesh& mesh, Index rings, Index dilation,
                                             std::uint32_t reference, Index& length);

/// Rows of `places` vertices for LSA-3DMM: the vertex and its ordered ring, cut, or padded by #V.
std::vector<std::uint32_t> padded_rings(const TriMesh& mesh, Index places);

}  // namespace mien
