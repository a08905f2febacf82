#include "registration/inner.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"
#include "mesh/shortest_paths.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// True when fewer than open_rays of the directions about the normal lead out.
bool is_enclosed(const TriangleTree& tree, const Vector3& place, const Vector3& normal,
                 const InnerSettings& settings) {
    constexpr double kGolden_rad = 2.399963229728653;  // the golden angle: a sunflower's spiral
    const Vector3 side = normal.unitOrthogonal(), up = normal.cross(side);
    int open = 0;
    for (int k = 0; k < settings.rays; ++k) {
        const double squared = (k + 0.5) / settings.rays, turn = kGolden_rad * k;
        const double radius = std::sqrt(squared);
        const Vector3 direction = radius * (std::cos(turn) * side + std::sin(turn) * up) +
                                  std::sqrt(1 - squared) * normal;
        open += !tree.first_hit(place + settings.lift_mm * normal, direction, settings.sight_mm)
                     .valid();
    }
    return open < settings.open_rays;
}

// A vertex of the open skin and its weight.
struct Carrier {
    Index vertex;
    double weight;
};

// What each inner vertex goes by: the open vertex nearest to it along the surface, if there is one,
// and the open skin around that.
struct Hanging {
    std::vector<Index> root;                   // #V, or -1
    std::vector<std::vector<Carrier>> around;  // #V, of the roots
};

Hanging find_hanging(const TriMesh& mesh, const VertexRings& rings,
                     const std::vector<std::uint8_t>& inner, const std::vector<std::uint32_t>& open,
                     const std::vector<Index>& hidden, const InnerSettings& settings,
                     const Context& context) {
    const std::size_t n = inner.size();
    const PathGraph graph = build_path_graph(mesh.vertices, rings);
    Hanging hanging{std::vector<Index>(n, -1), std::vector<std::vector<Carrier>>(n)};
    std::vector<double> path_mm(n, kFar);
    walk_paths(graph, open, kFar, path_mm, [&](const ReachedVertex& at) {
        hanging.root[at.vertex] = static_cast<Index>(at.source);
    });
    std::fill(path_mm.begin(), path_mm.end(), kFar);
    std::vector<std::uint32_t> touched;
    for (const Index v : hidden) {
        const Index from = hanging.root[static_cast<std::size_t>(v)];
        if (from < 0 || !hanging.around[static_cast<std::size_t>(from)].empty()) continue;
        std::vector<Carrier>& carriers = hanging.around[static_cast<std::size_t>(from)];
        touched.clear();
        walk_paths(
            graph, {static_cast<std::uint32_t>(from)}, settings.far_path_mm, path_mm,
            [&](const ReachedVertex& at) {
                touched.push_back(at.vertex);
                if (!inner[at.vertex])
                    carriers.push_back({static_cast<Index>(at.vertex),
                                        fade((settings.far_path_mm - at.path) /
                                             (settings.far_path_mm - settings.near_path_mm))});
            });
        for (const std::uint32_t t : touched) path_mm[t] = kFar;
        context.check_cancelled();
    }
    return hanging;
}

// Sums of one inner vertex' regression.
struct Regression {
    Vector3 sum = Vector3::Zero(), place = Vector3::Zero();
    Matrix3 spread = Matrix3::Zero(), drift = Matrix3::Zero();
    double weights = 0, nearest;

    explicit Regression(double reach_mm) : nearest(reach_mm * reach_mm) {}

    void add(const std::vector<Carrier>& carriers, const Points& rest, const Points& moved, Index v,
             const InnerSettings& settings) {
        for (const Carrier& carrier : carriers) {
            const Vector3 off = (rest.row(carrier.vertex) - rest.row(v)).transpose();
            const Vector3 moves = moved.row(carrier.vertex).transpose();
            const double squared = off.squaredNorm();
            if (squared >= settings.reach_mm * settings.reach_mm) continue;
            const double weight =
                carrier.weight *
                std::exp(-0.5 * squared / (settings.spread_mm * settings.spread_mm));
            sum += weight * moves;
            place += weight * off;
            spread += weight * off * off.transpose();
            drift += weight * moves * off.transpose();
            weights += weight;
            nearest = std::min(nearest, squared);
        }
    }

    // The displacement at the vertex itself.
    Vector3 solve(double ridge_mm2) {
        sum /= weights;
        place /= weights;
        spread = spread / weights - place * place.transpose();
        drift = drift / weights - sum * place.transpose();
        return sum - drift * (spread + ridge_mm2 * Matrix3::Identity()).inverse() * place;
    }
};

}  // namespace

std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const InnerSettings& settings,
                                              const Context& context) {
    const Points& places = mesh.vertices;
    std::vector<std::uint8_t> inner(static_cast<std::size_t>(places.rows()), 0);
    if (!settings.exclude) return inner;
    const Points normals = vertex_normals(places, mesh.triangles),
                 faces = triangle_normals(places, mesh.triangles);
    const TriangleTree tree(places, mesh.triangles, context);
    parallel_for(context, inner.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Index v = static_cast<Index>(i);
            const Vector3 place = places.row(v).transpose(), normal = normals.row(v).transpose();
            for (const double radius : settings.probes_mm) {
                const SurfaceHit hit =
                    tree.closest(place + radius * normal, settings.touch * radius);
                if (!hit.valid()) continue;
                const Vector3 other = faces.row(static_cast<Index>(hit.triangle)).transpose();
                if (normal.dot(other) >= settings.facing * other.norm()) continue;
                inner[i] = is_enclosed(tree, place, normal, settings);
                break;
            }
        }
    });
    return inner;
}

void carry_inner(const TriMesh& template_mesh, const VertexRings& rings, const Points& rest,
                 const std::vector<std::uint8_t>& inner, const InnerSettings& settings,
                 Points& places, const Context& context) {
    std::vector<std::uint32_t> open;
    std::vector<Index> hidden;
    for (std::size_t i = 0; i < inner.size(); ++i)
        if (inner[i])
            hidden.push_back(static_cast<Index>(i));
        else
            open.push_back(static_cast<std::uint32_t>(i));
    if (open.empty() || hidden.empty()) return;
    const Hanging hanging =
        find_hanging(template_mesh, rings, inner, open, hidden, settings, context);
    std::vector<Carrier> all;
    all.reserve(open.size());
    for (const std::uint32_t v : open) all.push_back({static_cast<Index>(v), settings.fallback});

    const Points moved = places - rest;
    parallel_for(context, hidden.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index v = hidden[k], from = hanging.root[static_cast<std::size_t>(v)];
            Regression regression(settings.reach_mm);
            regression.add(all, rest, moved, v, settings);
            if (from >= 0)
                regression.add(hanging.around[static_cast<std::size_t>(from)], rest, moved, v,
                               settings);
            if (!(regression.weights > 0)) continue;
            const double blend = std::min(1.0, std::sqrt(regression.nearest) / settings.blend_mm);
            const Vector3 carried = regression.solve(settings.ridge_mm2);
            places.row(v) += blend * (carried.transpose() - moved.row(v));
        }
    });
}

}  // namespace mien
