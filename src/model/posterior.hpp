// The posterior model (2.13)-(2.14): what remains possible once some landmarks are known.
//
// In the low-rank model everything happens in coefficient space. With F the landmarks' rows of the
// basis over their noise, the kernel coefficients' covariance becomes S = (I + F'F)^-1, the same
// for x, y and z, and S^1/2 = I - V (1 - (1 + D)^-1/2) V' from the few eigenpairs of F F'. So the
// posterior of a scalar basis is a scalar basis, and the result is again a DeformationModel. With
// vector modes c, u = mean + P c + Phi a is split as c by its own posterior and a given c:
//   u = mean' + (P - Phi B) S_c^1/2 c' + Phi S^1/2 a',  a', c' ~ N(0, I),
// which is exact and still of the same form.
//
// Departure: (2.13) has one noise for all landmarks and no prior mean; here each landmark has its
// own and the mean displacement counts.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/context.hpp"
#include "model/deformation_model.hpp"

namespace mien {

struct LandmarkObservation {
    std::uint32_t vertex = 0;
    Vector3 displacement_mm = Vector3::Zero();  ///< from the template's vertex to where it was seen
    double noise_mm = 1;                        ///< standard deviation of each coordinate, >= 1e-6
};

/// Throws Status::invalid_argument (no observation, vertex out of range, noise, not finite) or
/// unsupported_option for a model with a preference for mirror symmetry, whose posterior differs
/// from axis to axis. O(#V r (h + r)) time for h observations; the model is copied.
std::shared_ptr<const DeformationModel> condition_model(
    const DeformationModel& model, const std::vector<LandmarkObservation>& observations,
    const Context& context);

}  // namespace mien
