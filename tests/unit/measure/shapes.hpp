// Small meshes with known answers, for the tests of this room.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien::test {

/// Icosahedron, subdivided and pushed onto the sphere; counter-clockwise from outside.
inline TriMesh sphere(double radius, int subdivisions) {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<Vector3> points{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    using Triple = std::array<std::uint32_t, 3>;
    std::vector<Triple> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto key = std::minmax(a, b);
            auto found = middles.find(key);
            if (found != middles.end()) return found->second;
            points.push_back((points[a].normalized() + points[b].normalized()) / 2.0);
            const auto index = static_cast<std::uint32_t>(points.size() - 1);
            middles[key] = index;
            return index;
        };
        std::vector<Triple> finer;
        for (const Triple& f : faces) {
            const std::uint32_t a = middle(f[0], f[1]), b = middle(f[1], f[2]),
                                c = middle(f[2], f[0]);
            finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
        }
        faces = finer;
    }
    TriMesh mesh;
    mesh.vertices.resize(static_cast<Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        mesh.vertices.row(static_cast<Index>(v)) = radius * points[v].normalized().transpose();
    mesh.triangles.resize(static_cast<Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            mesh.triangles(static_cast<Index>(f), k) = faces[f][static_cast<std::size_t>(k)];
    return mesh;
}

/// Flat grid in z = 0, width x height mm from the origin, nx x ny cells, normals +z.
inline TriMesh grid(double width, double height, int nx, int ny) {
    TriMesh mesh;
    mesh.vertices.resize((nx + 1) * (ny + 1), 3);
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            mesh.vertices.row(j * (nx + 1) + i) << width * i / nx, height * j / ny, 0.0;
    mesh.triangles.resize(2 * nx * ny, 3);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (nx + 1) + i), b = a + 1;
            const auto c = a + static_cast<std::uint32_t>(nx) + 1, d = c + 1;
            mesh.triangles.row(2 * (j * nx + i)) << a, b, d;
            mesh.triangles.row(2 * (j * nx + i) + 1) << a, d, c;
        }
    return mesh;
}

template <typename Body>
Status status_of(Body&& body) {
    try {
        body();
    } catch (const Error& error) {
        return error.status();
    }
    return Status::ok;
}

}  // namespace mien::test
