#include "registration/inner.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <functional>
#include <limits>
#include <queue>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kProbes_mm[] = {1, 2, 3, 4.5, 6, 8};
constexpr int kRays = 16, kOpenRays = 4;
constexpr double kSight_mm = 60;
constexpr double kReach_mm = 15, kSpread_mm = 6, kBlend_mm = 2, kRidge_mm2 = 4;
constexpr double kNearPath_mm = 20, kFarPath_mm = 40, kWhisper = 1e-3;
constexpr double kFar = std::numeric_limits<double>::infinity();

/// True when fewer than kOpenRays of kRays directions about the normal (as many as their cosine
/// weighs) lead out.
bool is_enclosed(const TriangleTree& tree, const Vector3& place, const Vector3& normal) {
    const Vector3 side = normal.unitOrthogonal(), up = normal.cross(side);
    int open = 0;
    for (int k = 0; k < kRays; ++k) {
        const double squared = (k + 0.5) / kRays,
                     turn = 2.399963229728653 * k;  // a sunflower's spiral
        const double radius = std::sqrt(squared);
        const Vector3 direction = radius * (std::cos(turn) * side + std::sin(turn) * up) +
                                  std::sqrt(1 - squared) * normal;
        open += !tree.first_hit(place + 0.05 * normal, direction, kSight_mm).valid();
    }
    return open < kOpenRays;
}

}  // namespace

std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const Context& context) {
    const Points& places = mesh.vertices;
    const Points normals = vertex_normals(places, mesh.triangles),
                 faces = triangle_normals(places, mesh.triangles);
    const TriangleTree tree(places, mesh.triangles, context);
    std::vector<std::uint8_t> inner(static_cast<std::size_t>(places.rows()), 0);
    parallel_for(context, inner.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = static_cast<Index>(i);
            const Vector3 place = places.row(v).transpose(), normal = normals.row(v).transpose();
            // A ball that rests on open skin touches nothing else; between two walls it meets the
            // other one.
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

namespace {

struct Reached {
    double path_mm;
    Index vertex, source;
    bool operator>(const Reached& other) const {
        return path_mm != other.path_mm ? path_mm > other.path_mm : vertex > other.vertex;
    }
};

// Dijkstra's algorithm along the edges from all `sources`: calls visit(Reached) once per vertex
// within `most_mm`, nearest first. `path_mm`: #V, infinite before and again after.
template <typename Visit>
void walk(const Points& places, const VertexRings& rings, const std::vector<Index>& sources,
          double most_mm, std::vector<double>& path_mm, const Visit& visit) {
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    std::vector<Index> touched;
    for (const Index source : sources) {
        path_mm[static_cast<std::size_t>(source)] = 0;
        touched.push_back(source);
        front.push({0, source, source});
    }
    while (!front.empty()) {
        const Reached at = front.top();
        front.pop();
        if (at.path_mm > path_mm[static_cast<std::size_t>(at.vertex)]) continue;
        visit(at);
        const std::size_t v = static_cast<std::size_t>(at.vertex);
        for (std::uint32_t k = rings.begin[v]; k < rings.begin[v + 1]; ++k) {
            const Index next = static_cast<Index>(rings.neighbours[k]);
            const double path = at.path_mm + (places.row(next) - places.row(at.vertex)).norm();
            if (path > most_mm || path >= path_mm[static_cast<std::size_t>(next)]) continue;
            path_mm[static_cast<std::size_t>(next)] = path;
            touched.push_back(next);
            front.push({path, next, at.source});
        }
    }
    for (const Index v : touched) path_mm[static_cast<std::size_t>(v)] = kFar;
}

// A vertex of the open skin and its say.
struct Carrier {
    Index vertex;
    double weight;
};

}  // namespace

void carry_inner(const TriMesh& template_mesh, const VertexRings& rings, const Points& rest,
                 const std::vector<std::uint8_t>& inner, Points& places, const Context& context) {
    const std::size_t n = inner.size();
    std::vector<Index> open, hidden;
    for (std::size_t i = 0; i < n; ++i) (inner[i] ? hidden : open).push_back(static_cast<Index>(i));
    if (open.empty() || hidden.empty()) return;

    // The skin that each inner vertex hangs on: the open vertex nearest to it along the surface, if
    // there is one.
    std::vector<double> path_mm(n, kFar);
    std::vector<Index> root(n, -1);
    walk(template_mesh.vertices, rings, open, kFar, path_mm,
         [&](const Reached& at) { root[static_cast<std::size_t>(at.vertex)] = at.source; });
    std::vector<std::vector<Carrier>> around(n);  // of the roots
    for (const Index v : hidden) {
        const Index from = root[static_cast<std::size_t>(v)];
        if (from < 0 || !around[static_cast<std::size_t>(from)].empty()) continue;
        std::vector<Carrier>& carriers = around[static_cast<std::size_t>(from)];
        walk(template_mesh.vertices, rings, {from}, kFarPath_mm, path_mm, [&](const Reached& at) {
            if (!inner[static_cast<std::size_t>(at.vertex)])
                carriers.push_back(
                    {at.vertex, fade((kFarPath_mm - at.path_mm) / (kFarPath_mm - kNearPath_mm))});
        });
        context.check_cancelled();
    }
    // All the other skin whispers: it is heard where nothing along the surface is within reach.
    std::vector<Carrier> all;
    for (const Index v : open) all.push_back({v, kWhisper});

    const Points moved = places - rest;
    parallel_for(context, hidden.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index v = hidden[k], from = root[static_cast<std::size_t>(v)];
            Vector3 sum = Vector3::Zero(), place = Vector3::Zero();
            Matrix3 spread = Matrix3::Zero(), drift = Matrix3::Zero();
            double weights = 0, nearest = kReach_mm * kReach_mm;
            const auto listen = [&](const std::vector<Carrier>& carriers) {
                for (const Carrier& carrier : carriers) {
                    const Vector3 off = (rest.row(carrier.vertex) - rest.row(v)).transpose();
                    const Vector3 moves = moved.row(carrier.vertex).transpose();
                    const double squared = off.squaredNorm();
                    if (squared >= kReach_mm * kReach_mm) continue;
                    const double weight =
                        carrier.weight * std::exp(-0.5 * squared / (kSpread_mm * kSpread_mm));
                    sum += weight * moves;
                    place += weight * off;
                    spread += weight * off * off.transpose();
                    drift += weight * moves * off.transpose();
                    weights += weight;
                    nearest = std::min(nearest, squared);
                }
            };
            listen(all);
            if (from >= 0) listen(around[static_cast<std::size_t>(from)]);
            if (!(weights > 0)) continue;
            const double blend = std::min(1.0, std::sqrt(nearest) / kBlend_mm);
            sum /= weights;
            place /= weights;
            spread = spread / weights - place * place.transpose();
            drift = drift / weights - sum * place.transpose();
            const Vector3 carried =
                sum - drift * (spread + kRidge_mm2 * Matrix3::Identity()).inverse() * place;
            places.row(v) += blend * (carried.transpose() - moved.row(v));
        }
    });
}

}  // namespace mien
