#include "registration/inner.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kProbes_mm[] = {1, 2, 3, 4.5, 6, 8};
constexpr int kRays = 16, kOpenRays = 4;
constexpr double kSight_mm = 60;
constexpr double kReach_mm = 15, kSpread_mm = 4, kBlend_mm = 2;

/// True when fewer than kOpenRays of kRays directions about the normal (as many as their cosine weighs)
/// lead out.
bool is_enclosed(const TriangleTree& tree, const Vector3& place, const Vector3& normal) {
    const Vector3 side = normal.unitOrthogonal(), up = normal.cross(side);
    int open = 0;
    for (int k = 0; k < kRays; ++k) {
        const double squared = (k + 0.5) / kRays, turn = 2.399963229728653 * k;  // a sunflower's spiral
        const double radius = std::sqrt(squared);
        const Vector3 direction = radius * (std::cos(turn) * side + std::sin(turn) * up) + std::sqrt(1 - squared) * normal;
        open += !tree.first_hit(place + 0.05 * normal, direction, kSight_mm).valid();
    }
    return open < kOpenRays;
}

}  // namespace

std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const Context& context) {
    const Points& places = mesh.vertices;
    const Points normals = vertex_normals(places, mesh.triangles), faces = triangle_normals(places, mesh.triangles);
    const TriangleTree tree(places, mesh.triangles, context);
    std::vector<std::uint8_t> inner(static_cast<std::size_t>(places.rows()), 0);
    parallel_for(context, inner.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = static_cast<Index>(i);
            const Vector3 place = places.row(v).transpose(), normal = normals.row(v).transpose();
            // A ball that rests on open skin touches nothing else; between two walls it meets the other one.
            for (const double radius : kProbes_mm) {
                const SurfaceHit hit = tree.closest(place + radius * normal, 0.7 * radius);
                if (!hit.valid()) continue;
                const Vector3 other = faces.row(static_cast<Index>(hit.triangle)).transpose();
                if (normal.dot(other) >= -0.4 * other.norm()) continue;
                inner[i] = is_enclosed(tree, place, normal);
                break;
            }
        }
    });
    return inner;
}

void carry_inner(const Points& rest, const std::vector<std::uint8_t>& inner, Points& places,
                 const Context& context) {
    std::vector<Index> open, hidden;
    for (std::size_t i = 0; i < inner.size(); ++i) (inner[i] ? hidden : open).push_back(static_cast<Index>(i));
    if (open.empty()) return;
    const Points moved = places - rest;
    parallel_for(context, hidden.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index v = hidden[k];
            Vector3 sum = Vector3::Zero();
            double weights = 0, nearest = kReach_mm * kReach_mm;
            for (const Index j : open) {
                const double squared = (rest.row(j) - rest.row(v)).squaredNorm();
                if (squared >= kReach_mm * kReach_mm) continue;
                const double weight = std::exp(-0.5 * squared / (kSpread_mm * kSpread_mm));
                sum += weight * moved.row(j).transpose();
                weights += weight;
                nearest = std::min(nearest, squared);
            }
            if (!(weights > 0)) continue;
            const double blend = std::min(1.0, std::sqrt(nearest) / kBlend_mm);
            places.row(v) += blend * ((sum / weights).transpose() - moved.row(v));
        }
    });
}

}  // namespace mien
