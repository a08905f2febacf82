// Plates above each other: skin, and beneath it two walls that no scanner sees.
#pragma once

#include "mesh/tri_mesh.hpp"

namespace mien::test {

constexpr int kPlateSide = 21;

/// A square plate of 2 mm cells at height z, its normals along +z or -z.
inline void add_plate(TriMesh& mesh, double z, bool upwards) {
    const Index first = mesh.vertices.rows(), old = mesh.triangles.rows();
    mesh.vertices.conservativeResize(first + kPlateSide * kPlateSide, 3);
    mesh.triangles.conservativeResize(old + 2 * (kPlateSide - 1) * (kPlateSide - 1), 3);
    for (int j = 0; j < kPlateSide; ++j)
        for (int i = 0; i < kPlateSide; ++i)
            mesh.vertices.row(first + j * kPlateSide + i) << 2.0 * i, 2.0 * j, z;
    Index t = old;
    for (int j = 0; j + 1 < kPlateSide; ++j)
        for (int i = 0; i + 1 < kPlateSide; ++i) {
            const auto a = static_cast<std::uint32_t>(first + j * kPlateSide + i), b = a + 1,
                       c = a + kPlateSide, d = c + 1;
            mesh.triangles.row(t++) << a, (upwards ? b : d), (upwards ? d : b);
            mesh.triangles.row(t++) << a, (upwards ? d : c), (upwards ? c : d);
        }
}

/// Skin at z = 6, and beneath it two walls that face each other, 3 mm apart.
inline TriMesh pocket() {
    TriMesh mesh;
    mesh.vertices.resize(0, 3);
    mesh.triangles.resize(0, 3);
    add_plate(mesh, 6, true);
    add_plate(mesh, 4, false);
    add_plate(mesh, 1, true);
    return mesh;
}

inline Index middle(int plate) {
    return plate * kPlateSide * kPlateSide + (kPlateSide / 2) * kPlateSide + kPlateSide / 2;
}

}  // namespace mien::test
