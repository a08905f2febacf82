// Edges, borders and pieces of any triangle soup, manifold or not, from plain arrays. Everything is
// ordered by vertex and triangle numbers alone, so equal input gives equal output.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

class TriangleFans;

/// Undirected edges (a < b) in lexicographic order, each with the triangle sides that lie on it.
/// A side 3 t + k runs from corner k to corner (k + 1) % 3 of triangle t. Sides that connect a
/// vertex with itself belong to no edge. O(#F log degree), 24 bytes per triangle.
struct EdgeTable {
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> first_side;  ///< #E + 1 offsets into `sides`
    std::vector<std::uint32_t> sides;       ///< ascending within an edge

    std::size_t num_edges() const { return edges.size(); }
    std::uint32_t num_sides(std::size_t edge) const {
        return first_side[edge + 1] - first_side[edge];
    }
};

/// Indices must be in range (check_mesh()). Throws Status::invalid_mesh beyond 2^32 / 3 triangles.
EdgeTable build_edge_table(const TrianglesRef& triangles, Index num_vertices,
                           const Context& context);

/// Start and end vertex of a triangle's side.
inline std::array<std::uint32_t, 2> side_ends(const TrianglesRef& triangles, std::uint32_t side) {
    const Index triangle = side / 3;
    const int corner = static_cast<int>(side % 3);
    return {triangles(triangle, corner), triangles(triangle, (corner + 1) % 3)};
}

/// The sides that no other triangle shares, ascending.
std::vector<std::uint32_t> border_sides(const EdgeTable& table);
/// 1 for each vertex on such a side, 0 for the others (vertices without triangles among them).
std::vector<std::uint8_t> border_vertices(const EdgeTable& table, Index num_vertices);
/// The same for who needs no table. O(#F log degree), 24 bytes per triangle while it works.
std::vector<std::uint8_t> border_vertices(const TrianglesRef& triangles, Index num_vertices,
                                          const Context& context);

/// Closed vertex cycles along the border, the surface on their left, each beginning with its
/// smallest vertex, ordered by it. Where several borders meet in one vertex, the walk takes the
/// side of lowest number that is still free; chains that do not close (orientation not consistent)
/// come as they are.
std::vector<std::vector<std::uint32_t>> border_loops(const EdgeTable& table,
                                                     const TrianglesRef& triangles,
                                                     Index num_vertices);

/// Pieces connected through shared vertices, numbered by descending number of triangles, equal ones
/// by lowest vertex. A vertex without triangles is a piece of its own.
struct ConnectedComponents {
    std::vector<std::uint32_t> of_vertex;    ///< #V
    std::vector<std::uint32_t> of_triangle;  ///< #F
    std::vector<Index> num_triangles;        ///< per piece
    std::vector<Index> num_vertices;         ///< per piece
};
ConnectedComponents connected_components(const TrianglesRef& triangles, Index num_vertices);

/// The piece of each triangle, joined across edges alone, numbered by the pieces' first triangles.
/// `fans`: of these triangles, wound_alike(). O(F).
std::vector<std::uint32_t> pieces_across_edges(const TrianglesRef& triangles,
                                               const TriangleFans& fans);

/// What keeps a soup from being an oriented manifold.
struct TopologyReport {
    Index num_border_edges = 0;
    Index num_complex_edges = 0;         ///< three triangles or more
    Index num_misoriented_edges = 0;     ///< two triangles that run along it in the same direction
    Index num_pinched_vertices = 0;      ///< triangles around it form more than one fan
    Index num_degenerate_triangles = 0;  ///< a vertex twice
    Index num_unused_vertices = 0;
    std::int64_t first_complex_edge = -1;      ///< index into the edge table
    std::int64_t first_misoriented_edge = -1;  ///< index into the edge table
    std::int64_t first_pinched_vertex = -1;
    std::int64_t first_degenerate_triangle = -1;

    bool is_oriented_manifold() const {
        return num_complex_edges == 0 && num_misoriented_edges == 0 && num_pinched_vertices == 0 &&
               num_degenerate_triangles == 0;
    }
};
TopologyReport inspect_topology(const EdgeTable& table, const TrianglesRef& triangles,
                                Index num_vertices);

}  // namespace mien
