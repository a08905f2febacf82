// Eyes that are shut in a scan without landmarks. An open template finds the skin of a shut lid
// under it wherever it lies, so its form never tells; what shows between the lids does: an eyeball
// is not the colour of the skin around it.
#pragma once

#include <vector>

#include "registration/nicp.hpp"

namespace mien {

/// Pins (scan frame) that bring the upper lids of shut eyes down to the lower ones; none where an
/// eye is open, where the scan has no colours or shows nothing there, or where the model does not
/// name eye_right_0 .. 5 and eye_left_0 .. 5 (68-point scheme). Needs state.places and
/// state.colors.
std::vector<Pin> shut_lids(const DeformationModel& model, const ScanSurface& scan,
                           const FitState& state, double sigma_mm, const Context& context);

}  // namespace mien
