// The noise level of an expression model's fits.
//
// It cannot be read off the residual: what the identity modes do not explain of a new person is
// smooth over the face, so it carries far fewer degrees of freedom than coordinates. It is chosen
// by cross-validation over subjects: the identity modes and the prior are learned without a fold of
// the subjects, the fold's faces are neutralized, and the noise with the least error wins.
#pragma once

#include "base/context.hpp"
#include "expression/column_source.hpp"
#include "expression/joint_span.hpp"
#include "expression/prior.hpp"

namespace mien {

struct NoiseLevels {
    double map_mm2 = 30.0, mixture_mm2 = 100.0;
    double map_error_mm = 0.0, mixture_error_mm = 0.0;  ///< cross-validated root mean square error
    /// Distance per vertex from their fits that 95 % of the tested faces stay under; 0: not known.
    double residual_mm = 0.0;
};

/// Cross-validation of both noise levels; deterministic. `expression_basis` (r x q, with the spill)
/// and `expression_coordinates` (q x s) make the displacements; `identity_modes` is the number of
/// modes. Fewer than 4 subjects: the defaults.
NoiseLevels estimate_noise(const Context& context, const ColumnSource& source,
                           const JointSpan& span, const Matrix& expression_basis,
                           const Matrix& expression_coordinates, Index identity_modes,
                           const PriorOptions& options);

}  // namespace mien
