#include "mesh/shortest_paths.hpp"

namespace mien {

PathGraph build_path_graph(const PointsRef& vertices, const VertexRings& rings) {
    PathGraph graph;
    graph.begin = rings.begin;
    graph.edges.reserve(rings.neighbours.size());
    for (Index v = 0; v < rings.num_vertices(); ++v)
        for (const std::uint32_t other : rings.of(static_cast<std::size_t>(v)))
            graph.edges.push_back({other, (vertices.row(other) - vertices.row(v)).norm()});
    return graph;
}

}  // namespace mien
