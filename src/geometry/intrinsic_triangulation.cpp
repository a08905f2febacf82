#include "geometry/intrinsic_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"

namespace mien {
namespace {

// Relative to the mean edge: small enough to change no result that is read, large enough for
// cotangents of at most 1e5 or so.
constexpr double kMollification = 1e-6;
// Cotangents are free of scale; a weight above this is not worth a flip and cannot cycle.
constexpr double kFlipThreshold = -1e-9;

}  // namespace

double IntrinsicTriangle::area() const {
    double a = length[0], b = length[1], c = length[2];
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return square > 0 ? 0.25 * std::sqrt(square) : 0.0;
}

std::array<double, 3> IntrinsicTriangle::cotangents(double area) const {
    std::array<double, 3> result;
    for (int c = 0; c < 3; ++c) {
        const double left = length[c], right = length[(c + 2) % 3], opposite = length[(c + 1) % 3];
        // left^2 + right^2 - opposite^2 without the cancellation of three large squares.
        result[c] = (left * left + (right - opposite) * (right + opposite)) / (4 * area);
    }
    return result;
}

IntrinsicTriangulation::IntrinsicTriangulation(const PointsRef& vertices,
                                               const TrianglesRef& triangles) {
    const Index n = vertices.rows();
    if (n == 0) fail(Status::invalid_mesh, "Laplacian of a mesh without vertices");
    for (Index v = 0; v < n; ++v)
        if (!vertices.row(v).allFinite())
            fail_at(Status::invalid_mesh, v, "vertex %lld of the mesh is not finite",
                    static_cast<long long>(v));
    triangles_.reserve(static_cast<std::size_t>(triangles.rows()));
    double total = 0;
    for (Index f = 0; f < triangles.rows(); ++f) {
        IntrinsicTriangle t;
        for (int c = 0; c < 3; ++c) {
            t.vertex[c] = triangles(f, c);
            if (t.vertex[c] >= static_cast<std::uint64_t>(n))
                fail_at(Status::invalid_mesh, f, "triangle %lld names vertex %u of %lld",
                        static_cast<long long>(f), t.vertex[c], static_cast<long long>(n));
        }
        if (t.vertex[0] == t.vertex[1] || t.vertex[1] == t.vertex[2] || t.vertex[2] == t.vertex[0])
            continue;
        for (int c = 0; c < 3; ++c) {
            t.length[c] = (vertices.row(t.vertex[(c + 1) % 3]) - vertices.row(t.vertex[c])).norm();
            total += t.length[c];
        }
        triangles_.push_back(t);
    }
    if (triangles_.empty()) return;

    double mean = total / (3.0 * static_cast<double>(triangles_.size()));
    if (!std::isfinite(mean))
        fail(Status::invalid_mesh, "the mesh is too large for its edge lengths");
    if (!(mean > 0)) mean = 1.0;  // every vertex in one place: any scale will do
    const double margin = kMollification * mean;
    for (const IntrinsicTriangle& t : triangles_)
        for (int c = 0; c < 3; ++c)
            mollification_ = std::max(mollification_, margin + t.length[c] - t.length[(c + 1) % 3] -
                                                          t.length[(c + 2) % 3]);
    if (mollification_ > 0)
        for (IntrinsicTriangle& t : triangles_)
            for (double& length : t.length) length += mollification_;
}

void IntrinsicTriangulation::glue() {
    struct HalfEdge {
        std::uint32_t low, high;
        std::int32_t triangle, side;
        bool operator<(const HalfEdge& o) const {
            return low != o.low             ? low < o.low
                   : high != o.high         ? high < o.high
                   : triangle != o.triangle ? triangle < o.triangle
                                            : side < o.side;
        }
    };
    std::vector<HalfEdge> edges;
    edges.reserve(triangles_.size() * 3);
    for (std::size_t f = 0; f < triangles_.size(); ++f)
        for (int s = 0; s < 3; ++s) {
            const std::uint32_t a = triangles_[f].vertex[s], b = triangles_[f].vertex[(s + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f), s});
        }
    std::sort(edges.begin(), edges.end());
    neighbour_.assign(triangles_.size(), {});
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
        end = begin + 1;
        while (end < edges.size() && edges[end].low == edges[begin].low &&
               edges[end].high == edges[begin].high)
            ++end;
        if (end - begin != 2) continue;
        const HalfEdge &a = edges[begin], &b = edges[begin + 1];
        const bool opposite =
            triangles_[a.triangle].vertex[a.side] != triangles_[b.triangle].vertex[b.side];
        if (!opposite) continue;
        neighbour_[a.triangle][a.side] = {b.triangle, b.side};
        neighbour_[b.triangle][b.side] = {a.triangle, a.side};
    }
}

bool IntrinsicTriangulation::flip(std::int32_t first, int side) {
    const Side across = neighbour_[first][side];
    const std::int32_t second = across.triangle;
    if (second < 0 || second == first) return false;
    IntrinsicTriangle &a = triangles_[first], &b = triangles_[second];
    const int sa = side, sb = across.side;
    const int sa1 = (sa + 1) % 3, sa2 = (sa + 2) % 3, sb1 = (sb + 1) % 3, sb2 = (sb + 2) % 3;
    const double area_a = a.area(), area_b = b.area();
    if (!(area_a > 0) || !(area_b > 0)) return false;
    const double cot_a = a.cotangents(area_a)[sa2], cot_b = b.cotangents(area_b)[sb2];
    if (cot_a + cot_b >= kFlipThreshold) return false;

    // Both triangles side by side in the plane: edge on the x axis, a's corner above, b's below.
    const double base = a.length[sa];
    const double xa =
        (base * base + a.length[sa2] * a.length[sa2] - a.length[sa1] * a.length[sa1]) / (2 * base);
    const double xb =
        (base * base + b.length[sb1] * b.length[sb1] - b.length[sb2] * b.length[sb2]) / (2 * base);
    const double height = 2 * (area_a + area_b) / base;
    const double diagonal = std::hypot(xa - xb, height);

    // a = (i, j, k), b = (j, i, l) with the edge i-j  ->  (k, l, j) and (l, k, i).
    const std::uint32_t i = a.vertex[sa], j = a.vertex[sa1], k = a.vertex[sa2], l = b.vertex[sb2];
    const double jk = a.length[sa1], ki = a.length[sa2], il = b.length[sb1], lj = b.length[sb2];
    IntrinsicTriangle new_a = {{k, l, j}, {diagonal, lj, jk}};
    IntrinsicTriangle new_b = {{l, k, i}, {diagonal, ki, il}};
    // Rounding may leave a sliver without area, which would be worse than the edge it replaces.
    if (!(new_a.area() > 0) || !(new_b.area() > 0)) return false;
    const Side n_jk = neighbour_[first][sa1], n_ki = neighbour_[first][sa2];
    const Side n_il = neighbour_[second][sb1], n_lj = neighbour_[second][sb2];
    a = new_a;
    b = new_b;
    // The outer neighbours may be the two triangles themselves (two sides of one glued together).
    const auto moved = [&](Side s) -> Side {
        if (s.triangle == first && s.side == sa1) return {first, 2};
        if (s.triangle == first && s.side == sa2) return {second, 1};
        if (s.triangle == second && s.side == sb1) return {second, 2};
        if (s.triangle == second && s.side == sb2) return {first, 1};
        return s;
    };
    const auto connect = [&](std::int32_t triangle, int s, Side target) {
        neighbour_[triangle][s] = target;
        if (target.triangle >= 0) neighbour_[target.triangle][target.side] = {triangle, s};
    };
    const Side to_jk = moved(n_jk), to_ki = moved(n_ki), to_il = moved(n_il), to_lj = moved(n_lj);
    neighbour_[first][0] = {second, 0};
    neighbour_[second][0] = {first, 0};
    connect(first, 1, to_lj);
    connect(first, 2, to_jk);
    connect(second, 1, to_ki);
    connect(second, 2, to_il);
    return true;
}

std::size_t IntrinsicTriangulation::make_delaunay() {
    glue();
    std::vector<Side> pending;
    std::vector<std::array<bool, 3>> waits(triangles_.size(), {true, true, true});
    for (std::size_t f = triangles_.size(); f-- > 0;)
        for (int s = 3; s-- > 0;) pending.push_back({static_cast<std::int32_t>(f), s});
    // Flips end in exact arithmetic; the limit is for rounding alone.
    const std::size_t limit = 100 * triangles_.size() + 1000;
    std::size_t flips = 0;
    while (!pending.empty() && flips < limit) {
        const Side next = pending.back();
        pending.pop_back();
        waits[next.triangle][next.side] = false;
        const std::int32_t other = neighbour_[next.triangle][next.side].triangle;
        if (!flip(next.triangle, next.side)) continue;
        ++flips;
        for (const std::int32_t triangle : {next.triangle, other})
            for (int s = 1; s < 3; ++s)
                if (!waits[triangle][s]) {
                    waits[triangle][s] = true;
                    pending.push_back({triangle, s});
                }
    }
    return flips;
}

}  // namespace mien
