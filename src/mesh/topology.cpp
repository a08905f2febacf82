#include "mesh/topology.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "mesh/triangle_fans.hpp"

namespace mien {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Union-find with halving; the lowest member is the representative.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }
    void unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

EdgeTable build_edge_table(const TrianglesRef& triangles, Index num_vertices,
                           const Context& context) {
    if (triangles.rows() > static_cast<Index>(kNone / 3))
        fail(Status::invalid_mesh, "%lld triangles are more than edges can be built for",
             static_cast<long long>(triangles.rows()));
    const std::uint32_t num_sides = static_cast<std::uint32_t>(3 * triangles.rows());
    context.require_memory(24 * static_cast<std::size_t>(num_sides) / 3 * 2 +
                               4 * static_cast<std::size_t>(num_vertices),
                           "the edges of a mesh");
    // Sides by their smaller end, counted first; then each small bucket by its other end.
    std::vector<std::uint32_t> start(static_cast<std::size_t>(num_vertices) + 1, 0);
    for (std::uint32_t side = 0; side < num_sides; ++side) {
        const auto ends = side_ends(triangles, side);
        if (ends[0] != ends[1]) ++start[std::min(ends[0], ends[1]) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    struct Entry {
        std::uint32_t other, side;
        bool operator<(const Entry& e) const {
            return other != e.other ? other < e.other : side < e.side;
        }
    };
    std::vector<Entry> entries(start.back());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::uint32_t side = 0; side < num_sides; ++side) {
        const auto ends = side_ends(triangles, side);
        if (ends[0] != ends[1])
            entries[fill[std::min(ends[0], ends[1])]++] = {std::max(ends[0], ends[1]), side};
    }
    EdgeTable table;
    table.sides.reserve(entries.size());
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
        if (v % (1 << 16) == 0) context.check_cancelled();
        std::sort(entries.begin() + start[v], entries.begin() + start[v + 1]);
        for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
            if (i == start[v] || entries[i].other != entries[i - 1].other) {
                table.edges.push_back({static_cast<std::uint32_t>(v), entries[i].other});
                table.first_side.push_back(static_cast<std::uint32_t>(table.sides.size()));
            }
            table.sides.push_back(entries[i].side);
        }
    }
    table.first_side.push_back(static_cast<std::uint32_t>(table.sides.size()));
    return table;
}

std::vector<std::uint32_t> border_sides(const EdgeTable& table) {
    std::vector<std::uint32_t> sides;
    for (std::size_t edge = 0; edge < table.num_edges(); ++edge)
        if (table.num_sides(edge) == 1) sides.push_back(table.sides[table.first_side[edge]]);
    std::sort(sides.begin(), sides.end());
    return sides;
}

std::vector<std::uint8_t> border_vertices(const EdgeTable& table, Index num_vertices) {
    std::vector<std::uint8_t> on_border(static_cast<std::size_t>(num_vertices), 0);
    for (std::size_t edge = 0; edge < table.num_edges(); ++edge)
        if (table.num_sides(edge) == 1)
            for (std::uint32_t vertex : table.edges[edge]) on_border[vertex] = 1;
    return on_border;
}

std::vector<std::uint8_t> border_vertices(const TrianglesRef& triangles, Index num_vertices,
                                          const Context& context) {
    return border_vertices(build_edge_table(triangles, num_vertices, context), num_vertices);
}

std::vector<std::vector<std::uint32_t>> border_loops(const EdgeTable& table,
                                                     const TrianglesRef& triangles,
                                                     Index num_vertices) {
    const std::vector<std::uint32_t> sides = border_sides(table);
    // Sides by start vertex; ascending, as `sides` is.
    std::vector<std::uint32_t> start(static_cast<std::size_t>(num_vertices) + 1, 0);
    for (std::uint32_t side : sides) ++start[side_ends(triangles, side)[0] + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    std::vector<std::uint32_t> leaving(sides.size());
    for (std::uint32_t side : sides) leaving[next[side_ends(triangles, side)[0]]++] = side;
    std::copy(start.begin(), start.end() - 1, next.begin());

    std::vector<std::vector<std::uint32_t>> loops;
    // A chain that nothing enters must be begun at its end; the other starts follow.
    std::vector<std::int64_t> surplus(static_cast<std::size_t>(num_vertices), 0);
    for (std::uint32_t side : sides) {
        ++surplus[side_ends(triangles, side)[0]];
        --surplus[side_ends(triangles, side)[1]];
    }
    auto walk = [&](std::uint32_t vertex) {
        std::vector<std::uint32_t> loop;
        const std::uint32_t first = vertex;
        while (next[vertex] < start[vertex + 1]) {
            loop.push_back(vertex);
            vertex = side_ends(triangles, leaving[next[vertex]++])[1];
            if (vertex == first) break;
        }
        if (vertex != first) loop.push_back(vertex);
        loops.push_back(std::move(loop));
    };
    for (std::uint32_t v = 0; v < static_cast<std::uint32_t>(num_vertices); ++v)
        for (; surplus[v] > 0 && next[v] < start[v + 1]; --surplus[v]) walk(v);
    for (std::uint32_t v = 0; v < static_cast<std::uint32_t>(num_vertices); ++v)
        while (next[v] < start[v + 1]) walk(v);
    std::stable_sort(loops.begin(), loops.end(),
                     [](const auto& a, const auto& b) { return a.front() < b.front(); });
    return loops;
}

ConnectedComponents connected_components(const TrianglesRef& triangles, Index num_vertices) {
    const std::size_t count = static_cast<std::size_t>(num_vertices);
    DisjointSets sets(count);
    for (Index t = 0; t < triangles.rows(); ++t) {
        sets.unite(triangles(t, 0), triangles(t, 1));
        sets.unite(triangles(t, 0), triangles(t, 2));
    }
    // Numbered by lowest vertex first, then renumbered by size.
    std::vector<std::uint32_t> number(count, kNone);
    ConnectedComponents parts;
    parts.of_vertex.resize(count);
    std::uint32_t num_parts = 0;
    for (std::size_t v = 0; v < count; ++v) {
        const std::uint32_t root = sets.find(static_cast<std::uint32_t>(v));
        if (number[root] == kNone) number[root] = num_parts++;
        parts.of_vertex[v] = number[root];
    }
    std::vector<Index> num_triangles(num_parts, 0);
    for (Index t = 0; t < triangles.rows(); ++t) ++num_triangles[parts.of_vertex[triangles(t, 0)]];
    std::vector<std::uint32_t> order(num_parts), rank(num_parts);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return num_triangles[a] > num_triangles[b];
    });
    for (std::uint32_t k = 0; k < num_parts; ++k) rank[order[k]] = k;
    parts.num_triangles.resize(num_parts);
    parts.num_vertices.assign(num_parts, 0);
    for (std::uint32_t k = 0; k < num_parts; ++k) parts.num_triangles[k] = num_triangles[order[k]];
    for (std::uint32_t& part : parts.of_vertex) {
        part = rank[part];
        ++parts.num_vertices[part];
    }
    parts.of_triangle.resize(static_cast<std::size_t>(triangles.rows()));
    for (Index t = 0; t < triangles.rows(); ++t)
        parts.of_triangle[static_cast<std::size_t>(t)] = parts.of_vertex[triangles(t, 0)];
    return parts;
}

namespace {

// A corner at a pinched vertex, and the vertices before and behind it in its triangle.
struct PinchedCorner {
    std::uint32_t vertex, next, previous, side, node;
};

// Each fan of a pinched vertex gets a node of its own, beyond the vertices' numbers. By side.
std::vector<PinchedCorner> part_pinched(const TrianglesRef& triangles, const TriangleFans& fans,
                                        std::uint32_t& num_nodes) {
    std::vector<std::uint8_t> pinched(num_nodes, 0);
    for (const std::uint32_t vertex : fans.pinched()) pinched[vertex] = 1;
    std::vector<PinchedCorner> corners;
    for (Index t = 0; t < triangles.rows() && !fans.pinched().empty(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t vertex = triangles(t, k);
            if (pinched[vertex])
                corners.push_back({vertex, triangles(t, (k + 1) % 3), triangles(t, (k + 2) % 3),
                                   static_cast<std::uint32_t>(3 * t + k), kNone});
        }
    const auto by_next = [](const PinchedCorner& a, const PinchedCorner& b) {
        return a.vertex != b.vertex ? a.vertex < b.vertex : a.next < b.next;
    };
    std::sort(corners.begin(), corners.end(), by_next);
    DisjointSets sets(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
        PinchedCorner wanted = corners[k];
        wanted.next = wanted.previous;
        const auto found = std::lower_bound(corners.begin(), corners.end(), wanted, by_next);
        if (found != corners.end() && found->vertex == wanted.vertex && found->next == wanted.next)
            sets.unite(static_cast<std::uint32_t>(k),
                       static_cast<std::uint32_t>(found - corners.begin()));
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t first = sets.find(static_cast<std::uint32_t>(k));
        corners[k].node = first == k ? num_nodes++ : corners[first].node;
    }
    std::sort(corners.begin(), corners.end(),
              [](const PinchedCorner& a, const PinchedCorner& b) { return a.side < b.side; });
    return corners;
}

}  // namespace

std::vector<std::uint32_t> pieces_across_edges(const TrianglesRef& triangles,
                                               const TriangleFans& fans) {
    std::uint32_t num_nodes = static_cast<std::uint32_t>(fans.num_vertices());
    const std::vector<PinchedCorner> parted = part_pinched(triangles, fans, num_nodes);
    DisjointSets sets(num_nodes);
    // Where a triangle's corners are, with the corners at pinched vertices taken from their list.
    const auto visit = [&](auto&& use) {
        auto corner = parted.begin();
        for (Index t = 0; t < triangles.rows(); ++t) {
            std::uint32_t nodes[3] = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
            for (; corner != parted.end() && corner->side / 3 == t; ++corner)
                nodes[corner->side % 3] = corner->node;
            use(static_cast<std::size_t>(t), nodes);
        }
    };
    visit([&](std::size_t, const std::uint32_t* nodes) {
        sets.unite(nodes[0], nodes[1]);
        sets.unite(nodes[0], nodes[2]);
    });
    std::vector<std::uint32_t> number(num_nodes, kNone),
        piece_of(static_cast<std::size_t>(triangles.rows()));
    std::uint32_t num_pieces = 0;
    visit([&](std::size_t t, const std::uint32_t* nodes) {
        std::uint32_t& piece = number[sets.find(nodes[0])];
        if (piece == kNone) piece = num_pieces++;
        piece_of[t] = piece;
    });
    return piece_of;
}

TopologyReport inspect_topology(const EdgeTable& table, const TrianglesRef& triangles,
                                Index num_vertices) {
    TopologyReport report;
    auto note = [](Index& count, std::int64_t& first, std::int64_t index) {
        if (count++ == 0) first = index;
    };
    std::vector<std::uint8_t> used(static_cast<std::size_t>(num_vertices), 0);
    for (Index t = 0; t < triangles.rows(); ++t) {
        const std::uint32_t a = triangles(t, 0), b = triangles(t, 1), c = triangles(t, 2);
        if (a == b || b == c || a == c)
            note(report.num_degenerate_triangles, report.first_degenerate_triangle, t);
        used[a] = used[b] = used[c] = 1;
    }
    report.num_unused_vertices = std::count(used.begin(), used.end(), std::uint8_t(0));

    // The corners of a vertex's triangles, joined across the edges they share, form its fans.
    DisjointSets corners(static_cast<std::size_t>(3 * triangles.rows()));
    auto corner_at = [&](std::uint32_t side, std::uint32_t vertex) {
        // A side starts at its own corner and ends at the next one.
        if (side_ends(triangles, side)[0] == vertex) return side;
        return side - side % 3 + (side % 3 + 1) % 3;
    };
    for (std::size_t edge = 0; edge < table.num_edges(); ++edge) {
        const std::uint32_t* sides = table.sides.data() + table.first_side[edge];
        const std::uint32_t count = table.num_sides(edge);
        if (count == 1) ++report.num_border_edges;
        if (count > 2)
            note(report.num_complex_edges, report.first_complex_edge,
                 static_cast<std::int64_t>(edge));
        if (count == 2 && side_ends(triangles, sides[0])[0] == side_ends(triangles, sides[1])[0])
            note(report.num_misoriented_edges, report.first_misoriented_edge,
                 static_cast<std::int64_t>(edge));
        for (std::uint32_t k = 1; k < count; ++k)
            for (std::uint32_t vertex : table.edges[edge])
                corners.unite(corner_at(sides[0], vertex), corner_at(sides[k], vertex));
    }
    std::vector<std::uint32_t> fan(static_cast<std::size_t>(num_vertices), kNone);
    std::vector<std::uint8_t> pinched(static_cast<std::size_t>(num_vertices), 0);
    for (std::uint32_t corner = 0; corner < static_cast<std::uint32_t>(3 * triangles.rows());
         ++corner) {
        const std::uint32_t vertex = triangles(corner / 3, static_cast<int>(corner % 3));
        const std::uint32_t root = corners.find(corner);
        if (fan[vertex] == kNone)
            fan[vertex] = root;
        else if (fan[vertex] != root)
            pinched[vertex] = 1;
    }
    for (Index v = 0; v < num_vertices; ++v)
        if (pinched[static_cast<std::size_t>(v)])
            note(report.num_pinched_vertices, report.first_pinched_vertex, v);
    return report;
}

}  // namespace mien
