// What registration asks of a scan: its search tree, normals that outlast the scanner's noise, and
// the border where it simply ends.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {

/// Immutable; safe to share between threads.
struct ScanSurface {
    Points vertices;      ///< mm, scan frame
    Triangles triangles;  ///< empty for a cloud of points
    TriangleTree tree;
    Points normals;  ///< #V x 3 unit, averaged over about `smoothing_mm`; zero where unknown
    std::vector<std::uint8_t> on_border;  ///< #V
    /// #V x 6, the shape operator S (xx yy zz xy xz yz, 1/mm): the normal turns by S p when one
    /// moves by p along the surface; spread over about twice `smoothing_mm`. Empty for a cloud.
    Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor> bending;
    double spacing_mm = 0;  ///< mean edge length

    /// Interpolated normal, unit or zero.
    Vector3 normal_at(const SurfaceHit& hit) const;
    /// Interpolated shape operator; zero for a cloud.
    Matrix3 bending_at(const SurfaceHit& hit) const;
    /// Swaps inside and outside.
    void turn_over();
    /// True when the hit lies on a border edge or border vertex: the scan goes no further there.
    bool at_border(const SurfaceHit& hit) const;
    /// 0 on the border, 1 from the next row of vertices on, linear between: continuous along the
    /// surface.
    double off_border(const SurfaceHit& hit) const;
};

/// `mesh` must have passed check_mesh(). Cost O(V + F log F).
ScanSurface prepare_scan(const TriMesh& mesh, double smoothing_mm, const Context& context);

}  // namespace mien
