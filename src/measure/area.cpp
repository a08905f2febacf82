#include "measure/area.hpp"

#include <algorithm>
#include <cstdint>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

struct HalfEdge {
    std::uint32_t low, high;
    bool forward;  // runs from low to high
    bool operator<(const HalfEdge& other) const {
        if (low != other.low) return low < other.low;
        if (high != other.high) return high < other.high;
        return forward < other.forward;
    }
};

std::vector<HalfEdge> sorted_half_edges(const TrianglesRef& triangles) {
    std::vector<HalfEdge> edges;
    edges.reserve(static_cast<std::size_t>(triangles.rows()) * 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = triangles(t, k), to = triangles(t, (k + 1) % 3);
            if (from == to) continue;  // a collapsed triangle encloses nothing
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
}

// The open half-edges' starts and ends, in the sense of their own triangle.
std::vector<std::pair<std::uint32_t, std::uint32_t>> open_half_edges(
    const TrianglesRef& triangles) {
    const std::vector<HalfEdge> edges = sorted_half_edges(triangles);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i + 1;
        while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high)
            ++j;
        if (j - i == 1)
            open.emplace_back(edges[i].forward ? edges[i].low : edges[i].high,
                              edges[i].forward ? edges[i].high : edges[i].low);
        i = j;
    }
    return open;
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
    while (parent[v] != v) {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    return v;
}

}  // namespace

Vector vertex_areas(const PointsRef& vertices, const TrianglesRef& triangles) {
    Vector areas = Vector::Zero(vertices.rows());
    for (Index t = 0; t < triangles.rows(); ++t) {
        const Vector3 a = vertices.row(triangles(t, 0));
        const Vector3 ab = Vector3(vertices.row(triangles(t, 1))) - a;
        const Vector3 ac = Vector3(vertices.row(triangles(t, 2))) - a;
        const double third = ab.cross(ac).norm() / 6.0;
        for (int k = 0; k < 3; ++k) areas[triangles(t, k)] += third;
    }
    return areas;
}

double surface_area_mm2(const PointsRef& vertices, const TrianglesRef& triangles) {
    check_surface(vertices, triangles, "the mesh");
    return vertex_areas(vertices, triangles).sum();
}

std::vector<ZoneArea> zone_areas(const PointsRef& vertices, const TrianglesRef& triangles,
                                 const std::vector<Zone>& zones) {
    check_surface(vertices, triangles, "the mesh");
    check_patches(zones, triangles, vertices.rows());
    const Vector areas = vertex_areas(vertices, triangles);
    std::vector<ZoneArea> result;
    for (const Zone& zone : zones) {
        const std::vector<char> inside = membership(zone.vertices, vertices.rows());
        ZoneArea entry{zone.name, 0.0};
        for (Index v = 0; v < vertices.rows(); ++v)
            if (inside[static_cast<std::size_t>(v)]) entry.area_mm2 += areas[v];
        result.push_back(entry);
    }
    return result;
}

Points area_gradient(const PointsRef& vertices, const TrianglesRef& triangles,
                     const std::vector<char>& inside) {
    if (static_cast<Index>(inside.size()) != vertices.rows())
        fail(Status::mismatch, "a set over %zu vertices for %lld", inside.size(),
             static_cast<long long>(vertices.rows()));
    Points gradient = Points::Zero(vertices.rows(), 3);
    for (Index t = 0; t < triangles.rows(); ++t) {
        double share = 0.0;
        for (int k = 0; k < 3; ++k) share += inside[triangles(t, k)] / 3.0;
        if (!(share > 0)) continue;
        Vector3 corner[3];
        for (int k = 0; k < 3; ++k) corner[k] = vertices.row(triangles(t, k));
        const Vector3 doubled = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
        const double length = doubled.norm();
        if (!(length > 0)) continue;  // a collapsed triangle has no direction to grow in
        for (int k = 0; k < 3; ++k)   // half the opposite edge, turned by a right angle
            gradient.row(triangles(t, k)) +=
                share * 0.5 *
                (doubled / length).cross(corner[(k + 2) % 3] - corner[(k + 1) % 3]).transpose();
    }
    return gradient;
}

ClosureReport examine_closure(const TrianglesRef& triangles, Index num_vertices) {
    (void)num_vertices;
    const std::vector<HalfEdge> edges = sorted_half_edges(triangles);
    ClosureReport report;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i + 1;
        while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high)
            ++j;
        if (j - i == 1)
            ++report.open_edges;
        else if (j - i > 2)
            ++report.non_manifold_edges;
        else if (edges[i].forward == edges[i + 1].forward)
            ++report.inconsistent_edges;
        i = j;
    }
    return report;
}

double closed_volume_ml(const PointsRef& vertices, const TrianglesRef& triangles, OpenRims rims,
                        const Context& context) {
    check_surface(vertices, triangles, "the mesh");
    const ClosureReport closure = examine_closure(triangles, vertices.rows());
    if (closure.non_manifold_edges > 0 || closure.inconsistent_edges > 0)
        fail(Status::invalid_mesh,
             "%lld edges of the mesh have three or more triangles and %lld have two that disagree "
             "about outside; such a mesh encloses no volume, clean it first",
             static_cast<long long>(closure.non_manifold_edges),
             static_cast<long long>(closure.inconsistent_edges));
    if (closure.open_edges > 0 && rims == OpenRims::refuse)
        fail(Status::invalid_mesh,
             "the mesh has %lld open edges and encloses no volume; close it, or let the rims be "
             "closed by fans",
             static_cast<long long>(closure.open_edges));

    const Vector3 origin = vertices.colwise().mean();
    const std::size_t count = static_cast<std::size_t>(triangles.rows());
    double six_volumes =
        parallel_sum(context, count, 4096, 0.0, [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (Index t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t) {
                const Vector3 a = Vector3(vertices.row(triangles(t, 0))) - origin;
                const Vector3 b = Vector3(vertices.row(triangles(t, 1))) - origin;
                const Vector3 c = Vector3(vertices.row(triangles(t, 2))) - origin;
                sum += a.dot(b.cross(c));
            }
            return sum;
        });
    if (closure.open_edges > 0) {
        // Rims are the connected sets of open edges; the fan runs against its neighbour's edge.
        const auto open = open_half_edges(triangles);
        std::vector<std::uint32_t> parent(static_cast<std::size_t>(vertices.rows()));
        for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<std::uint32_t>(v);
        for (const auto& edge : open)
            parent[find_root(parent, edge.first)] = find_root(parent, edge.second);
        // On a rim each vertex starts exactly as many open edges as it ends; averaging the starts
        // gives the mean of its vertices.
        std::vector<Vector3> sums(parent.size(), Vector3::Zero());
        std::vector<int> counts(parent.size(), 0);
        for (const auto& edge : open) {
            const std::uint32_t root = find_root(parent, edge.first);
            sums[root] += Vector3(vertices.row(edge.first)) - origin;
            ++counts[root];
        }
        for (const auto& edge : open) {
            const std::uint32_t root = find_root(parent, edge.first);
            const Vector3 apex = sums[root] / counts[root];
            const Vector3 from = Vector3(vertices.row(edge.first)) - origin;
            const Vector3 to = Vector3(vertices.row(edge.second)) - origin;
            six_volumes += apex.dot(to.cross(from));
        }
    }
    return six_volumes / 6.0 * 1e-3;
}

}  // namespace mien
