// Meshes and deformations for the tests of the spectral room.
#pragma once

#include <cmath>
#include <cstdint>

#include "unit/measure/shapes.hpp"

namespace mien::test {

/// A bump with a border and unequal triangles, about 40 mm wide.
inline TriMesh face_like(int cells = 20) {
    TriMesh mesh = grid(40, 40, cells, cells);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const double x = mesh.vertices(v, 0) - 20, y = mesh.vertices(v, 1) - 20;
        mesh.vertices(v, 2) = 15 * std::exp(-(x * x + y * y) / 200) + 0.3 * std::sin(0.8 * x);
        mesh.vertices(v, 0) += 0.25 * std::sin(0.7 * y);
    }
    return mesh;
}

/// Repeatable values in [-1, 1].
inline double noise(std::uint64_t i) {
    std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-52 - 1.0;
}
inline Points noisy(const Points& points, double amplitude, std::uint64_t seed = 0) {
    Points result = points;
    for (Index v = 0; v < points.rows(); ++v)
        for (int d = 0; d < 3; ++d)
            result(v, d) += amplitude * noise(seed + 3 * static_cast<std::uint64_t>(v) +
                                              static_cast<std::uint64_t>(d));
    return result;
}
/// A smooth bend.
inline Points bent(const Points& points, double amount) {
    Points result = points;
    for (Index v = 0; v < points.rows(); ++v)
        result(v, 2) +=
            amount * std::cos(0.1 * points(v, 0)) + 0.5 * amount * std::sin(0.08 * points(v, 1));
    return result;
}

}  // namespace mien::test
