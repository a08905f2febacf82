// What the training people do not show of new people, as a prior of the identity.
//
// Ten people span nine directions. A new person differs from them by millimetres in directions that
// no identity mode holds, and a fit that knows white noise alone explains these by expressions: a
// neutral face of a model of ten people moved by half a millimetre. But people differ smoothly, and
// expressions do not (lips part, lids close). So the identity's covariance is that of the training
// people and a smooth one together,
//     C = P diag(d^2) P' + v K,   K(x, y) = mean over scales s of exp(-|x - y|^2 / 2 s^2),
// in each axis alike, x and y vertices of the mean face; v is found by hold-out over the people
// (noise.hpp), 0 included. K is approximated by Nystroem's method. The directions in which it is
// strongest across P become further modes, and the coordinates along all of them get C's own
// (full) covariance. The thesis' own fits (exact, alternating) and fits of several faces of one
// person do not know these modes (ExpressionModel::people).
#pragma once

#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"
#include "expression/joint_span.hpp"

namespace mien {

/// Scales chosen on 10 and 30 people of seed 1 among 60, 30, 20 and their pairs, by people left
/// out; the number of modes likewise (40 lose what the kernel brings, 200 bring nothing more).
struct SmoothIdentityOptions {
    std::vector<double> scales_mm = {60.0, 20.0};  ///< s, > 0
    /// v, mm^2 per coordinate, not negative: what the hold-out tries.
    std::vector<double> variances_mm2 = {0.0, 0.5, 2.0, 8.0};
    Index modes = 100;         ///< at most so many beside those of the people; 0: none
    Index centres = 400;       ///< Nystroem: vertices that carry the kernel, evenly over the order
    double least_gain = 0.01;  ///< of the error of people left out that a prior must bring, 0 to 1
};

/// K in coordinates of the span, U'KU, r x r. O(#V (centres^2 + centres r)). Throws
/// Status::invalid_argument for options out of range.
Matrix smooth_gram(const Context& context, const JointSpan& span,
                   const SmoothIdentityOptions& options);

/// Modes beside those of the people.
struct SmoothIdentity {
    Matrix modes;       ///< r x e, orthonormal, across `identity`
    Matrix covariance;  ///< (p+e)^2, of the coordinates along (moved, modes), mm^2
};

/// `identity` (r x p, orthonormal) are the people's modes, `moved` (r x p) what their coordinates
/// move (with a spill more than the modes), `deviations` (p) of their coordinates. e is 0 where
/// variance_mm2 or most_modes is.
SmoothIdentity smooth_identity(const Matrix& identity, const Matrix& moved,
                               const Vector& deviations, const Matrix& gram, double variance_mm2,
                               Index most_modes);

}  // namespace mien
