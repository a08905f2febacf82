// The prior of expression coordinates and the noise level, learned from coordinates.
//
// Every expression e gets the mean and covariance of its training displacements. Few samples do not
// determine a covariance: it is drawn towards the pooled within-expression covariance by a count of
// pseudo-samples, and a floor of a small share of the total variance keeps it definite and
// tolerant. "neutral" is a narrow Gaussian at zero, "any" the broad Gaussian of all displacements.
//
// The noise level cannot be read off the residual: what the identity modes do not explain of a new
// person is smooth over the face, so it carries far fewer degrees of freedom than coordinates. It
// is chosen by cross-validation over subjects: the identity modes and the prior are learned without
// a fold of the subjects, the fold's faces are neutralized, and the noise with the least error
// wins.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/column_source.hpp"
#include "expression/expression_model.hpp"
#include "expression/joint_span.hpp"

namespace mien {

struct PriorOptions {
    double floor_share = 1e-3;    ///< of the modes' variance, added to every covariance
    double pooled_samples = 2.0;  ///< pseudo-samples of the pooled covariance
    double neutral_share = 5e-4;  ///< variance of the neutral component, same unit
    Index min_samples = 3;        ///< expressions with fewer faces get no component of their own
};

/// Components from displacements in mode coordinates (q x s) with their expressions.
std::vector<ExpressionComponent> expression_components(const Matrix& coordinates,
                                                       const std::vector<int>& expression,
                                                       const std::vector<std::string>& names,
                                                       const Vector& deviations,
                                                       const PriorOptions& options);

struct NoiseLevels {
    double map_mm2 = 30.0, mixture_mm2 = 100.0;
    double map_error_mm = 0.0, mixture_error_mm = 0.0;  ///< cross-validated root mean square error
    /// Distance per vertex from their fits that 95 % of the tested faces stay under; 0: not known.
    double residual_mm = 0.0;
};

/// Cross-validation of both noise levels; deterministic. `expression_basis` (r x q, with the spill)
/// and `expression_coordinates` (q x s) make the displacements; `identity_modes` is the number of
/// modes.
NoiseLevels estimate_noise(const Context& context, const ColumnSource& source,
                           const JointSpan& span, const Matrix& expression_basis,
                           const Matrix& expression_coordinates, Index identity_modes,
                           const PriorOptions& options);

}  // namespace mien
