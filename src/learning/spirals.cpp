#include "learning/spirals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "mesh/shortest_paths.hpp"

namespace mien {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

/// Continues a walk by whole rings, until the walk has `wanted` vertices or there are no more.
class SpiralWalk {
  public:
    SpiralWalk(const Rings& rings, std::size_t num_vertices)
        : rings_(rings), seen_(num_vertices, 0) {}

    /// The vertex and its first ring, which begins with `start`.
    std::vector<std::uint32_t> begin(std::uint32_t vertex, std::size_t start) {
        ++stamp_;
        std::vector<std::uint32_t> walk{vertex};
        seen_[vertex] = stamp_;
        const auto& ring = rings_[vertex];
        for (std::size_t k = 0; k < ring.size(); ++k) add(ring[(start + k) % ring.size()], walk);
        last_ = walk.size() - 1;
        return walk;
    }
    /// Appends the next ring; false when it is empty.
    bool next(std::vector<std::uint32_t>& walk) {
        const std::size_t first = walk.size() - last_, end = walk.size();
        for (std::size_t k = first; k < end; ++k) {
            const auto& ring = rings_[walk[k]];
            // From what the walk has passed already it goes on counter-clockwise.
            std::size_t start = 0;
            while (start < ring.size() && seen_[ring[start]] != stamp_) ++start;
            for (std::size_t r = 0; r < ring.size(); ++r)
                add(ring[(start + r) % ring.size()], walk);
        }
        last_ = walk.size() - end;
        return last_ > 0;
    }

  private:
    void add(std::uint32_t vertex, std::vector<std::uint32_t>& walk) {
        if (seen_[vertex] == stamp_) return;
        seen_[vertex] = stamp_;
        walk.push_back(vertex);
    }
    const Rings& rings_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t stamp_ = 0;
    std::size_t last_ = 0;  ///< vertices of the last ring
};

/// Appends the vertices nearest to the first one that the row does not hold yet.
void fill_by_distance(const Points& vertices, std::size_t length, std::vector<std::uint32_t>& row) {
    std::vector<std::pair<double, std::uint32_t>> others;
    for (Index v = 0; v < vertices.rows(); ++v)
        if (std::find(row.begin(), row.end(), static_cast<std::uint32_t>(v)) == row.end())
            others.emplace_back((vertices.row(v) - vertices.row(row[0])).squaredNorm(),
                                static_cast<std::uint32_t>(v));
    std::sort(others.begin(), others.end());
    for (std::size_t k = 0; k < others.size() && row.size() < length; ++k)
        row.push_back(others[k].second);
}

void append_row(std::vector<std::uint32_t> row, std::size_t length, std::uint32_t padding,
                std::vector<std::uint32_t>& rows) {
    row.resize(length, padding);
    rows.insert(rows.end(), row.begin(), row.end());
}

}  // namespace

Rings ordered_rings(const TriMesh& mesh) {
    const auto n = static_cast<std::size_t>(mesh.vertices.rows());
    // Of a triangle (v, a, b): seen from v, b comes after a.
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> steps(n);
    for (Index f = 0; f < mesh.triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.triangles(f, c), a = mesh.triangles(f, (c + 1) % 3),
                                b = mesh.triangles(f, (c + 2) % 3);
            if (v != a && v != b && a != b) steps[v].emplace_back(a, b);
        }
    Rings rings(n);
    std::vector<char> used;
    for (std::size_t v = 0; v < n; ++v) {
        auto& links = steps[v];
        std::sort(links.begin(), links.end());
        links.erase(std::unique(links.begin(), links.end()), links.end());
        used.assign(links.size(), 0);
        auto& ring = rings[v];
        const auto add = [&](std::uint32_t w) {
            if (std::find(ring.begin(), ring.end(), w) == ring.end()) ring.push_back(w);
        };
        const auto walk_from = [&](std::size_t link) {
            while (!used[link]) {
                used[link] = 1;
                add(links[link].first);
                add(links[link].second);
                const auto next = std::lower_bound(
                    links.begin(), links.end(),
                    std::pair<std::uint32_t, std::uint32_t>(links[link].second, 0));
                if (next == links.end() || next->first != links[link].second) break;
                link = static_cast<std::size_t>(next - links.begin());
            }
        };
        for (std::size_t k = 0; k < links.size(); ++k) {  // open fans first, from their beginning
            const bool preceded = std::any_of(links.begin(), links.end(), [&](const auto& other) {
                return other.second == links[k].first;
            });
            if (!preceded) walk_from(k);
        }
        for (std::size_t k = 0; k < links.size(); ++k) walk_from(k);
    }
    return rings;
}

std::vector<std::uint32_t> spirals(const TriMesh& mesh, Index length) {
    const auto wanted = static_cast<std::size_t>(length);
    const Rings rings = ordered_rings(mesh);
    SpiralWalk walker(rings, rings.size());
    std::vector<std::uint32_t> rows;
    rows.reserve(rings.size() * wanted);
    for (std::size_t v = 0; v < rings.size(); ++v) {
        auto walk = walker.begin(static_cast<std::uint32_t>(v), 0);
        while (walk.size() < wanted && walker.next(walk)) {
        }
        if (walk.size() < wanted) fill_by_distance(mesh.vertices, wanted, walk);
        append_row(std::move(walk), wanted, static_cast<std::uint32_t>(rings.size()), rows);
    }
    return rows;
}

std::vector<std::uint32_t> reference_spirals(const TriMesh& mesh, Index rings_wanted,
                                             Index dilation, std::uint32_t reference,
                                             Index& length) {
    if (static_cast<Index>(reference) >= mesh.vertices.rows())
        fail(Status::invalid_argument, "reference vertex %u of %lld", reference,
             static_cast<long long>(mesh.vertices.rows()));
    const Rings rings = ordered_rings(mesh);
    const PathGraph graph =
        build_path_graph(mesh.vertices, build_rings(mesh.vertices.rows(), mesh.triangles));
    std::vector<double> distance(rings.size(), std::numeric_limits<double>::infinity());
    walk_paths(graph, {reference}, std::numeric_limits<double>::infinity(), distance,
               [](const ReachedVertex&) {});
    SpiralWalk walker(rings, rings.size());
    std::vector<std::vector<std::uint32_t>> all;
    double sum = 0, squares = 0;
    for (std::size_t v = 0; v < rings.size(); ++v) {
        // The reference vertex' own ring begins at its nearest neighbour: all paths from there lead
        // back, and the shortest of them is the shortest edge.
        std::size_t start = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < rings[v].size(); ++k) {
            const double path =
                distance[rings[v][k]] +
                (mesh.vertices.row(rings[v][k]) - mesh.vertices.row(static_cast<Index>(v))).norm();
            if (path < least) least = path, start = k;
        }
        auto walk = walker.begin(static_cast<std::uint32_t>(v), start);
        for (Index ring = 1; ring < rings_wanted && walker.next(walk); ++ring) {
        }
        std::vector<std::uint32_t> kept;
        for (std::size_t k = 0; k < walk.size(); k += static_cast<std::size_t>(dilation))
            kept.push_back(walk[k]);
        const auto size = static_cast<double>(kept.size());
        sum += size;
        squares += size * size;
        all.push_back(std::move(kept));
    }
    const auto count = static_cast<double>(rings.size());
    const double mean = sum / count;
    const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    length = std::max<Index>(1, static_cast<Index>(std::floor(mean + 2 * deviation)));
    std::vector<std::uint32_t> rows;
    for (auto& walk : all)
        append_row(std::move(walk), static_cast<std::size_t>(length),
                   static_cast<std::uint32_t>(rings.size()), rows);
    return rows;
}

std::vector<std::uint32_t> padded_rings(const TriMesh& mesh, Index places) {
    const Rings rings = ordered_rings(mesh);
    std::vector<std::uint32_t> rows;
    for (std::size_t v = 0; v < rings.size(); ++v) {
        std::vector<std::uint32_t> row{static_cast<std::uint32_t>(v)};
        row.insert(row.end(), rings[v].begin(), rings[v].end());
        append_row(std::move(row), static_cast<std::size_t>(places),
                   static_cast<std::uint32_t>(rings.size()), rows);
    }
    return rows;
}

}  // namespace mien
