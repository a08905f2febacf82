// Small meshes with known properties.
#pragma once

#include <vector>

#include "mesh/tri_mesh.hpp"

namespace mien::testing {

inline Points points_of(const std::vector<std::vector<double>>& rows) {
    Points points(static_cast<Index>(rows.size()), 3);
    for (Index v = 0; v < points.rows(); ++v)
        for (int k = 0; k < 3; ++k)
            points(v, k) = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(k)];
    return points;
}

inline Triangles triangles_of(const std::vector<std::vector<std::uint32_t>>& rows) {
    Triangles triangles(static_cast<Index>(rows.size()), 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            triangles(t, k) = rows[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
    return triangles;
}

/// Closed, oriented outwards.
inline TriMesh tetrahedron() {
    TriMesh mesh;
    mesh.vertices = points_of({{0, 0, 0}, {1.25, 0, 0}, {0, 2.5, 0}, {0, 0, -3.75}});
    mesh.triangles = triangles_of({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
    return mesh;
}

/// n x n vertices in the plane z = 0, one border loop.
inline TriMesh grid(Index n) {
    TriMesh mesh;
    mesh.vertices.resize(n * n, 3);
    mesh.triangles.resize(2 * (n - 1) * (n - 1), 3);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) mesh.vertices.row(i * n + j) << double(j), double(i), 0.0;
    Index t = 0;
    for (Index i = 0; i + 1 < n; ++i)
        for (Index j = 0; j + 1 < n; ++j) {
            const std::uint32_t a = static_cast<std::uint32_t>(i * n + j), b = a + 1,
                                c = a + static_cast<std::uint32_t>(n), d = c + 1;
            mesh.triangles.row(t++) << a, b, d;
            mesh.triangles.row(t++) << a, d, c;
        }
    return mesh;
}

/// Everything that a file can carry.
inline TriMesh colorful() {
    TriMesh mesh = tetrahedron();
    mesh.colors.resize(4, 3);
    mesh.colors << 0, 1, 2, 127, 128, 129, 254, 255, 3, 10, 20, 30;
    mesh.texture.resize(5, 2);
    mesh.texture << 0.f, 0.f, 1.f, 0.25f, 0.5f, 0.75f, 0.1f, 0.9f, 0.3f, 0.7f;
    mesh.texture_triangles = triangles_of({{0, 1, 2}, {4, 3, 1}, {1, 3, 2}, {2, 3, 0}});
    return mesh;
}

}  // namespace mien::testing
