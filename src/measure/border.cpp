#include "measure/border.hpp"

namespace mien {

bool on_border(const std::vector<std::uint8_t>& border, const TrianglesRef& triangles,
               std::uint32_t triangle, const Vector3& barycentric) {
    // Every corner that carries weight is a border vertex, and not all three do.
    int carrying = 0;
    for (int k = 0; k < 3; ++k)
        if (barycentric[k] > 1e-9) {
            ++carrying;
            if (!border[triangles(static_cast<Index>(triangle), k)]) return false;
        }
    return carrying < 3;
}

}  // namespace mien
