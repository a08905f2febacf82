// A packed eight-wide tree of boxes over the triangles of a surface, or over the points of a cloud:
// closest point, first hit of a ray, number of crossings.
//
// The triangles are cut at box medians (widest axis of their centroids) into blocks of eight, and
// the blocks into eights again: a complete tree whose layout follows from the count alone. Boxes
// and the triangles' planes are floats (spatial/tree_search.hpp) and only choose candidates; the
// answer comes from the corners, which stay double. Build O(F log F), about 100 bytes a triangle.
#pragma once

#include <limits>
#include <vector>

#include "base/context.hpp"
#include "base/raw_vector.hpp"
#include "base/types.hpp"
#include "spatial/tree_search.hpp"

namespace mien {

/// A place on a surface: point = sum_k barycentric[k] * vertex(triangle, k). For a cloud of points
/// `triangle` is the vertex and barycentric is (1, 0, 0).
struct SurfaceHit {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t triangle = kNone;
    Vector3 barycentric = Vector3(1, 0, 0);
    Vector3 point = Vector3::Zero();
    double squared_distance = std::numeric_limits<double>::infinity();

    bool valid() const { return triangle != kNone; }
    double distance() const { return std::sqrt(squared_distance); }
};

struct RayHit {
    std::uint32_t triangle = SurfaceHit::kNone;
    double t = std::numeric_limits<double>::infinity();  ///< in lengths of the direction
    Vector3 barycentric = Vector3(1, 0, 0);
    bool valid() const { return triangle != SurfaceHit::kNone; }
};

/// Immutable after construction, safe to share between threads. Keeps no reference to the mesh.
class TriangleTree {
  public:
    TriangleTree() = default;
    /// `triangles` may be empty: then every row of `vertices` is a primitive of its own. Indices
    /// and coordinates must have passed check_mesh(). Triangles without area are kept as segments
    /// or points.
    TriangleTree(const PointsRef& vertices, const TrianglesRef& triangles, const Context& context);

    Index num_primitives() const { return static_cast<Index>(slot_of_.size()); }
    bool is_point_cloud() const { return point_cloud_; }
    Vector3 lower_corner() const { return centre_ + lower_; }
    Vector3 upper_corner() const { return centre_ + upper_; }

    /// Nearest place within max_distance (invalid hit when there is none). Of equally near ones the
    /// lowest triangle index wins. `hint`, a triangle likely to be near, only shortens the search.
    SurfaceHit closest(const Vector3& point,
                       double max_distance = std::numeric_limits<double>::infinity(),
                       std::uint32_t hint = SurfaceHit::kNone) const;

    /// The same for every row of `points`. `hits` of the same length on entry serve as hints (a
    /// previous round's answers); otherwise it is resized.
    void closest(const PointsRef& points, double max_distance, std::vector<SurfaceHit>& hits,
                 const Context& context) const;

    /// The same but for rows that `left_out` marks (as many as points, or none), whose hits become
    /// invalid.
    void closest(const PointsRef& points, double max_distance,
                 const std::vector<std::uint8_t>& left_out, std::vector<SurfaceHit>& hits,
                 const Context& context) const;

    /// First hit with 0 <= t <= max_t; both sides count. Never hits a cloud of points.
    RayHit first_hit(const Vector3& origin, const Vector3& direction,
                     double max_t = std::numeric_limits<double>::infinity()) const;
    /// Number of triangles crossed at 0 <= t <= max_t.
    Index count_crossings(const Vector3& origin, const Vector3& direction,
                          double max_t = std::numeric_limits<double>::infinity()) const;

  private:
    struct Corners {
        std::uint32_t vertex[3];
    };

    void sort_primitives(const PointsRef& vertices, const TrianglesRef& triangles,
                         const Context& context);
    void build_blocks(const Context& context);
    std::vector<std::uint64_t> order_of(const std::vector<SurfaceHit>& hits) const;
    void build_boxes(const Context& context);
    tree_search::Tree view() const;
    Vector3 corner(std::size_t slot, int k) const {
        return places_.row(corners_[slot].vertex[k]).transpose();
    }
    void test_slot(std::uint32_t slot, const Vector3& point, SurfaceHit& best) const;
    template <typename Visit>
    void walk_ray(const Vector3& origin, const Vector3& direction, double max_t,
                  const Visit& visit) const;

    bool point_cloud_ = false;
    std::uint32_t block_size_ = 8;  // primitives in a leaf: 1 for a cloud
    float extent_ = 0;
    Vector3 centre_ = Vector3::Zero(), lower_ = Vector3::Zero(), upper_ = Vector3::Zero();
    Points places_;                           // vertices relative to centre_
    RawVector<Corners> corners_;              // in tree order
    RawVector<std::uint32_t> id_of_;          // slot -> triangle
    RawVector<std::uint32_t> slot_of_;        // triangle -> slot
    RawVector<tree_search::Block> blocks_;    // of eight triangles
    RawVector<tree_search::Node> nodes_;      // level 0 (children are blocks) first
    std::vector<std::uint32_t> level_begin_;  // first node of each level
};

}  // namespace mien
