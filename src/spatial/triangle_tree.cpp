#include "spatial/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "spatial/tree_order.hpp"
#include "spatial/triangle_distance.hpp"

namespace mien {

namespace {

constexpr std::size_t kTaskItems = 4096;  // at a time
constexpr std::size_t kBoxChunk = 2048;
constexpr std::uint64_t kLowHalf = 0xffffffffu;
// Twice the area over the longest side's square below which a triangle has no directions.
constexpr double kFlat = 1e-7;
constexpr float kBoxMargin = 2e-6f;  // of a box's largest coordinate

float size_of(const Vector3& place) {
    return static_cast<float>(place.cwiseAbs().maxCoeff());
}

// Where the coordinates of the tree's floats begin. The middle of the box, as a rule; but where a
// few vertices lie so far away that floats from there could not tell the others apart, the middle
// of the many. From a sample, every coordinate's own.
Vector3 middle_of(const PointsRef& vertices, const Vector3& low, const Vector3& high) {
    constexpr Index kSample = 999;
    constexpr double kFar = 64;  // times the extent of the middle nine tenths of the sample
    const Index n = vertices.rows(), stride = std::max<Index>(1, n / kSample);
    Vector3 middle = 0.5 * (low + high);
    std::vector<double> sample;
    double extent = 0;
    Vector3 medians;
    for (int k = 0; k < 3; ++k) {
        sample.clear();
        for (Index i = 0; i < n; i += stride) sample.push_back(vertices(i, k));
        std::sort(sample.begin(), sample.end());
        const std::size_t cut = sample.size() / 20;
        extent = std::max(extent, sample[sample.size() - 1 - cut] - sample[cut]);
        medians[k] = sample[sample.size() / 2];
    }
    if ((high - low).maxCoeff() > kFar * extent && extent > 0) middle = medians;
    return middle;
}

const tree_search::Loops& loops() {
#if defined(MIEN_AVX2)
    if (dense::uses_avx2()) return tree_search::avx2_loops();
#endif
    return tree_search::portable_loops();
}

}  // namespace

TriangleTree::TriangleTree(const PointsRef& vertices, const TrianglesRef& triangles,
                           const Context& context)
    : point_cloud_(triangles.rows() == 0), block_size_(point_cloud_ ? 1 : tree_search::kWidth) {
    const std::size_t count =
        static_cast<std::size_t>(point_cloud_ ? vertices.rows() : triangles.rows());
    if (count == 0) fail(Status::invalid_mesh, "a search tree over an empty mesh");
    if (count >= SurfaceHit::kNone - block_size_)
        fail(Status::invalid_mesh, "a search tree over more than 2^32 triangles");
    context.require_memory(
        count * (sizeof(Corners) + 8 + sizeof(TreeItem) + 4 + (point_cloud_ ? 24 : 64)) +
            static_cast<std::size_t>(vertices.rows()) * 24,
        "the search tree");
    sort_primitives(vertices, triangles, context);
    build_blocks(context);
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
    centre_ = middle_of(vertices, low, high);
    lower_ = low - centre_;
    upper_ = high - centre_;

    const double largest = std::max(lower_.cwiseAbs().maxCoeff(), upper_.cwiseAbs().maxCoeff());
    extent_ = static_cast<float>(std::max(largest, 1e-30)) * 1.001f;
    places_ = vertices.rowwise() - centre_.transpose();
    const auto corners_of = [&](std::size_t id) -> Corners {
        const auto point = static_cast<std::uint32_t>(id);
        if (point_cloud_) return {{point, point, point}};
        const auto row = triangles.row(static_cast<Index>(id));
        return {{row[0], row[1], row[2]}};
    };
    RawVector<TreeItem> items(count);
    parallel_for(context, count, kTaskItems, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Corners c = corners_of(i);
            const Vector3 centroid =
                (places_.row(c.vertex[0]) + places_.row(c.vertex[1]) + places_.row(c.vertex[2]))
                    .transpose() /
                3.0;
            for (int k = 0; k < 3; ++k) items[i].centroid[k] = static_cast<float>(centroid[k]);
            items[i].id = static_cast<std::uint32_t>(i);
        }
    });
    order_for_tree(items, block_size_, context);
    TreeItem* const all = items.data();
    corners_.resize(count);
    id_of_.resize(count);
    slot_of_.resize(count);
    parallel_for(context, count, kTaskItems, [&](std::size_t begin, std::size_t end) {
        // Ascending ids within a block, so that ties meet the lowest index first.
        for (std::size_t b = begin; b < end; b += block_size_)
            std::sort(all + b, all + std::min<std::size_t>(end, b + block_size_),
                      [](const TreeItem& x, const TreeItem& y) { return x.id < y.id; });
        for (std::size_t slot = begin; slot < end; ++slot) {
            const std::uint32_t id = items[slot].id;
            id_of_[slot] = id;
            slot_of_[id] = static_cast<std::uint32_t>(slot);
            corners_[slot] = corners_of(id);
        }
    });
}

void TriangleTree::build_blocks(const Context& context) {
    if (point_cloud_) return;
    using tree_search::Block;
    using tree_search::kWidth;
    const std::size_t count = corners_.size();
    blocks_.resize((count + kWidth - 1) / kWidth);
    parallel_for(
        context, blocks_.size(), kTaskItems / kWidth, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b)
                for (std::size_t lane = 0; lane < kWidth; ++lane) {
                    Block& block = blocks_[b];
                    const auto set = [&](int plane, const Vector3& normal, double offset) {
                        for (int k = 0; k < 3; ++k)
                            block.normal[plane][k][lane] = static_cast<float>(normal[k]);
                        block.offset[plane][lane] = static_cast<float>(offset);
                    };
                    const std::size_t slot = b * kWidth + lane;
                    block.size[lane] = 0;
                    for (int plane = 0; plane < 4; ++plane)  // nothing lies near a missing triangle
                        set(plane, Vector3::Zero(),
                            slot < count ? 0 : -std::numeric_limits<double>::infinity());
                    if (slot >= count) continue;
                    const Vector3 x[3] = {corner(slot, 0), corner(slot, 1), corner(slot, 2)};
                    for (const Vector3& place : x)
                        block.size[lane] = std::max(block.size[lane], size_of(place));
                    const Vector3 edge[3] = {x[1] - x[0], x[2] - x[1], x[0] - x[2]};
                    const Vector3 cross = edge[2].cross(edge[0]);
                    const Eigen::Array4d squares(cross.squaredNorm(), edge[0].squaredNorm(),
                                                 edge[1].squaredNorm(), edge[2].squaredNorm());
                    const double longest = squares.tail<3>().maxCoeff();
                    if (!(squares[0] > kFlat * kFlat * longest * longest))
                        continue;  // its directions would be noise
                    const Eigen::Array4d inverse = 1 / squares.sqrt();
                    const Vector3 normal = inverse[0] * cross;
                    set(0, normal, normal.dot(x[0]));
                    for (int k = 0; k < 3; ++k) {
                        const Vector3 out = inverse[k + 1] * edge[k].cross(normal);
                        set(k + 1, out, out.dot(x[k]));
                    }
                }
        });
}

void TriangleTree::build_boxes(const Context& context) {
    using tree_search::kWidth;
    const std::size_t count = corners_.size();
    std::size_t children = (count + block_size_ - 1) / block_size_, total = 0;
    do {
        level_begin_.push_back(static_cast<std::uint32_t>(total));
        children = (children + kWidth - 1) / kWidth;
        total += children;
    } while (children > 1);
    level_begin_.push_back(static_cast<std::uint32_t>(total));
    nodes_.resize(total);

    const float infinity = std::numeric_limits<float>::infinity();
    for (std::size_t level = 0; level + 1 < level_begin_.size(); ++level) {
        const std::size_t first = level_begin_[level], last = level_begin_[level + 1];
        parallel_for(context, last - first, kBoxChunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                tree_search::Node& node = nodes_[first + n];
                for (std::size_t child = 0; child < kWidth; ++child) {
                    float low[3] = {infinity, infinity, infinity};
                    float high[3] = {-infinity, -infinity, -infinity};
                    const std::size_t index = n * kWidth + child;
                    if (level == 0) {
                        float size = 0;
                        for (std::size_t s = index * block_size_;
                             s < std::min<std::size_t>(count, (index + 1) * block_size_); ++s)
                            for (int c = 0; c < 3; ++c) {
                                size = std::max(size, size_of(corner(s, c)));
                                for (int k = 0; k < 3; ++k) {
                                    const float x =
                                        static_cast<float>(places_(corners_[s].vertex[c], k));
                                    low[k] = std::min(low[k], x);
                                    high[k] = std::max(high[k], x);
                                }
                            }
                        // Wide enough for the rounding of corners, near query points and rays.
                        const float margin = kBoxMargin * size;
                        for (int k = 0; k < 3; ++k) {
                            low[k] -= margin;
                            high[k] += margin;
                        }
                    } else if (level_begin_[level - 1] + index < first) {
                        const tree_search::Node& below = nodes_[level_begin_[level - 1] + index];
                        for (int k = 0; k < 3; ++k)
                            for (int c = 0; c < kWidth; ++c) {
                                if (below.lower[k][c] == infinity) continue;
                                low[k] = std::min(low[k], below.lower[k][c]);
                                high[k] = std::max(high[k], below.upper[k][c]);
                            }
                    }
                    for (int k = 0; k < 3;
                         ++k) {  // a missing child is infinitely far away, for rays too
                        node.lower[k][child] = low[k];
                        node.upper[k][child] = low[k] == infinity ? infinity : high[k];
                    }
                }
            }
        });
    }
}

tree_search::Tree TriangleTree::view() const {
    return {nodes_.data(), point_cloud_ ? nullptr : blocks_.data(), level_begin_.data(),
            static_cast<std::uint32_t>(level_begin_.size() - 1), extent_};
}

void TriangleTree::test_slot(std::uint32_t slot, const Vector3& point, SurfaceHit& best) const {
    const Vector3 a = corner(slot, 0);
    const TrianglePlace place =
        point_cloud_ ? TrianglePlace{Vector3(1, 0, 0), a, (point - a).squaredNorm()}
                     : closest_on_triangle(point, a, corner(slot, 1), corner(slot, 2));
    if (place.squared_distance < best.squared_distance ||
        (place.squared_distance == best.squared_distance && id_of_[slot] < best.triangle)) {
        best.triangle = id_of_[slot];
        best.barycentric = place.barycentric;
        best.point = place.point;
        best.squared_distance = place.squared_distance;
    }
}

SurfaceHit TriangleTree::closest(const Vector3& point, double max_distance,
                                 std::uint32_t hint) const {
    struct Search {
        const TriangleTree& tree;
        Vector3 query;
        SurfaceHit best;
        std::uint32_t known_slot;  // judged already
    } search{*this, point - centre_, SurfaceHit(), SurfaceHit::kNone};
    SurfaceHit& best = search.best;
    if (nodes_.empty()) return best;
    best.squared_distance = max_distance * max_distance;
    if (hint < slot_of_.size()) {
        search.known_slot = slot_of_[hint];
        test_slot(search.known_slot, search.query, best);
    }
    loops().around(
        view(), search.query.data(), best.squared_distance,
        [](void* given, std::uint32_t slot) {
            Search& running = *static_cast<Search*>(given);
            if (slot != running.known_slot)
                running.tree.test_slot(slot, running.query, running.best);
            return running.best.squared_distance;
        },
        &search);
    if (best.valid())
        best.point += centre_;
    else
        best.squared_distance = std::numeric_limits<double>::infinity();
    return best;
}

// Numbers of the hits by their places in the tree, place << 32 | number; empty when there are none.
std::vector<std::uint64_t> TriangleTree::order_of(const std::vector<SurfaceHit>& hits) const {
    const auto hit = [](const SurfaceHit& one) { return one.valid(); };
    if (hits.size() > kLowHalf || std::none_of(hits.begin(), hits.end(), hit)) return {};
    std::vector<std::uint64_t> order(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const std::uint32_t id = hits[i].triangle;
        const std::uint64_t slot = id < slot_of_.size() ? slot_of_[id] : slot_of_.size();
        order[i] = slot << 32 | i;
    }
    std::sort(order.begin(), order.end());
    return order;
}

void TriangleTree::closest(const PointsRef& points, double max_distance,
                           std::vector<SurfaceHit>& hits, const Context& context) const {
    closest(points, max_distance, {}, hits, context);
}

void TriangleTree::closest(const PointsRef& points, double max_distance,
                           const std::vector<std::uint8_t>& left_out, std::vector<SurfaceHit>& hits,
                           const Context& context) const {
    const std::size_t count = static_cast<std::size_t>(points.rows());
    if (hits.size() != count) hits.assign(count, SurfaceHit());
    if (!left_out.empty() && left_out.size() != count)
        fail(Status::mismatch, "%zu marks for %zu places to look from", left_out.size(), count);
    // Each answer is its own, so that their order is free: neighbours in the tree one after the
    // other find its blocks in the cache.
    const std::vector<std::uint64_t> order = order_of(hits);
    parallel_for(context, count, 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t i = order.empty() ? k : order[k] & kLowHalf;
            if (!left_out.empty() && left_out[i]) {
                hits[i] = SurfaceHit();
                continue;
            }
            hits[i] = closest(points.row(static_cast<Index>(i)).transpose(), max_distance,
                              hits[i].triangle);
        }
    });
}

// visit(triangle, t, barycentric) of each crossing at 0 <= t <= max_t, returning the t up to which
// more are asked for.
template <typename Visit>
void TriangleTree::walk_ray(const Vector3& origin, const Vector3& direction, double max_t,
                            const Visit& visit) const {
    if (nodes_.empty() || point_cloud_) return;
    struct Search {
        const TriangleTree& tree;
        const Vector3 origin, &direction;
        double max_t;
        const Visit& visit;
    } search{*this, origin - centre_, direction, max_t, visit};
    loops().along(
        view(), search.origin.data(), direction.data(), max_t,
        [](void* given, std::uint32_t slot) {
            Search& s = *static_cast<Search*>(given);
            // origin + t direction = a + v ab + w ac by Cramer's rule (Moeller, Trumbore).
            const Vector3 a = s.tree.corner(slot, 0), ab = s.tree.corner(slot, 1) - a,
                          ac = s.tree.corner(slot, 2) - a;
            const Vector3 from_a = s.origin - a, p = s.direction.cross(ac), q = from_a.cross(ab);
            const double determinant = ab.dot(p);
            if (determinant == 0) return s.max_t;
            const double v = from_a.dot(p) / determinant, w = s.direction.dot(q) / determinant;
            const double t = ac.dot(q) / determinant;
            if (t >= 0 && t <= s.max_t && v >= 0 && w >= 0 && v + w <= 1)
                s.max_t = s.visit(s.tree.id_of_[slot], t, Vector3(1 - v - w, v, w));
            return s.max_t;
        },
        &search);
}

RayHit TriangleTree::first_hit(const Vector3& origin, const Vector3& direction,
                               double max_t) const {
    RayHit best;
    walk_ray(origin, direction, max_t, [&](std::uint32_t id, double t, const Vector3& barycentric) {
        if (t < best.t || (t == best.t && id < best.triangle)) best = {id, t, barycentric};
        return best.t;
    });
    return best;
}

Index TriangleTree::count_crossings(const Vector3& origin, const Vector3& direction,
                                    double max_t) const {
    Index count = 0;
    walk_ray(origin, direction, max_t, [&](std::uint32_t, double, const Vector3&) {
        ++count;
        return max_t;
    });
    return count;
}

}  // namespace mien
