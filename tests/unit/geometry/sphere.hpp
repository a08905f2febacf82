// Surfaces whose geodesics are known: flat sheets and the unit sphere.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/types.hpp"

namespace mien::test {

struct Surface {
    Points vertices;
    Triangles triangles;
};

/// A sheet of columns x rows squares in the plane z = 0, with alternating diagonals.
inline Surface sheet(int columns, int rows, double step = 1.0) {
    Surface s;
    s.vertices.resize((columns + 1) * (rows + 1), 3);
    s.triangles.resize(2 * columns * rows, 3);
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x)
            s.vertices.row(y * (columns + 1) + x) << x * step, y * step, 0.0;
    Index t = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const auto a = static_cast<std::uint32_t>(y * (columns + 1) + x);
            const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(columns) + 1,
                                d = c + 1;
            if ((x + y) % 2 == 0) {
                s.triangles.row(t++) << a, b, d;
                s.triangles.row(t++) << a, d, c;
            } else {
                s.triangles.row(t++) << a, b, c;
                s.triangles.row(t++) << b, d, c;
            }
        }
    return s;
}

/// An icosahedron whose faces are cut into n^2 triangles: 10 n^2 + 2 vertices on the unit sphere.
inline Surface sphere(int n) {
    const double p = (1 + std::sqrt(5.0)) / 2;
    const double corner[12][3] = {{-1, p, 0}, {1, p, 0}, {-1, -p, 0}, {1, -p, 0},
                                  {0, -1, p}, {0, 1, p}, {0, -1, -p}, {0, 1, -p},
                                  {p, 0, -1}, {p, 0, 1}, {-p, 0, -1}, {-p, 0, 1}};
    const int face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                             {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                             {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                             {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    std::map<std::array<long, 3>, std::uint32_t> numbers;
    std::vector<Eigen::RowVector3d> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const auto at = [&](const int* f, int i, int j) {
        Eigen::RowVector3d x = Eigen::RowVector3d::Zero();
        const int weight[3] = {n - i - j, i, j};
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) x[c] += weight[k] * corner[f[k]][c];
        const std::array<long, 3> key{std::lround(x[0] * 1e6), std::lround(x[1] * 1e6),
                                      std::lround(x[2] * 1e6)};
        const auto found = numbers.emplace(key, static_cast<std::uint32_t>(points.size()));
        if (found.second) points.push_back(x.normalized());
        return found.first->second;
    };
    for (const auto& f : face)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n - i; ++j) {
                triangles.push_back({at(f, i, j), at(f, i + 1, j), at(f, i, j + 1)});
                if (i + j < n - 1)
                    triangles.push_back({at(f, i + 1, j), at(f, i + 1, j + 1), at(f, i, j + 1)});
            }
    Surface s;
    s.vertices.resize(static_cast<Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        s.vertices.row(static_cast<Index>(v)) = points[v];
    s.triangles.resize(static_cast<Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            s.triangles(static_cast<Index>(t), k) = triangles[t][static_cast<std::size_t>(k)];
    return s;
}

}  // namespace mien::test
