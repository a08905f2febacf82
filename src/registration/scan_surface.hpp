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
    Points normals;       ///< #V x 3 unit, averaged over about `smoothing_mm`; zero where unknown
    std::vector<std::uint8_t> on_border;  ///< #V
    double spacing_mm = 0;                ///< mean edge length

    /// Interpolated normal, unit or zero.
    Vector3 normal_at(const SurfaceHit& hit) const;
    /// True when the hit lies on a border edge or border vertex: the scan goes no further there.
    bool at_border(const SurfaceHit& hit) const;
};

/// `mesh` must have passed check_mesh(). Cost O(V + F log F).
ScanSurface prepare_scan(const TriMesh& mesh, double smoothing_mm, const Context& context);

}  // namespace mien
