#include "mesh/adjacency.hpp"

#include <algorithm>
#include <numeric>

namespace mien {

VertexRings build_rings(Index num_vertices, const TrianglesRef& triangles) {
    // Both neighbours of every corner, packed by vertex; then each ring sorted and shrunk in place.
    std::vector<std::uint32_t> start(static_cast<std::size_t>(num_vertices) + 1, 0);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) start[triangles(t, k) + 1] += 2;
    std::partial_sum(start.begin(), start.end(), start.begin());
    VertexRings rings;
    rings.neighbours.resize(start.back());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            for (int other = 1; other < 3; ++other)
                rings.neighbours[next[triangles(t, k)]++] = triangles(t, (k + other) % 3);
    rings.begin.assign(start.size(), 0);
    auto kept = rings.neighbours.begin();
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
        const auto first = rings.neighbours.begin() + start[v];
        auto last = rings.neighbours.begin() + start[v + 1];
        std::sort(first, last);
        last = std::unique(first, last);
        // A vertex is no neighbour of its own.
        kept = std::copy_if(first, last, kept, [v](std::uint32_t other) { return other != v; });
        rings.begin[v + 1] = static_cast<std::uint32_t>(kept - rings.neighbours.begin());
    }
    rings.neighbours.erase(kept, rings.neighbours.end());
    return rings;
}

IncidentTriangles incident_triangles(Index num_vertices, const TrianglesRef& triangles) {
    IncidentTriangles incident;
    incident.begin.assign(static_cast<std::size_t>(num_vertices) + 1, 0);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) ++incident.begin[triangles(t, k) + 1];
    std::partial_sum(incident.begin.begin(), incident.begin.end(), incident.begin.begin());
    incident.triangles.resize(incident.begin.back());
    std::vector<std::uint32_t> next(incident.begin.begin(), incident.begin.end() - 1);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            incident.triangles[next[triangles(t, k)]++] = static_cast<std::uint32_t>(t);
    return incident;
}

const std::vector<std::uint32_t>& RingWalker::within(std::uint32_t start, Index num_edges) {
    ++stamp_;
    found_.assign(1, start);
    seen_[start] = stamp_;
    std::size_t begin = 0;
    for (Index step = 0; step < num_edges; ++step) {
        const std::size_t end = found_.size();
        for (; begin < end; ++begin)
            for (const std::uint32_t next : rings_.of(found_[begin]))
                if (seen_[next] != stamp_) {
                    seen_[next] = stamp_;
                    found_.push_back(next);
                }
    }
    return found_;
}

}  // namespace mien
