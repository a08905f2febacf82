// Makes a scan fit for a tree: what is not finite, doubled, degenerate or unused goes; what stays
// keeps its bits. Order is stable: the vertices and triangles that stay keep the order of the
// input, merged vertices stand where (and have the colour that) the first of them had.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct CleaningOptions {
    /// Vertices with exactly equal coordinates become one (scanners split them at texture seams,
    /// which would look like borders).
    bool merge_equal_vertices = true;
    /// Of triangles with the same three vertices, in whatever order, the first stays.
    bool drop_duplicate_triangles = true;
    /// Triangles of three distinct vertices without area. Off: dropping one tears its neighbours
    /// apart, and the trees bear them.
    bool drop_zero_area = false;
    /// Vertices that no triangle uses; a mesh without any triangle keeps all its vertices.
    bool drop_unused_vertices = true;
    /// Pieces of fewer triangles go. Default 0: none.
    Index min_component_triangles = 0;
};

constexpr std::uint32_t kDropped = std::numeric_limits<std::uint32_t>::max();

struct CleanedMesh {
    TriMesh mesh;
    std::vector<std::uint32_t> vertex_to_new;    ///< input #V, kDropped where it went
    std::vector<std::uint32_t> vertex_to_old;    ///< output #V; the first of merged ones
    std::vector<std::uint32_t> triangle_to_new;  ///< input #F, kDropped where it went
    std::vector<std::uint32_t> triangle_to_old;  ///< output #F
    Index num_not_finite = 0;                    ///< vertices
    Index num_merged = 0;                        ///< vertices that became another one
    Index num_unused = 0;                        ///< vertices that nothing used any more
    Index num_bad_index = 0;        ///< triangles with an index out of range or a lost vertex
    Index num_degenerate = 0;       ///< triangles
    Index num_duplicate = 0;        ///< triangles
    Index num_small_component = 0;  ///< triangles
};

/// `raw` need not pass check_mesh(): any coordinates and indices are allowed, and attribute arrays
/// of another length or range than they should have are ignored. Texture coordinates stay whole,
/// with their triangles. Throws Status::invalid_mesh when no finite vertex or, of a mesh with
/// triangles, no triangle is left. O(#V + #F log degree).
CleanedMesh clean_mesh(const TriMesh& raw, const CleaningOptions& options, const Context& context);

}  // namespace mien
