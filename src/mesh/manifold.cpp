#include "mesh/manifold.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "base/error.hpp"
#include "mesh/topology.hpp"

namespace mien {
namespace {

using Corners = std::vector<std::array<std::uint32_t, 3>>;

/// Corners that are one vertex, by union and find; a corner is 3 t + k.
class CornerSets {
  public:
    explicit CornerSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t corner) {
        while (parent_[corner] != corner) {
            parent_[corner] = parent_[parent_[corner]];
            corner = parent_[corner];
        }
        return corner;
    }
    /// The lower number stands for both, so that the order of the input decides.
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

Triangles as_triangles(const Corners& corners) {
    Triangles triangles(static_cast<Index>(corners.size()), 3);
    for (std::size_t t = 0; t < corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            triangles(static_cast<Index>(t), static_cast<Index>(k)) = corners[t][k];
    return triangles;
}

/// Gives each fan its vertex; `to_old` grows by the new ones.
void split_fans(Corners& corners, std::vector<std::uint32_t>& to_old, const Context& context) {
    const Triangles triangles = as_triangles(corners);
    const EdgeTable table = build_edge_table(triangles, static_cast<Index>(to_old.size()), context);
    CornerSets sets(3 * corners.size());
    for (std::size_t e = 0; e < table.num_edges(); ++e) {
        if (table.num_sides(e) != 2) continue;
        const std::uint32_t a = table.sides[table.first_side[e]],
                            b = table.sides[table.first_side[e] + 1];
        if (side_ends(triangles, a)[0] == side_ends(triangles, b)[0]) continue;
        const auto next = [](std::uint32_t side) { return side - side % 3 + (side % 3 + 1) % 3; };
        sets.join(a, next(b));
        sets.join(next(a), b);
    }
    std::vector<std::uint32_t> old_of = std::move(to_old);
    to_old.clear();
    std::map<std::uint32_t, std::uint32_t> number;  // representative corner -> new vertex
    for (std::size_t t = 0; t < corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t set = sets.find(static_cast<std::uint32_t>(3 * t + k));
            const auto [place, fresh] =
                number.emplace(set, static_cast<std::uint32_t>(to_old.size()));
            if (fresh) to_old.push_back(old_of[corners[t][k]]);
            corners[t][k] = place->second;
        }
}

/// Drops triangles on edges that still do not fit; true when there were any.
bool drop_misfits(Corners& corners, std::size_t num_vertices, Index& num_dropped,
                  const Context& context) {
    const Triangles triangles = as_triangles(corners);
    const EdgeTable table = build_edge_table(triangles, static_cast<Index>(num_vertices), context);
    std::vector<std::uint8_t> stays(corners.size(), 1);
    for (std::size_t e = 0; e < table.num_edges(); ++e) {
        const std::uint32_t first = table.first_side[e], count = table.num_sides(e);
        const bool against = count == 2 && side_ends(triangles, table.sides[first])[0] ==
                                               side_ends(triangles, table.sides[first + 1])[0];
        if (count <= 2 && !against) continue;
        for (std::uint32_t s = first + 1; s < first + count; ++s) stays[table.sides[s] / 3] = 0;
    }
    Corners kept;
    for (std::size_t t = 0; t < corners.size(); ++t)
        if (stays[t]) kept.push_back(corners[t]);
    num_dropped += static_cast<Index>(corners.size() - kept.size());
    const bool any = kept.size() != corners.size();
    corners = std::move(kept);
    return any;
}

}  // namespace

ManifoldMesh make_manifold(const TriMesh& mesh, const Context& context) {
    ManifoldMesh result;
    Corners corners;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const auto row = mesh.triangles.row(t);
        if (row[0] == row[1] || row[1] == row[2] || row[0] == row[2])
            ++result.num_dropped;
        else
            corners.push_back({row[0], row[1], row[2]});
    }
    std::vector<std::uint32_t> used(static_cast<std::size_t>(mesh.vertices.rows()), 0);
    for (const auto& triangle : corners)
        for (const std::uint32_t v : triangle) used[v] = 1;
    const Index before = std::accumulate(used.begin(), used.end(), Index{0});
    std::vector<std::uint32_t>& to_old = result.vertex_to_old;
    to_old.resize(static_cast<std::size_t>(mesh.vertices.rows()));
    std::iota(to_old.begin(), to_old.end(), 0u);
    // Each round drops a triangle or is the last.
    do split_fans(corners, to_old, context);
    while (drop_misfits(corners, to_old.size(), result.num_dropped, context));
    if (corners.empty())
        fail(Status::invalid_mesh, "no triangle of the mesh is part of a manifold; clean it first");
    result.mesh.triangles = as_triangles(corners);
    result.mesh.vertices.resize(static_cast<Index>(to_old.size()), 3);
    for (std::size_t v = 0; v < to_old.size(); ++v)
        result.mesh.vertices.row(static_cast<Index>(v)) = mesh.vertices.row(to_old[v]);
    result.num_split = static_cast<Index>(to_old.size()) - before;
    return result;
}

}  // namespace mien
