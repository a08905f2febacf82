// Folded triangles: found by how their neighbourhood lies, and straightened by the form that the
// template has there.
//
//   x_i = mean over the neighbours j of x_j + R (rest_i - rest_j)
//
// R the rotation that brings the neighbourhood at rest nearest to where it is (Kabsch; the local
// step of Sorkine and Alexa, As-rigid-as-possible surface modeling, 2007).
#pragma once

#include <vector>

#include "base/types.hpp"
#include "mesh/adjacency.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct FoldSettings {
    bool straighten = true;      ///< [A]
    double max_turn_rad = 1.05;  ///< rad, 0 to pi: against the neighbourhood, before a triangle
                                 ///< counts as folded [J]
    int reach = 3;               ///< >= 1: rings of the neighbourhood [J]
    double plain_cosine = 0.64;  ///< triangles turned by less against the rest pose are right
                                 ///< whatever their neighbourhood does: saves its rotation [J]
    int rounds = 12;             ///< >= 0 [J]
    int widen_after = 4;         ///< >= 0: rounds, then the corners' neighbours move too [J]
    int steps = 6;               ///< >= 1: per round [J]
    double keep = 0.3;           ///< 0 to 1: of the old place in a step towards the mean [J]
};

/// A triangle that lies otherwise than its neighbourhood carries it.
struct TurnedTriangle {
    std::uint32_t triangle;
    Matrix3 rotation;  ///< of the neighbourhood, rest -> places
};

/// Triangles whose normal is more than max_turn_rad off the normal at rest turned with the
/// neighbourhood. The neighbourhood is the judge, so that a lid that closes or a jaw that opens is
/// no fold. Needles of the rest pose have no side to lie on and are left out.
std::vector<TurnedTriangle> find_turned(const PointsRef& rest, const Triangles& triangles,
                                        const VertexRings& rings, const PointsRef& places,
                                        const FoldSettings& settings);

/// Counts of folded triangles.
struct FoldCounts {
    Index before = 0, after = 0;
};

/// Straightens folds in `places` and keeps the best round's; settings.straighten false: counts
/// only.
FoldCounts straighten_turned(const PointsRef& rest, const Triangles& triangles,
                             const VertexRings& rings, const FoldSettings& settings,
                             Points& places);

}  // namespace mien
