#include "measure/pair_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/length_unit.hpp"

namespace mien {
namespace {

/// Vertices of a zone from which on it is asked to be a patch: a few picked points are none.
constexpr std::size_t kFewestOfPatch = 20;
/// Least share of a patch's vertices in triangles of its own. Zones on their own template: 0.94 and
/// more on both populations; 0.0 to 0.64, median 0.28, with the numbers of another [J].
constexpr double kLeastOfPatch = 0.5;

void check_points(const PointsRef& points, const char* what) {
    if (points.rows() == 0)
        fail(Status::invalid_mesh, "%s has no vertices; give a mesh with vertices and triangles",
             what);
    for (Index v = 0; v < points.rows(); ++v)
        if (!std::isfinite(points(v, 0)) || !std::isfinite(points(v, 1)) ||
            !std::isfinite(points(v, 2)))
            fail_at(Status::invalid_mesh, v,
                    "vertex %lld of %s is not finite; repair the mesh or drop the vertex",
                    static_cast<long long>(v), what);
}

}  // namespace

void check_surface(const PointsRef& vertices, const TrianglesRef& triangles, const char* what) {
    check_points(vertices, what);
    if (triangles.rows() == 0)
        fail(Status::invalid_mesh, "%s has no triangles; a point cloud has no surface to measure",
             what);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            if (static_cast<Index>(triangles(t, k)) >= vertices.rows())
                fail_at(Status::invalid_mesh, t,
                        "triangle %lld of %s names vertex %u, but there are %lld vertices",
                        static_cast<long long>(t), what, triangles(t, k),
                        static_cast<long long>(vertices.rows()));
}

void check_faces_in_correspondence(const PointsRef& before, const PointsRef& after,
                                   const TrianglesRef& triangles) {
    if (before.rows() != after.rows())
        fail(Status::mismatch,
             "the before face has %lld vertices, the after face %lld; both must be fitted with the "
             "same template",
             static_cast<long long>(before.rows()), static_cast<long long>(after.rows()));
    check_surface(before, triangles, "the before face");
    check_points(after, "the after face");
    check_same_unit(before, "the before face", after, "the after face");
}

void check_zones(const std::vector<Zone>& zones, Index num_vertices) {
    for (const Zone& zone : zones)
        for (std::uint32_t v : zone.vertices)
            if (static_cast<Index>(v) >= num_vertices)
                fail_at(Status::mismatch, v,
                        "zone %.60s names vertex %u, but the face has %lld vertices; use the zones "
                        "of this template",
                        zone.name.c_str(), v, static_cast<long long>(num_vertices));
}

void check_patches(const std::vector<Zone>& zones, const TrianglesRef& triangles,
                   Index num_vertices) {
    check_zones(zones, num_vertices);
    for (const Zone& zone : zones) {
        if (zone.vertices.size() < kFewestOfPatch) continue;
        const std::vector<char> inside = membership(zone.vertices, num_vertices);
        std::vector<char> joined(inside.size(), 0);
        for (Index t = 0; t < triangles.rows(); ++t)
            if (inside[triangles(t, 0)] && inside[triangles(t, 1)] && inside[triangles(t, 2)])
                for (int k = 0; k < 3; ++k) joined[triangles(t, k)] = 1;
        const auto in_zone = std::count(inside.begin(), inside.end(), 1);
        const auto in_patch = std::count(joined.begin(), joined.end(), 1);
        if (static_cast<double>(in_patch) < kLeastOfPatch * static_cast<double>(in_zone))
            fail(Status::mismatch,
                 "zone %.60s is scattered over the face: only %lld of its %lld vertices lie in a "
                 "triangle of it, so it is the zone of another template; use the zones of this one",
                 zone.name.c_str(), static_cast<long long>(in_patch),
                 static_cast<long long>(in_zone));
    }
}

std::vector<char> membership(const std::vector<std::uint32_t>& vertices, Index num_vertices) {
    std::vector<char> inside(static_cast<std::size_t>(num_vertices), 0);
    for (std::uint32_t v : vertices) {
        if (static_cast<Index>(v) >= num_vertices)
            fail_at(Status::mismatch, v, "vertex %u is beyond the face's %lld vertices", v,
                    static_cast<long long>(num_vertices));
        inside[v] = 1;
    }
    return inside;
}

}  // namespace mien
