#include "registration/inner.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "mesh/shortest_paths.hpp"
#include "spatial/point_cells.hpp"

namespace mien {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

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
    constexpr std::size_t kRoots = 8;  // at a time: each walks on paths of its own
    const std::size_t n = inner.size();
    const PathGraph graph = build_path_graph(mesh.vertices, rings);
    Hanging hanging{std::vector<Index>(n, -1), std::vector<std::vector<Carrier>>(n)};
    // Whatever leads to a wall comes by an open vertex beside one.
    std::vector<double> path_mm(n, kFar);
    std::vector<std::uint32_t> beside;
    for (const std::uint32_t v : open) {
        path_mm[v] = 0;
        const auto around = rings.of(v);
        if (std::any_of(around.begin(), around.end(), [&](std::uint32_t w) { return inner[w]; })) {
            path_mm[v] = kFar;
            beside.push_back(v);
        }
    }
    walk_paths(graph, beside, kFar, path_mm, [&](const ReachedVertex& at) {
        hanging.root[at.vertex] = static_cast<Index>(at.source);
    });
    std::vector<std::uint32_t> roots;
    for (const Index v : hidden)
        if (hanging.root[static_cast<std::size_t>(v)] >= 0)
            roots.push_back(static_cast<std::uint32_t>(hanging.root[static_cast<std::size_t>(v)]));
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    parallel_for(context, roots.size(), kRoots, [&](std::size_t begin, std::size_t end) {
        std::vector<double> own_path_mm(n, kFar);
        std::vector<std::uint32_t> touched;
        for (std::size_t k = begin; k < end; ++k) {
            std::vector<Carrier>& carriers = hanging.around[roots[k]];
            walk_paths(
                graph, {roots[k]}, settings.far_path_mm, own_path_mm, [&](const ReachedVertex& at) {
                    touched.push_back(at.vertex);
                    if (!inner[at.vertex])
                        carriers.push_back({static_cast<Index>(at.vertex),
                                            fade((settings.far_path_mm - at.path) /
                                                 (settings.far_path_mm - settings.near_path_mm))});
                });
            for (const std::uint32_t t : touched) own_path_mm[t] = kFar;
            touched.clear();
        }
    });
    return hanging;
}

// Sums of one inner vertex' regression.
struct Regression {
    Vector3 sum = Vector3::Zero(), place = Vector3::Zero();
    Matrix3 spread = Matrix3::Zero(), drift = Matrix3::Zero();
    double weights = 0, nearest;

    explicit Regression(double reach_mm) : nearest(reach_mm * reach_mm) {}

    void add(const Carrier& carrier, const Points& rest, const Points& moved, Index v,
             const InnerSettings& settings) {
        const Vector3 off = (rest.row(carrier.vertex) - rest.row(v)).transpose();
        const double squared = off.squaredNorm();
        if (squared >= settings.reach_mm * settings.reach_mm) return;
        const Vector3 moves = moved.row(carrier.vertex).transpose();
        const double weight =
            carrier.weight * std::exp(-0.5 * squared / (settings.spread_mm * settings.spread_mm));
        sum += weight * moves;
        place += weight * off;
        spread += weight * off * off.transpose();
        drift += weight * moves * off.transpose();
        weights += weight;
        nearest = std::min(nearest, squared);
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
    if (!settings.exclude)
        return std::vector<std::uint8_t>(static_cast<std::size_t>(mesh.vertices.rows()), 0);
    return find_walls(mesh, settings.walls, context);
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
    const PointCells cells(rest, open, settings.reach_mm);

    const Points moved = places - rest;
    parallel_for(context, hidden.size(), 16, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> near;
        for (std::size_t k = begin; k < end; ++k) {
            const Index v = hidden[k], from = hanging.root[static_cast<std::size_t>(v)];
            Regression regression(settings.reach_mm);
            cells.around(rest.row(v), near);
            for (const std::uint32_t other : near)
                regression.add({static_cast<Index>(other), settings.fallback}, rest, moved, v,
                               settings);
            if (from >= 0)
                for (const Carrier& carrier : hanging.around[static_cast<std::size_t>(from)])
                    regression.add(carrier, rest, moved, v, settings);
            if (!(regression.weights > 0)) continue;
            const double blend = std::min(1.0, std::sqrt(regression.nearest) / settings.blend_mm);
            const Vector3 carried = regression.solve(settings.ridge_mm2);
            places.row(v) += blend * (carried.transpose() - moved.row(v));
        }
    });
}

}  // namespace mien
