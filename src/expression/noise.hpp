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
#include "expression/smooth_identity.hpp"

namespace mien {

struct NoiseLevels {
    double map_mm2 = 30.0, mixture_mm2 = 100.0;
    double map_error_mm = 0.0, mixture_error_mm = 0.0;  ///< cross-validated root mean square error
    /// Distance per vertex from their fits that 95 % of the tested faces stay under; 0: not known.
    double residual_mm = 0.0;
};

/// A smooth prior that was tried on people left out.
struct TriedSmoothness {
    double variance_mm2 = 0;  ///< v
    double held_out_mm = 0;   ///< root mean square error of the mixture, mean over the faces
};

/// The smooth prior of the identity, in coordinates of the span.
struct SmoothPrior {
    Matrix gram;              ///< r x r, smooth_gram(); empty: none
    double variance_mm2 = 0;  ///< v
    Index most_modes = 0;
};

/// Cross-validation of both noise levels; deterministic. `expression_basis` (r x q, with the spill)
/// and `expression_coordinates` (q x s) make the displacements; `identity_modes` is the number of
/// modes. Fewer than 4 subjects: the defaults.
NoiseLevels estimate_noise(const Context& context, const ColumnSource& source,
                           const JointSpan& span, const Matrix& expression_basis,
                           const Matrix& expression_coordinates, Index identity_modes,
                           const PriorOptions& options, const SmoothPrior& smooth);

/// Whether the means of expressions follow the person (prior.hpp).
struct FollowChoice {
    Index directions = 0;  ///< of the identity; 0: they stay
    NoiseLevels noise;     ///< without a smooth prior
};

/// The directions of `options` where they lessen the error of people left out by
/// least_follow_gain, else none. Costs two estimate_noise(), whose arguments these are.
FollowChoice choose_following(const Context& context, const ColumnSource& source,
                              const JointSpan& span, const Matrix& expression_basis,
                              const Matrix& expression_coordinates, Index identity_modes,
                              const PriorOptions& options);

struct SmoothChoice {
    SmoothPrior prior;
    NoiseLevels noise;                   ///< with it
    std::vector<TriedSmoothness> tried;  ///< empty where nobody can be left out
};

/// The smallest of the variances whose error of people left out is within `least_gain` of the
/// least; none where fewer than 4 people leave nobody to be left out. `without`: the noise with no
/// smooth prior; other arguments as estimate_noise().
SmoothChoice choose_smooth_prior(const Context& context, const ColumnSource& source,
                                 const JointSpan& span, const Matrix& expression_basis,
                                 const Matrix& expression_coordinates, Index identity_modes,
                                 const PriorOptions& options, const SmoothIdentityOptions& smooth,
                                 const Matrix& gram, const NoiseLevels& without);

}  // namespace mien
