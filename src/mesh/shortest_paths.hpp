// Dijkstra's algorithm (1959) along the edges of a mesh, from one or many sources.
#pragma once

#include <functional>
#include <queue>
#include <vector>

#include "mesh/adjacency.hpp"

namespace mien {

/// Directed edges with lengths, packed by their start. Two vertices may have several edges (an
/// intrinsic triangulation has).
struct PathGraph {
    struct Edge {
        std::uint32_t to;
        double length;  ///< >= 0, mm unless the maker says otherwise
    };
    std::vector<std::uint32_t> begin;  ///< #V + 1 offsets into `edges`
    std::vector<Edge> edges;
};

/// The rings' edges with their straight lengths between `vertices`, #V x 3. O(#E).
PathGraph build_path_graph(const PointsRef& vertices, const VertexRings& rings);

/// A vertex with its final distance.
struct ReachedVertex {
    double path;
    std::uint32_t vertex;
    std::uint32_t source;  ///< the source that this path begins at

    bool operator>(const ReachedVertex& other) const {
        return path != other.path ? path > other.path : vertex > other.vertex;
    }
};

/// Calls `visit(const ReachedVertex&)` once for each vertex whose distance to `sources` is at most
/// `most` and below what `distance` (#V) held before; nearest first, equal ones by number.
/// `distance` is lowered to the new values, so infinity everywhere starts anew, and what an earlier
/// call left there makes the walk end where the earlier sources are nearer. O(visited edges log
/// visited).
template <typename Visit>
void walk_paths(const PathGraph& graph, const std::vector<std::uint32_t>& sources, double most,
                std::vector<double>& distance, const Visit& visit) {
    std::priority_queue<ReachedVertex, std::vector<ReachedVertex>, std::greater<>> front;
    for (const std::uint32_t source : sources) {
        distance[source] = 0;
        front.push({0, source, source});
    }
    while (!front.empty()) {
        const ReachedVertex at = front.top();
        front.pop();
        if (at.path > distance[at.vertex]) continue;  // a nearer path came up meanwhile
        visit(at);
        for (std::uint32_t e = graph.begin[at.vertex]; e < graph.begin[at.vertex + 1]; ++e) {
            const PathGraph::Edge& edge = graph.edges[e];
            const double path = at.path + edge.length;
            if (path > most || !(path < distance[edge.to])) continue;
            distance[edge.to] = path;
            front.push({path, edge.to, at.source});
        }
    }
}

}  // namespace mien
