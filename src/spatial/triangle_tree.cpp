#include "spatial/triangle_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "spatial/triangle_distance.hpp"

namespace mien {

namespace {

constexpr std::uint32_t kBlock = 4;         // primitives in a leaf block
constexpr std::size_t kTaskItems = 4096;    // below this a task sorts a range to the end by itself
constexpr std::size_t kBoxChunk = 2048;

struct Item {
    float centroid[3];
    std::uint32_t id;
};

// Partitions items[begin, end) so that the first `half` have the smaller centroids along the widest
// axis. Ties fall by index, so that the order does not depend on the library's partition.
void split(Item* begin, Item* end, std::size_t half) {
    if (static_cast<std::size_t>(end - begin) <= half) return;
    float lower[3], upper[3];
    for (int k = 0; k < 3; ++k) lower[k] = upper[k] = begin->centroid[k];
    for (const Item* item = begin; item != end; ++item)
        for (int k = 0; k < 3; ++k) {
            lower[k] = std::min(lower[k], item->centroid[k]);
            upper[k] = std::max(upper[k], item->centroid[k]);
        }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (upper[k] - lower[k] > upper[axis] - lower[axis]) axis = k;
    std::nth_element(begin, begin + half, end, [axis](const Item& x, const Item& y) {
        return x.centroid[axis] < y.centroid[axis] ||
               (x.centroid[axis] == y.centroid[axis] && x.id < y.id);
    });
}

using Float4 = Eigen::Array<float, 4, 1>;

// Squared distances from q to four boxes, never above the true ones: boxes carry their margin, and
// the last factor covers the rounding of a far point to float.
Float4 squared_distances(const float lower[3][4], const float upper[3][4], const float q[3]) {
    Float4 sum = Float4::Zero();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Map<const Float4> low(lower[k]), high(upper[k]);
        const Float4 gap = (low - q[k]).max(q[k] - high).max(Float4::Zero());
        sum += gap * gap;
    }
    return sum * (1.0f - 4e-6f);
}

struct Entry {
    float squared_distance;
    std::uint32_t index;
    std::uint32_t level;
};

}  // namespace

TriangleTree::TriangleTree(const PointsRef& vertices, const TrianglesRef& triangles,
                           const Context& context)
    : point_cloud_(triangles.rows() == 0) {
    const std::size_t count =
        static_cast<std::size_t>(point_cloud_ ? vertices.rows() : triangles.rows());
    if (count == 0) fail(Status::invalid_mesh, "a search tree over an empty mesh");
    if (count >= SurfaceHit::kNone - kBlock)
        fail(Status::invalid_mesh, "a search tree over more than 2^32 triangles");
    context.require_memory(count * (sizeof(Triangle) + 8 + sizeof(Item) + 12), "the search tree");
    sort_primitives(vertices, triangles, context);
    build_boxes(context);
}

void TriangleTree::sort_primitives(const PointsRef& vertices, const TrianglesRef& triangles,
                                   const Context& context) {
    const std::size_t count =
        static_cast<std::size_t>(point_cloud_ ? vertices.rows() : triangles.rows());
    Vector3 low = vertices.row(0).transpose(), high = low;
    for (Index i = 0; i < vertices.rows(); ++i) {
        low = low.cwiseMin(vertices.row(i).transpose());
        high = high.cwiseMax(vertices.row(i).transpose());
    }
    centre_ = 0.5 * (low + high);
    lower_ = low - centre_;
    upper_ = high - centre_;

    const auto corner = [&](std::size_t id, int k) -> Vector3 {
        const Index vertex = point_cloud_ ? static_cast<Index>(id)
                                          : static_cast<Index>(triangles(static_cast<Index>(id), k));
        return vertices.row(vertex).transpose() - centre_;
    };
    std::vector<Item> items(count);
    parallel_for(context, count, kTaskItems, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vector3 centroid = (corner(i, 0) + corner(i, 1) + corner(i, 2)) / 3.0;
            for (int k = 0; k < 3; ++k) items[i].centroid[k] = static_cast<float>(centroid[k]);
            items[i].id = static_cast<std::uint32_t>(i);
        }
    });

    std::size_t half = kBlock;
    while (2 * half < count) half *= 2;
    Item* const all = items.data();
    for (; half >= kTaskItems; half /= 2) {
        parallel_for(context, (count + 2 * half - 1) / (2 * half), 1, [&](std::size_t group, std::size_t) {
            split(all + group * 2 * half, all + std::min(count, (group + 1) * 2 * half), half);
        });
    }
    parallel_for(context, count, 2 * half, [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = half; h >= kBlock; h /= 2)
            for (std::size_t b = begin; b < end; b += 2 * h)
                split(all + b, all + std::min(end, b + 2 * h), h);
    });

    primitives_.resize(count);
    id_of_.resize(count);
    slot_of_.resize(count);
    parallel_for(context, count, kTaskItems, [&](std::size_t begin, std::size_t end) {
        // Ascending ids within a block, so that ties meet the lowest index first.
        for (std::size_t b = begin; b < end; b += kBlock)
            std::sort(all + b, all + std::min(end, b + kBlock),
                      [](const Item& x, const Item& y) { return x.id < y.id; });
        for (std::size_t slot = begin; slot < end; ++slot) {
            const std::uint32_t id = items[slot].id;
            id_of_[slot] = id;
            slot_of_[id] = static_cast<std::uint32_t>(slot);
            Triangle& t = primitives_[slot];
            Eigen::Map<Vector3>(t.a, 3) = corner(id, 0);
            Eigen::Map<Vector3>(t.b, 3) = corner(id, 1);
            Eigen::Map<Vector3>(t.c, 3) = corner(id, 2);
        }
    });
}

void TriangleTree::build_boxes(const Context& context) {
    const std::size_t count = primitives_.size();
    std::size_t children = (count + kBlock - 1) / kBlock, total = 0;
    do {
        level_begin_.push_back(static_cast<std::uint32_t>(total));
        children = (children + kWidth - 1) / kWidth;
        total += children;
    } while (children > 1);
    level_begin_.push_back(static_cast<std::uint32_t>(total));
    nodes_.resize(total);

    // Wide enough for the rounding of corners and of near query points to float.
    const float margin =
        static_cast<float>(4e-7 * std::max(upper_.cwiseAbs().maxCoeff(), 1e-30));
    const float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t level = 0; level + 1 < level_begin_.size(); ++level) {
        const std::size_t first = level_begin_[level], last = level_begin_[level + 1];
        parallel_for(context, last - first, kBoxChunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                Node& node = nodes_[first + n];
                for (int child = 0; child < kWidth; ++child) {
                    float low[3] = {infinity, infinity, infinity};
                    float high[3] = {-infinity, -infinity, -infinity};
                    const std::size_t index = n * kWidth + static_cast<std::size_t>(child);
                    if (level == 0) {
                        for (std::size_t s = index * kBlock; s < std::min(count, (index + 1) * kBlock); ++s) {
                            const Triangle& t = primitives_[s];
                            for (int k = 0; k < 3; ++k) {
                                const double l = std::min({t.a[k], t.b[k], t.c[k]});
                                const double h = std::max({t.a[k], t.b[k], t.c[k]});
                                low[k] = std::min(low[k], static_cast<float>(l) - margin);
                                high[k] = std::max(high[k], static_cast<float>(h) + margin);
                            }
                        }
                    } else if (level_begin_[level - 1] + index < first) {
                        const Node& below = nodes_[level_begin_[level - 1] + index];
                        for (int k = 0; k < 3; ++k)
                            for (int c = 0; c < kWidth; ++c) {
                                low[k] = std::min(low[k], below.lower[k][c]);
                                high[k] = std::max(high[k], below.upper[k][c]);
                            }
                    }
                    for (int k = 0; k < 3; ++k) {
                        node.lower[k][child] = low[k];
                        node.upper[k][child] = high[k];
                    }
                }
            }
        });
    }
}

void TriangleTree::test_slot(std::uint32_t slot, const Vector3& point, SurfaceHit& best) const {
    const Triangle& t = primitives_[slot];
    const Eigen::Map<const Vector3> a(t.a), b(t.b), c(t.c);
    TrianglePlace place;
    if (point_cloud_)
        place = {Vector3(1, 0, 0), a, (point - a).squaredNorm()};
    else
        place = closest_on_triangle(point, a, b, c);
    if (place.squared_distance < best.squared_distance ||
        (place.squared_distance == best.squared_distance && id_of_[slot] < best.triangle)) {
        best.triangle = id_of_[slot];
        best.barycentric = place.barycentric;
        best.point = place.point;
        best.squared_distance = place.squared_distance;
    }
}

void TriangleTree::test_block(std::uint32_t block, const Vector3& point, SurfaceHit& best) const {
    const std::uint32_t begin = block * kBlock;
    const std::uint32_t end =
        std::min(begin + kBlock, static_cast<std::uint32_t>(primitives_.size()));
    for (std::uint32_t slot = begin; slot < end; ++slot) test_slot(slot, point, best);
}

SurfaceHit TriangleTree::closest(const Vector3& point, double max_distance,
                                 std::uint32_t hint) const {
    SurfaceHit best;
    if (nodes_.empty()) return best;
    const Vector3 q = point - centre_;
    const float qf[3] = {static_cast<float>(q[0]), static_cast<float>(q[1]),
                         static_cast<float>(q[2])};
    best.squared_distance = max_distance * max_distance;
    if (hint < slot_of_.size()) test_slot(slot_of_[hint], q, best);

    Entry stack[64];
    int size = 0;
    const std::uint32_t top = static_cast<std::uint32_t>(level_begin_.size() - 2);
    stack[size++] = {0.0f, 0, top + 1};
    while (size > 0) {
        const Entry entry = stack[--size];
        if (static_cast<double>(entry.squared_distance) > best.squared_distance) continue;
        if (entry.level == 0) {
            test_block(entry.index, q, best);
            continue;
        }
        const Node& node = nodes_[level_begin_[entry.level - 1] + entry.index];
        const Float4 distances = squared_distances(node.lower, node.upper, qf);
        const int base = size;
        for (int child = 0; child < kWidth; ++child) {
            if (!(static_cast<double>(distances[child]) <= best.squared_distance) ||
                distances[child] == std::numeric_limits<float>::infinity())
                continue;
            Entry next{distances[child], entry.index * kWidth + static_cast<std::uint32_t>(child),
                       entry.level - 1};
            int place = size++;  // farthest first, so that the nearest is popped next
            while (place > base && stack[place - 1].squared_distance < next.squared_distance) {
                stack[place] = stack[place - 1];
                --place;
            }
            stack[place] = next;
        }
    }
    if (best.valid())
        best.point += centre_;
    else
        best.squared_distance = std::numeric_limits<double>::infinity();
    return best;
}

void TriangleTree::closest(const PointsRef& points, double max_distance,
                           std::vector<SurfaceHit>& hits, const Context& context) const {
    const std::size_t count = static_cast<std::size_t>(points.rows());
    if (hits.size() != count) hits.assign(count, SurfaceHit());
    parallel_for(context, count, 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            hits[i] = closest(points.row(static_cast<Index>(i)).transpose(), max_distance,
                              hits[i].triangle);
    });
}

template <typename Visit>
void TriangleTree::walk_ray(const Vector3& origin, const Vector3& direction, double& max_t,
                            Visit&& visit) const {
    if (nodes_.empty() || point_cloud_) return;
    const Vector3 o = origin - centre_;
    std::uint32_t stack_index[64], stack_level[64];
    int size = 0;
    stack_index[size] = 0;
    stack_level[size++] = static_cast<std::uint32_t>(level_begin_.size() - 1);
    const double margin = 1e-6 * (upper_.cwiseAbs().maxCoeff() + o.cwiseAbs().maxCoeff());
    while (size > 0) {
        --size;
        const std::uint32_t index = stack_index[size], level = stack_level[size];
        if (level == 0) {
            const std::uint32_t begin = index * kBlock;
            const std::uint32_t end =
                std::min(begin + kBlock, static_cast<std::uint32_t>(primitives_.size()));
            for (std::uint32_t slot = begin; slot < end; ++slot) {
                const Triangle& t = primitives_[slot];
                const Eigen::Map<const Vector3> a(t.a), b(t.b), c(t.c);
                // origin + t direction = a + v ab + w ac by Cramer's rule (Moeller, Trumbore).
                const Vector3 ab = b - a, ac = c - a, from_a = o - a;
                const Vector3 p = direction.cross(ac), q = from_a.cross(ab);
                const double determinant = ab.dot(p);
                if (determinant == 0) continue;
                const double v = from_a.dot(p) / determinant, w = direction.dot(q) / determinant;
                const double t_hit = ac.dot(q) / determinant;
                if (!(t_hit >= 0 && t_hit <= max_t && v >= 0 && w >= 0 && v + w <= 1)) continue;
                visit(id_of_[slot], t_hit, Vector3(1 - v - w, v, w));
            }
            continue;
        }
        const Node& node = nodes_[level_begin_[level - 1] + index];
        for (int child = kWidth - 1; child >= 0; --child) {
            double enter = 0, leave = max_t;
            for (int k = 0; k < 3; ++k) {
                const double low = node.lower[k][child] - margin, high = node.upper[k][child] + margin;
                if (direction[k] == 0) {
                    if (o[k] < low || o[k] > high) leave = -1;
                    continue;
                }
                const double t0 = (low - o[k]) / direction[k], t1 = (high - o[k]) / direction[k];
                enter = std::max(enter, std::min(t0, t1));
                leave = std::min(leave, std::max(t0, t1));
            }
            if (!(enter <= leave)) continue;
            stack_index[size] = index * kWidth + static_cast<std::uint32_t>(child);
            stack_level[size++] = level - 1;
        }
    }
}

RayHit TriangleTree::first_hit(const Vector3& origin, const Vector3& direction,
                               double max_t) const {
    RayHit best;
    walk_ray(origin, direction, max_t,
             [&](std::uint32_t id, double t, const Vector3& barycentric) {
                 if (t > best.t || (t == best.t && id > best.triangle)) return;
                 best = {id, t, barycentric};
                 max_t = t;
             });
    return best;
}

Index TriangleTree::count_crossings(const Vector3& origin, const Vector3& direction,
                                    double max_t) const {
    Index count = 0;
    walk_ray(origin, direction, max_t,
             [&](std::uint32_t, double, const Vector3&) { ++count; });
    return count;
}

}  // namespace mien
