#include "geometry/intrinsic_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <numeric>

#include "base/error.hpp"
#include "base/scalar_math.hpp"

namespace mien {
namespace {

constexpr std::int64_t kNone = -1;

/// Relative slack of the triangle inequality after mollification, and of the Delaunay test.
constexpr double kHeatMollification = 1e-5;
constexpr double kFlipTolerance = 1e-9;

double double_area_of(double a, double b, double c) {
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const double squared = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return squared > 0 ? 0.5 * std::sqrt(squared) : 0.0;
}

/// A corner of an input triangle, seen as the edge opposite to it.
struct Side {
    std::uint32_t low, high;
    std::int64_t half_edge;  ///< 3 triangle + corner
    bool operator<(const Side& other) const {
        if (low != other.low) return low < other.low;
        if (high != other.high) return high < other.high;
        return half_edge < other.half_edge;
    }
};

int root_of(std::vector<int>& parent, int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
        int& up = parent[static_cast<std::size_t>(v)];
        up = parent[static_cast<std::size_t>(up)];
        v = up;
    }
    return v;
}

/// The cover while its edges are flipped: half-edge 3t + k is the edge opposite corner k of t and
/// runs from corner k+1 to corner k+2. Triangle 2f is the front of input triangle f, 2f + 1 its
/// back, with the corners in reverse order.
struct Cover {
    std::vector<std::array<std::uint32_t, 3>> corners;
    std::vector<std::array<double, 3>> lengths;
    std::vector<std::int64_t> twin;

    double cotangent_opposite(std::int64_t half_edge) const {
        const auto& l = lengths[static_cast<std::size_t>(half_edge / 3)];
        const int k = static_cast<int>(half_edge % 3);
        const double a = l[k], b = l[(k + 1) % 3], c = l[(k + 2) % 3];
        return ((b - a) * (b + a) + c * c) / (2 * double_area_of(a, b, c));
    }
    void glue(std::int64_t a, std::int64_t b) {
        twin[static_cast<std::size_t>(a)] = b;
        twin[static_cast<std::size_t>(b)] = a;
    }
    bool is_delaunay(std::int64_t h) const {
        const std::int64_t other = twin[static_cast<std::size_t>(h)];
        if (h / 3 == other / 3) return true;
        return cotangent_opposite(h) + cotangent_opposite(other) > -kFlipTolerance;
    }
    bool flip(std::int64_t h, std::array<std::int64_t, 4>& outer);
};

/// Replaces the edge i-j between triangles (k, i, j) and (l, j, i) by k-l. False when the new
/// length is not a positive number. `outer` are the four half-edges around, for the next tests.
bool Cover::flip(std::int64_t h, std::array<std::int64_t, 4>& outer) {
    const std::int64_t g = twin[static_cast<std::size_t>(h)];
    const auto t0 = static_cast<std::size_t>(h / 3), t1 = static_cast<std::size_t>(g / 3);
    const int c0 = static_cast<int>(h % 3), c1 = static_cast<int>(g % 3);
    const std::uint32_t k = corners[t0][c0], i = corners[t0][(c0 + 1) % 3],
                        j = corners[t0][(c0 + 2) % 3], l = corners[t1][c1];
    const double ij = lengths[t0][c0], jk = lengths[t0][(c0 + 1) % 3],
                 ki = lengths[t0][(c0 + 2) % 3];
    const double il = lengths[t1][(c1 + 1) % 3], lj = lengths[t1][(c1 + 2) % 3];
    // Lay both triangles out in the plane with i at the origin and j on the x axis.
    const double kx = ((ki - jk) * (ki + jk) + ij * ij) / (2 * ij);
    const double lx = ((il - lj) * (il + lj) + ij * ij) / (2 * ij);
    const double ky = double_area_of(ij, jk, ki) / ij, ly = double_area_of(ij, il, lj) / ij;
    const double kl = std::hypot(kx - lx, ky + ly);
    if (!(kl > 0) || !std::isfinite(kl)) return false;
    if (!(double_area_of(kl, ki, il) > 0) || !(double_area_of(kl, lj, jk) > 0)) return false;

    const std::int64_t base0 = 3 * static_cast<std::int64_t>(t0);
    const std::int64_t base1 = 3 * static_cast<std::int64_t>(t1);
    // The outer half-edges may be glued to each other, so remember them as places first.
    const std::array<std::int64_t, 4> old_place{base0 + (c0 + 2) % 3, base1 + (c1 + 1) % 3,
                                                base1 + (c1 + 2) % 3, base0 + (c0 + 1) % 3};
    const std::array<std::int64_t, 4> new_place{base0 + 1, base0 + 2, base1 + 1, base1 + 2};
    std::array<std::int64_t, 4> partner;
    for (int e = 0; e < 4; ++e) {
        partner[e] = twin[static_cast<std::size_t>(old_place[e])];
        for (int f = 0; f < 4; ++f)
            if (partner[e] == old_place[f]) {
                partner[e] = new_place[f];
                break;
            }
    }
    corners[t0] = {i, l, k};
    lengths[t0] = {kl, ki, il};
    corners[t1] = {j, k, l};
    lengths[t1] = {kl, lj, jk};
    glue(base0, base1);
    for (int e = 0; e < 4; ++e) glue(new_place[e], partner[e]);
    outer = new_place;
    return true;
}

/// Glues fronts and backs around one edge with `count` input sides, so that the cover is closed.
void glue_edge(const Side* sides, std::size_t count, const PointsRef& vertices,
               const TrianglesRef& triangles, Cover& cover) {
    // A front half-edge keeps the input's direction; its back runs the other way.
    const auto front = [](std::int64_t h) { return 6 * (h / 3) + h % 3; };
    // Back corners are (0, 2, 1) of the input: corner k of the input sits at (3 - k) % 3.
    const auto back = [](std::int64_t h) { return 6 * (h / 3) + 3 + (3 - h % 3) % 3; };
    const auto runs_up = [&](std::int64_t h) {
        return triangles(h / 3, (h % 3 + 1) % 3) < triangles(h / 3, (h % 3 + 2) % 3);
    };
    if (count == 1) {
        cover.glue(front(sides[0].half_edge), back(sides[0].half_edge));
        return;
    }
    // Order the sheets around the edge; each one's far side meets the next one's near side.
    std::vector<std::pair<double, std::int64_t>> sheets(count);
    const Eigen::RowVector3d origin = vertices.row(sides[0].low);
    const Eigen::RowVector3d axis = vertices.row(sides[0].high) - origin;
    const double axis_squared = axis.squaredNorm();
    Eigen::RowVector3d u = Eigen::RowVector3d::Zero(), v = u;
    for (std::size_t s = 0; s < count; ++s) {
        const std::int64_t h = sides[s].half_edge;
        Eigen::RowVector3d out = vertices.row(triangles(h / 3, h % 3)) - origin;
        if (axis_squared > 0) out -= (out.dot(axis) / axis_squared) * axis;
        if (s == 0) {
            u = out;
            v = axis.cross(out) / std::sqrt(std::max(axis_squared, 1e-300));
        }
        const double angle = s == 0 ? 0.0 : std::atan2(out.dot(v), out.dot(u));
        sheets[s] = {angle < 0 ? angle + 2 * kPi : angle, h};
    }
    std::sort(sheets.begin(), sheets.end());
    for (std::size_t s = 0; s < count; ++s) {
        const std::int64_t a = sheets[s].second, b = sheets[(s + 1) % count].second;
        // Turning about low -> high, a triangle that runs up shows its front to what follows.
        cover.glue(runs_up(a) ? front(a) : back(a), runs_up(b) ? back(b) : front(b));
    }
}

void check_input(const PointsRef& vertices, const TrianglesRef& triangles) {
    if (!vertices.allFinite())
        fail(Status::invalid_mesh, "a vertex of the surface is not finite; drop or repair it");
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            if (static_cast<Index>(triangles(t, k)) >= vertices.rows())
                fail_at(Status::invalid_mesh, t, "triangle %lld names vertex %lld of %lld",
                        static_cast<long long>(t), static_cast<long long>(triangles(t, k)),
                        static_cast<long long>(vertices.rows()));
}

/// The triangles of three distinct vertices.
Triangles proper_triangles(const TrianglesRef& all) {
    Triangles triangles(all.rows(), 3);
    Index used = 0;
    for (Index t = 0; t < all.rows(); ++t) {
        const auto a = all(t, 0), b = all(t, 1), c = all(t, 2);
        if (a != b && b != c && c != a) triangles.row(used++) = all.row(t);
    }
    triangles.conservativeResize(used, 3);
    return triangles;
}

/// Pieces in the order of their first vertices; a vertex without triangles is one of its own.
void number_components(const TrianglesRef& triangles, IntrinsicMesh& mesh) {
    std::vector<int> parent(static_cast<std::size_t>(mesh.num_vertices));
    std::iota(parent.begin(), parent.end(), 0);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 1; k < 3; ++k) {
            const int a = root_of(parent, static_cast<int>(triangles(t, 0)));
            const int b = root_of(parent, static_cast<int>(triangles(t, k)));
            parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
    mesh.component.assign(parent.size(), 0);
    for (std::size_t v = 0; v < parent.size(); ++v) {
        const int root = root_of(parent, static_cast<int>(v));
        mesh.component[v] = root == static_cast<int>(v)
                                ? mesh.num_components++
                                : mesh.component[static_cast<std::size_t>(root)];
    }
}

/// Twins of all half-edges, the vertices on the border and the mean length of the edges. Returns
/// the number of edges.
Index glue_cover(const PointsRef& vertices, const TrianglesRef& triangles, Cover& cover,
                 IntrinsicMesh& mesh) {
    const Index used = triangles.rows();
    std::vector<Side> sides;
    sides.reserve(static_cast<std::size_t>(3 * used));
    for (Index t = 0; t < used; ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, (k + 1) % 3), b = triangles(t, (k + 2) % 3);
            sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
        }
    std::sort(sides.begin(), sides.end());
    cover.twin.assign(static_cast<std::size_t>(6 * used), kNone);
    double length_sum = 0;
    Index num_edges = 0;
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first + 1;
        while (last < sides.size() && sides[last].low == sides[first].low &&
               sides[last].high == sides[first].high)
            ++last;
        length_sum += (vertices.row(sides[first].low) - vertices.row(sides[first].high)).norm();
        ++num_edges;
        if (last - first == 1)
            mesh.on_border[sides[first].low] = mesh.on_border[sides[first].high] = 1;
        glue_edge(&sides[first], last - first, vertices, triangles, cover);
        first = last;
    }
    mesh.mean_edge_mm = length_sum / static_cast<double>(num_edges);
    if (!(mesh.mean_edge_mm > 0))
        fail(Status::invalid_mesh, "all vertices of the surface lie in one place");
    return num_edges;
}

/// Corners and lengths of fronts and backs. All lengths are mollified by one number, just enough
/// that every triangle keeps the triangle inequality with slack.
void measure_cover(const PointsRef& vertices, const TrianglesRef& triangles, Cover& cover,
                   IntrinsicMesh& mesh) {
    const Index used = triangles.rows();
    cover.corners.resize(static_cast<std::size_t>(2 * used));
    cover.lengths.resize(static_cast<std::size_t>(2 * used));
    const double slack = kHeatMollification * mesh.mean_edge_mm;
    for (Index t = 0; t < used; ++t) {
        auto& front = cover.lengths[static_cast<std::size_t>(2 * t)];
        for (int k = 0; k < 3; ++k)
            front[k] =
                (vertices.row(triangles(t, (k + 1) % 3)) - vertices.row(triangles(t, (k + 2) % 3)))
                    .norm();
        for (int k = 0; k < 3; ++k)
            mesh.mollification_mm =
                std::max(mesh.mollification_mm,
                         slack - (front[(k + 1) % 3] + front[(k + 2) % 3] - front[k]));
    }
    for (Index t = 0; t < used; ++t) {
        const auto f = static_cast<std::size_t>(2 * t);
        for (int k = 0; k < 3; ++k) cover.lengths[f][k] += mesh.mollification_mm;
        cover.corners[f] = {triangles(t, 0), triangles(t, 1), triangles(t, 2)};
        cover.corners[f + 1] = {triangles(t, 0), triangles(t, 2), triangles(t, 1)};
        cover.lengths[f + 1] = {cover.lengths[f][0], cover.lengths[f][2], cover.lengths[f][1]};
    }
}

/// Flips edges, last in, first out, until all are Delaunay. The number of flips is finite in exact
/// arithmetic; `most` guards against rounding going round in circles. Returns the flips made.
Index flip_to_delaunay(Cover& cover, Index most) {
    std::vector<std::int64_t> open(cover.twin.size());
    for (std::size_t h = 0; h < open.size(); ++h)
        open[h] = static_cast<std::int64_t>(open.size() - 1 - h);
    std::vector<char> waiting(open.size(), 1);
    Index num_flips = 0;
    std::array<std::int64_t, 4> outer{};
    while (!open.empty() && num_flips < most) {
        const std::int64_t h = open.back();
        open.pop_back();
        waiting[static_cast<std::size_t>(h)] = 0;
        if (cover.is_delaunay(h) || !cover.flip(h, outer)) continue;
        ++num_flips;
        for (const std::int64_t o : outer)
            if (!waiting[static_cast<std::size_t>(o)]) {
                waiting[static_cast<std::size_t>(o)] = 1;
                open.push_back(o);
            }
    }
    return num_flips;
}

/// Front and back of a triangle far from borders end up alike; one with double weight serves both.
void merge_sides(const Cover& cover, IntrinsicMesh& mesh) {
    struct Key {
        std::array<std::uint32_t, 3> sorted;
        std::size_t triangle;
    };
    std::vector<Key> keys(cover.corners.size());
    for (std::size_t t = 0; t < keys.size(); ++t) {
        keys[t] = {cover.corners[t], t};
        std::sort(keys[t].sorted.begin(), keys[t].sorted.end());
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
        return a.sorted != b.sorted ? a.sorted < b.sorted : a.triangle < b.triangle;
    });
    const auto same_shape = [&](std::size_t a, std::size_t b) {
        auto la = cover.lengths[a], lb = cover.lengths[b];
        std::sort(la.begin(), la.end());
        std::sort(lb.begin(), lb.end());
        for (int k = 0; k < 3; ++k)
            if (std::abs(la[k] - lb[k]) > 1e-9 * la[2]) return false;
        return true;
    };
    std::vector<std::pair<std::size_t, double>> kept;
    for (std::size_t a = 0; a < keys.size(); ++a) {
        const auto& s = keys[a].sorted;
        const bool plain = s[0] != s[1] && s[1] != s[2];
        if (plain && a + 1 < keys.size() && keys[a + 1].sorted == s &&
            same_shape(keys[a].triangle, keys[a + 1].triangle)) {
            kept.emplace_back(keys[a].triangle, 1.0);
            ++a;
        } else {
            kept.emplace_back(keys[a].triangle, 0.5);
        }
    }
    std::sort(kept.begin(), kept.end());
    mesh.triangles.resize(static_cast<Index>(kept.size()), 3);
    mesh.lengths.resize(static_cast<Index>(kept.size()), 3);
    mesh.weights.resize(static_cast<Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            mesh.triangles(static_cast<Index>(t), k) = cover.corners[kept[t].first][k];
            mesh.lengths(static_cast<Index>(t), k) = cover.lengths[kept[t].first][k];
        }
        mesh.weights[static_cast<Index>(t)] = kept[t].second;
    }
}

}  // namespace

double IntrinsicMesh::double_area(Index t) const {
    return double_area_of(lengths(t, 0), lengths(t, 1), lengths(t, 2));
}

double IntrinsicMesh::cotangent(Index t, int k) const {
    const double a = lengths(t, k), b = lengths(t, (k + 1) % 3), c = lengths(t, (k + 2) % 3);
    return ((b - a) * (b + a) + c * c) / (2 * double_area_of(a, b, c));
}

IntrinsicMesh build_intrinsic_mesh(const PointsRef& vertices, const TrianglesRef& all_triangles,
                                   bool delaunay) {
    check_input(vertices, all_triangles);
    IntrinsicMesh mesh;
    mesh.num_vertices = vertices.rows();
    const Triangles triangles = proper_triangles(all_triangles);
    number_components(triangles, mesh);
    mesh.on_border.assign(static_cast<std::size_t>(vertices.rows()), 0);
    if (triangles.rows() == 0) return mesh;
    Cover cover;
    const Index num_edges = glue_cover(vertices, triangles, cover, mesh);
    measure_cover(vertices, triangles, cover, mesh);
    if (delaunay) mesh.num_flips = flip_to_delaunay(cover, 100 * num_edges + 1000);
    merge_sides(cover, mesh);
    return mesh;
}

}  // namespace mien
