// The first shape of a fit that no landmark holds: the strongest modes under much assumed noise,
// and, because a closest point never finds a lip that has gone down by more than its own height, a
// jaw that is tried at several openings.
#pragma once

#include "model/deformation_model.hpp"
#include "registration/nicp.hpp"
#include "registration/registration.hpp"
#include "registration/scan_surface.hpp"

namespace mien {

/// Needs state.motion, a pose, and coefficients at full size; fills coefficients, motion and
/// places, and raises the kernel's amplitude (unless the options give one) where an open jaw has
/// won. Openings are tried for models without trained modes, which know open mouths, and with the
/// landmarks jaw_00 .. jaw_16 and mouth_outer_09 of the 68-point scheme.
void start_freely(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                  const RegistrationOptions& options, FitState& state, const Context& context);

/// Pins (scan frame) at the landmarks of the face in `state` with its jaw turned down about the
/// line behind its angles; none when the model does not name them.
std::vector<Pin> open_jaw(const DeformationModel& model, const FitState& state, double opening_rad);

}  // namespace mien
