// Which vertices share an edge, of any triangle soup. Ordered by vertex number, so equal input
// gives equal output.
#pragma once

#include <cstdint>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// Borrowed run of vertex numbers; valid as long as the rings it came from.
struct VertexSpan {
    const std::uint32_t* first = nullptr;
    const std::uint32_t* last = nullptr;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
};

/// Neighbours of every vertex, packed. Each pair of neighbours once per side, ascending; a side
/// that connects a vertex with itself makes no neighbour.
struct VertexRings {
    std::vector<std::uint32_t> begin;       ///< #V + 1 offsets into `neighbours`
    std::vector<std::uint32_t> neighbours;  ///< ascending within a vertex

    Index num_vertices() const { return static_cast<Index>(begin.size()) - 1; }
    VertexSpan of(std::size_t vertex) const {
        return {neighbours.data() + begin[vertex], neighbours.data() + begin[vertex + 1]};
    }
};

/// Triangle indices must be below `num_vertices` (check_mesh()). O(#F log degree), 48 bytes per
/// triangle while it works.
VertexRings build_rings(Index num_vertices, const TrianglesRef& triangles);

/// Triangles at every vertex, packed, ascending; a triangle that names a vertex twice comes twice.
struct IncidentTriangles {
    std::vector<std::uint32_t> begin;      ///< #V + 1 offsets into `triangles`
    std::vector<std::uint32_t> triangles;  ///< ascending within a vertex

    VertexSpan of(std::size_t vertex) const {
        return {triangles.data() + begin[vertex], triangles.data() + begin[vertex + 1]};
    }
};
IncidentTriangles incident_triangles(Index num_vertices, const TrianglesRef& triangles);

/// Collects the vertices within some number of edges of a vertex; holds its workspace, so that many
/// small balls on one large mesh cost what they hold and not #V each. One per thread.
class RingWalker {
  public:
    explicit RingWalker(const VertexRings& rings)
        : rings_(rings), seen_(static_cast<std::size_t>(rings.num_vertices()), 0) {}

    /// `start` first, then by number of edges from it. Valid until the next call.
    const std::vector<std::uint32_t>& within(std::uint32_t start, Index num_edges);

  private:
    const VertexRings& rings_;
    std::vector<std::uint32_t> seen_, found_;
    std::uint32_t stamp_ = 0;
};

}  // namespace mien
