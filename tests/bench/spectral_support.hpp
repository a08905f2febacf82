// Meshes and clocks for the programs that measure the spectral room.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <map>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "mesh/tri_mesh.hpp"

namespace mien::bench {

/// Processor seconds of the whole process: fair on a machine that others use too.
inline double cpu_seconds() {
    std::timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
inline double wall_seconds() {
    std::timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Splits the longest edges at their middles until the mesh has num_vertices vertices.
inline TriMesh refined(const TriMesh& mesh, Index num_vertices) {
    std::vector<Vector3> points;
    for (Index v = 0; v < mesh.vertices.rows(); ++v) points.push_back(mesh.vertices.row(v));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (Index f = 0; f < mesh.triangles.rows(); ++f)
        triangles.push_back({mesh.triangles(f, 0), mesh.triangles(f, 1), mesh.triangles(f, 2)});
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Edge, std::vector<std::size_t>> around;
    std::priority_queue<std::pair<double, Edge>> longest;
    const auto edge = [](std::uint32_t a, std::uint32_t b) {
        return Edge(std::min(a, b), std::max(a, b));
    };
    const auto add = [&](std::size_t f) {
        for (int c = 0; c < 3; ++c) {
            const Edge e = edge(triangles[f][c], triangles[f][(c + 1) % 3]);
            auto& list = around[e];
            if (list.empty()) longest.push({(points[e.first] - points[e.second]).norm(), e});
            list.push_back(f);
        }
    };
    const auto remove = [&](std::size_t f) {
        for (int c = 0; c < 3; ++c) {
            auto& list = around[edge(triangles[f][c], triangles[f][(c + 1) % 3])];
            list.erase(std::find(list.begin(), list.end(), f));
        }
    };
    for (std::size_t f = 0; f < triangles.size(); ++f) add(f);
    while (static_cast<Index>(points.size()) < num_vertices) {
        const Edge e = longest.top().second;
        longest.pop();
        const std::vector<std::size_t> faces = around[e];
        if (faces.empty()) continue;
        const auto middle = static_cast<std::uint32_t>(points.size());
        points.push_back(0.5 * (points[e.first] + points[e.second]));
        for (const std::size_t f : faces) {
            auto other = triangles[f];
            remove(f);
            for (int c = 0; c < 3; ++c) {
                if (triangles[f][c] == e.second) triangles[f][c] = middle;
                if (other[c] == e.first) other[c] = middle;
            }
            triangles.push_back(other);
            add(f);
            add(triangles.size() - 1);
        }
    }
    TriMesh out;
    out.vertices.resize(static_cast<Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        out.vertices.row(static_cast<Index>(v)) = points[v].transpose();
    out.triangles.resize(static_cast<Index>(triangles.size()), 3);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int c = 0; c < 3; ++c) out.triangles(static_cast<Index>(f), c) = triangles[f][c];
    return out;
}

}  // namespace mien::bench
