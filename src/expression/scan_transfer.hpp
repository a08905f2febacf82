// The raw scan itself, neutralized (B5): the displacement that took a fitted template to its
// neutral face is carried onto the scan's own vertices; triangles, colours and texture stay.
//
// A scan vertex near the fitted surface takes the displacement u0 of its closest point with a
// confidence w that falls from 1 to 0 at max_distance. What is farther (hair, a collar, the
// shoulders) moves rigidly: every connected far piece by the rigid motion that fits the displaced
// confident vertices around it best. Then one solve over the scan's surface,
//     (M W + l^2 K) u = M W u0,
// takes the steps out (K stiffness, M mass, l the smoothing length); far pieces enter with a small
// weight, so that they bend into their surroundings without a seam.
#pragma once

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct ScanTransferOptions {
    double max_distance_mm = 6.0;  ///< > 0; farther vertices move with their neighbourhood
    double smoothing_mm = 1.5;     ///< l, >= 0
};

struct ScanTransferResult {
    TriMesh scan;  ///< the scan with moved vertices
    Index num_far_vertices = 0;
    double max_displacement_mm = 0;
};

/// `fitted` and `neutral_vertices` in correspondence, in the scan's frame. The scan may be in
/// pieces, not manifold, or a point cloud (then nothing is smoothed). Throws
/// Status::invalid_argument, mismatch, no_solution. O(#scan log #template) and one sparse solve.
ScanTransferResult transfer_to_scan(const Context& context, const TriMesh& fitted,
                                    const PointsRef& neutral_vertices, const TriMesh& scan,
                                    const ScanTransferOptions& options);

}  // namespace mien
