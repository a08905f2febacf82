#include "measure/border.hpp"

#include <algorithm>
#include <utility>

namespace mien {

std::vector<char> border_vertices(const TrianglesRef& triangles, Index num_vertices) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(static_cast<std::size_t>(triangles.rows()) * 3);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    std::vector<char> border(static_cast<std::size_t>(num_vertices), 0);
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i + 1;
        while (j < edges.size() && edges[j] == edges[i]) ++j;
        if (j - i == 1) border[edges[i].first] = border[edges[i].second] = 1;
        i = j;
    }
    return border;
}

bool on_border(const std::vector<char>& border, const TrianglesRef& triangles,
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
