// How sure is a fit of each place? The posterior covariance of the coefficients, carried to the
// vertices, plus what the coefficients cannot know: the modes left out, and places where nothing
// was scanned.
#pragma once

#include "registration/nicp.hpp"

namespace mien {

/// #V standard deviations per axis (root mean square of the three), mm. Dense algebra over the
/// strongest modes only: a few hundred unknowns. `weight` is the final robust weight of each
/// vertex.
Vector place_deviation(const DeformationModel& model, const FitState& state, const Vector& weight,
                       const PointsRef& normals_model, const std::vector<Pin>& pins,
                       const RegistrationOptions& options, const Context& context);

}  // namespace mien
