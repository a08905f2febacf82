#include "measure/lengths.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "geometry/heat_method.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

/// The gradient of a distance at a vertex: of each triangle around it, weighted with its area, made
/// a unit vector (a distance grows by one per mm).
Vector3 growth_at(const PointsRef& vertices, const TrianglesRef& triangles,
                  const Eigen::Ref<const Eigen::VectorXf>& distance, std::uint32_t vertex) {
    Vector3 sum = Vector3::Zero();
    for (Index t = 0; t < triangles.rows(); ++t) {
        if (triangles(t, 0) != vertex && triangles(t, 1) != vertex && triangles(t, 2) != vertex)
            continue;
        std::array<Vector3, 3> p;
        std::array<double, 3> d;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = triangles(t, static_cast<Index>(k));
            p[k] = vertices.row(v).transpose();
            d[k] = static_cast<double>(distance[v]);
        }
        const Vector3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const double twice_area = normal.norm();
        if (!(twice_area > 0)) continue;
        // Sum over corners of d times the edge opposite, turned: area times the gradient, twice.
        Vector3 turned = Vector3::Zero();
        for (std::size_t k = 0; k < 3; ++k) turned += d[k] * (p[(k + 2) % 3] - p[(k + 1) % 3]);
        sum += (normal / twice_area).cross(turned);
    }
    const double length = sum.norm();
    return length > 0 && std::isfinite(length) ? Vector3(sum / length) : Vector3::Zero();
}

}  // namespace

std::vector<SurfaceLength> surface_lengths(const PointsRef& vertices, const TrianglesRef& triangles,
                                           const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                           const Context& context) {
    check_surface(vertices, triangles, "the surface");
    std::vector<std::uint32_t> ends;
    for (std::size_t k = 0; k < pairs.size(); ++k)
        for (const std::uint32_t end : pairs[k]) {
            if (end >= static_cast<std::uint64_t>(vertices.rows()))
                fail_at(Status::mismatch, static_cast<std::int64_t>(k),
                        "pair %zu names vertex %u of %lld", k, end,
                        static_cast<long long>(vertices.rows()));
            ends.push_back(end);
        }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<SurfaceLength> lengths(pairs.size());
    if (pairs.empty()) return lengths;
    context.require_memory(static_cast<std::size_t>(vertices.rows()) * ends.size() * sizeof(float),
                           "geodesic distances");
    const HeatGeodesics geodesics(vertices, triangles, HeatOptions(), context);
    Eigen::MatrixXf distances(vertices.rows(), static_cast<Index>(ends.size()));
    geodesics.distances(ends, distances, context);
    const auto column = [&](std::uint32_t end) {
        return static_cast<Index>(std::lower_bound(ends.begin(), ends.end(), end) - ends.begin());
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [a, b] = pairs[k];
        if (a == b) continue;
        // There and back differ by the method's error: their mean, which must not make a way along
        // the surface shorter than the straight one.
        const double there = static_cast<double>(distances(b, column(a))),
                     back = static_cast<double>(distances(a, column(b)));
        const double straight = (vertices.row(a) - vertices.row(b)).norm();
        lengths[k].mm = std::max(0.5 * (there + back), straight);
        if (!std::isfinite(lengths[k].mm)) continue;
        lengths[k].growth = {{growth_at(vertices, triangles, distances.col(column(b)), a),
                              growth_at(vertices, triangles, distances.col(column(a)), b)}};
    }
    return lengths;
}

std::vector<PlaceLength> measure_lengths(const PointsRef& vertices, const TrianglesRef& triangles,
                                         const std::vector<std::array<std::uint32_t, 2>>& pairs,
                                         const Context& context) {
    const std::vector<SurfaceLength> along = surface_lengths(vertices, triangles, pairs, context);
    std::vector<PlaceLength> lengths(pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [from, to] = pairs[k];
        lengths[k].straight_mm = (vertices.row(from) - vertices.row(to)).norm();
        lengths[k].geodesic_mm = along[k].mm;
    }
    return lengths;
}

}  // namespace mien
