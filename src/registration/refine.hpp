// After the modes: a smooth field along the normals closes what they cannot span, and folds are undone.
//
//   minimise  sum_i w_i (r_i - delta_i)^2 + alpha |L delta|^2,   x_i += delta_i n_i
//
// r_i the signed gap along the normal, w_i its robust weight, L the graph Laplacian (umbrella) of the
// template. alpha spreads the scanner's noise over neighbours instead of following it.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "registration/correspondence.hpp"

namespace mien {

/// Neighbour lists of a template's vertices.
struct VertexRings {
    std::vector<std::uint32_t> begin;      ///< #V + 1
    std::vector<std::uint32_t> neighbours;
};
VertexRings build_rings(Index num_vertices, const Triangles& triangles);

struct GapOptions {
    double smoothness = 2;       ///< alpha
    double robust_scale_mm = 1;  ///< of the weight
    double max_step_mm = 3;      ///< cap of the field
    int rounds = 2;              ///< closest points are found anew in each
};

/// Moves `places` (#V x 3, scan frame). `trust` in [0, 1] per vertex multiplies the weights.
void close_gap(const ScanSurface& scan, const Triangles& triangles, const VertexRings& rings, const Vector& trust,
               const CorrespondenceOptions& match, const GapOptions& options, Points& places,
               const Context& context);

/// Triangles that fold against a neighbour (cosine of their normals below `folded`) where `rest` does not
/// (cosine above `flat`).
std::vector<std::uint32_t> find_folds(const PointsRef& places, const PointsRef& rest, const Triangles& triangles,
                                      double folded = -0.3, double flat = 0.2);

/// Relaxes the surroundings of folds (umbrella steps with the template's edge shape) until none is left
/// or `rounds` have passed. Returns the number of folds left.
Index repair_folds(const PointsRef& rest, const Triangles& triangles, const VertexRings& rings, int rounds,
                   Points& places, Index& repaired);

/// Pairs of triangles that cross without sharing a vertex, counted by edges through triangles.
Index count_self_intersections(const PointsRef& places, const Triangles& triangles, const Context& context);

}  // namespace mien
