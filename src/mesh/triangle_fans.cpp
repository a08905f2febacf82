#include "mesh/triangle_fans.hpp"

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
    std::vector<std::uint8_t> alike((n + kFanChunk - 1) / kFanChunk, 1);
    std::vector<std::vector<std::uint32_t>> pinched(alike.size());
    parallel_for(context, n, kFanChunk, [&](std::size_t first, std::size_t last) {
        bool all_alike = true;
        for (std::size_t v = first; v < last; ++v)
            inspect(v, all_alike, pinched[first / kFanChunk]);
        alike[first / kFanChunk] = all_alike;
    });
    for (std::size_t chunk = 0; chunk < alike.size(); ++chunk) {
        wound_alike_ = wound_alike_ && alike[chunk] != 0;
        pinched_.insert(pinched_.end(), pinched[chunk].begin(), pinched[chunk].end());
    }
}

// Whole: each vertex once in either list, and the same vertices. Many triangles around a vertex are
// sorted, and not walked around.
void TriangleFans::inspect(std::size_t vertex, bool& alike, std::vector<std::uint32_t>& pinched) {
    const std::uint32_t from = begin_[vertex], count = begin_[vertex + 1] - from;
    const std::uint32_t *next = next_.data() + from, *previous = previous_.data() + from;
    whole_[vertex] = 0;
    if (count > kMostCompared) {
        pinched.push_back(static_cast<std::uint32_t>(vertex));
        for (const std::uint32_t* list : {next, previous}) {
            std::vector<std::uint32_t> sorted(list, list + count);
            std::sort(sorted.begin(), sorted.end());
            alike = alike && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        }
        return;
    }
    // follower[k]: the triangle that begins where k ends.
    constexpr std::uint32_t kNoFollower = kMostCompared;
    std::uint32_t follower[kMostCompared], first = 0, num_ends = 0;
    bool led[kMostCompared] = {}, alike_here = true;
    for (std::uint32_t k = 0; k < count; ++k) {
        follower[k] = kNoFollower;
        for (std::uint32_t j = 0; j < count; ++j) {
            if (j != k) alike_here &= next[j] != next[k] && previous[j] != previous[k];
            if (next[j] != previous[k]) continue;
            follower[k] = j;
            led[j] = true;
        }
        num_ends += follower[k] == kNoFollower;
    }
    alike = alike && alike_here;
    whole_[vertex] = alike_here && num_ends == 0;
    for (std::uint32_t k = 0; k < count; ++k)
        if (!led[k]) first = k;
    std::uint32_t steps = 0;
    for (std::uint32_t k = first; k != kNoFollower && steps < count; k = follower[k]) {
        ++steps;
        if (follower[k] == first) break;
    }
    if (steps < count) pinched.push_back(static_cast<std::uint32_t>(vertex));
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
