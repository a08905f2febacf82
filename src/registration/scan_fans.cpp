#include "registration/scan_fans.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr std::size_t kFanChunk = 8192;
// Triangles around a vertex; with more, both lists are read, which is right for any.
constexpr std::uint32_t kMostCompared = 32;

}  // namespace

TriangleFans::TriangleFans(Index num_vertices, const TrianglesRef& triangles,
                           const Context& context) {
    const std::size_t n = static_cast<std::size_t>(num_vertices);
    context.require_memory(24 * static_cast<std::size_t>(triangles.rows()) + 9 * n,
                           "the neighbours of a scan's vertices");
    begin_.assign(n + 1, 0);
    const std::uint32_t* corners = triangles.data();
    const Index count = triangles.rows();
    for (Index k = 0; k < 3 * count; ++k) ++begin_[corners[k] + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    next_.resize(begin_.back());
    previous_.resize(begin_.back());
    std::vector<std::uint32_t> fill(begin_.begin(), begin_.end() - 1);
    for (Index t = 0; t < count; ++t, corners += 3)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t slot = fill[corners[k]]++;
            next_[slot] = corners[(k + 1) % 3];
            previous_[slot] = corners[(k + 2) % 3];
        }
    whole_.resize(n);
    // Each vertex once in either list, and the same vertices.
    parallel_for(context, n, kFanChunk, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) {
            const auto from = begin_[v], to = begin_[v + 1];
            bool whole = to - from <= kMostCompared;
            for (std::uint32_t k = from; k < to && whole; ++k) {
                int in_next = 0, in_previous = 0;
                for (std::uint32_t j = from; j < to; ++j) {
                    in_next += next_[j] == next_[k];
                    in_previous += previous_[j] == next_[k];
                }
                whole = in_next == 1 && in_previous == 1;
            }
            whole_[v] = whole;
        }
    });
}

std::vector<std::uint8_t> TriangleFans::border(const Context& context) const {
    std::vector<std::uint8_t> border(whole_.size(), 0);
    parallel_for(context, border.size(), kFanChunk, [&](std::size_t first, std::size_t last) {
        std::vector<std::uint32_t> around;
        for (std::size_t v = first; v < last; ++v) {
            if (whole_[v]) continue;
            around.assign(next_.begin() + begin_[v], next_.begin() + begin_[v + 1]);
            around.insert(around.end(), previous_.begin() + begin_[v],
                          previous_.begin() + begin_[v + 1]);
            std::sort(around.begin(), around.end());
            for (std::size_t k = 0; k < around.size() && !border[v]; ++k)
                border[v] = (k == 0 || around[k - 1] != around[k]) &&
                            (k + 1 == around.size() || around[k + 1] != around[k]);
        }
    });
    return border;
}

}  // namespace mien
