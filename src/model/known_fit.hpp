// The fit of a model to a face whose correspondence is known (2.31)-(2.34):
//
//   minimise  sum_v w_v^2 |y_v - u_v(alpha)|^2 + rho |alpha|^2,   y = target - template - mean
//   (A' W^2 A + rho I) alpha = A' W^2 y
//
// with alpha in units of the prior's deviation, so that rho is the variance of the target's noise.
//
// Departures: A is never formed. One scalar column serves x, y and z, so the kernel modes have one
// r x r block for the three axes, and the vector modes follow from its Schur complement. Modes of a
// model with a preference for mirror symmetry have a variance of their own per axis, by which rho
// is divided. rho = 0 keeps a damping of 1e-12 of the largest diagonal entry, so that it is a least
// squares fit whatever the basis.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"
#include "model/deformation_model.hpp"
#include "model/sampling.hpp"

namespace mien {

struct KnownFitOptions {
    double ridge_mm2 = 1.0;       ///< rho, mm^2, >= 0
    Vector weights;               ///< w per vertex of the target, >= 0; empty: all one
    Index num_scalar_modes = -1;  ///< the first of them; -1: all
    Index num_vector_modes = -1;  ///< the first of them; -1: all
    bool align = false;           ///< move the target rigidly onto the template's mean first
};

struct KnownFit {
    ModelCoefficients coefficients;
    Similarity target_motion;    ///< applied to the target before the fit; identity unless aligned
    double residual_rms_mm = 0;  ///< root mean square distance, weighted with w^2
};

/// `target` may cover only the first vertices of the template. Throws Status::mismatch for more
/// vertices than the template's or another number of weights, invalid_mesh for a place that is not
/// finite, invalid_argument for a ridge, weight or number of modes out of range or weights that are
/// all zero, no_solution. O(n (r + p)^2 + r^3 + p^3) for n vertices, r scalar and p vector modes;
/// about 8 n (r + 3 p) bytes.
KnownFit fit_known(const DeformationModel& model, const PointsRef& target,
                   const KnownFitOptions& options, const Context& context);

}  // namespace mien
