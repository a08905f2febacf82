// After the modes: a smooth field along the normals closes what they cannot span, and folds are
// undone.
//
//   minimise  sum_i w_i (r_i - delta_i)^2 + alpha |L delta|^2,   x_i += delta_i n_i
//
// r_i the signed gap along the normal, w_i its robust weight, L the graph Laplacian (umbrella) of
// the template. alpha spreads the scanner's noise over neighbours instead of following it. Rounds
// fit what the rounds before left (twicing): a hill that the modes do not know, a swelling or an
// injection, is beyond the robust scale at first and rises from its foot to its top, round by
// round.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/adjacency.hpp"
#include "registration/correspondence.hpp"

namespace mien {

struct GapOptions {
    double smoothness = 2;       ///< alpha
    double robust_scale_mm = 1;  ///< of the weight
    double max_step_mm = 3;      ///< cap of the field
    int rounds = 6;              ///< closest points are found anew in each
};

/// Moves `places` (#V x 3, scan frame). `scan_weight`, per scan vertex or empty, and `trust`, per
/// vertex, both in [0, 1], multiply the weights. Returns the weights of the last round, #V.
Vector close_gap(const ScanSurface& scan, const Vector& scan_weight, const Triangles& triangles,
                 const VertexRings& rings, const Vector& trust, const CorrespondenceOptions& match,
                 const GapOptions& options, Points& places, const Context& context);

/// Where the field turned a triangle by more than 60 degrees against `before`, its corners (and,
/// when that is not enough, their neighbours) go back there. Lids that close and lips that press
/// fold against the template by right, so the shape before the field is the judge and not the
/// template. About the limit they go back by a share: a corner on the verge would go in one frame
/// and stay in another, by rounding. Returns the number of turned triangles, of all rounds.
Index undo_turns(const Points& before, const Triangles& triangles, const VertexRings& rings,
                 Points& places);

/// A triangle that lies otherwise than its neighbourhood carries it.
struct TurnedTriangle {
    std::uint32_t triangle;
    Matrix3 rotation;  ///< of the neighbourhood (three rings), rest -> places
};
/// Triangles whose normal is more than `max_turn_rad` off the normal at rest turned with the
/// neighbourhood. The neighbourhood is the judge, so that a lid that closes or a jaw that opens is
/// no fold.
std::vector<TurnedTriangle> find_turned(const PointsRef& rest, const Triangles& triangles,
                                        const VertexRings& rings, const PointsRef& places,
                                        double max_turn_rad);

/// Gives the corners of turned triangles (after four rounds their neighbours too) the template's
/// own form among their neighbours: x_i = mean of x_j + R (rest_i - rest_j). Keeps the best of
/// `rounds` rounds; returns the number of turned triangles left.
Index straighten_turned(const PointsRef& rest, const Triangles& triangles, const VertexRings& rings,
                        double max_turn_rad, int rounds, Points& places, Index& turned_before);

/// Pairs of triangles that cross without sharing a vertex, counted by edges through triangles.
Index count_self_intersections(const PointsRef& places, const Triangles& triangles,
                               const Context& context);

}  // namespace mien
