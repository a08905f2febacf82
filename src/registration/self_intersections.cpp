#include "registration/self_intersections.hpp"

#include "base/parallel.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

// Share of an edge left out at each end, so that the triangles around its corners are not met.
constexpr double kShortened = 0.01;

}  // namespace

Index count_self_intersections(const PointsRef& places, const Triangles& triangles,
                               const Context& context) {
    const TriangleTree tree(places, triangles, context);
    const Index count = triangles.rows();
    return parallel_sum<Index>(
        context, static_cast<std::size_t>(count), 512, 0, [&](std::size_t begin, std::size_t end) {
            Index found = 0;
            for (std::size_t s = begin; s < end; ++s)
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t a = triangles(static_cast<Index>(s), k),
                                        b = triangles(static_cast<Index>(s), (k + 1) % 3);
                    if (a > b) continue;  // each inner edge once
                    const Vector3 from = places.row(a).transpose(),
                                  along = places.row(b).transpose() - from;
                    const RayHit hit =
                        tree.first_hit(from + kShortened * along, along, 1 - 2 * kShortened);
                    if (!hit.valid()) continue;
                    bool shares = false;
                    for (int c = 0; c < 3; ++c) {
                        const std::uint32_t v = triangles(static_cast<Index>(hit.triangle), c);
                        shares = shares || v == a || v == b;
                    }
                    if (!shares) ++found;
                }
            return found;
        });
}

}  // namespace mien
