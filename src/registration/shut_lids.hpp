// Eyes that are shut in a scan without landmarks. An open template finds the skin of a shut lid
// under it wherever it lies, so its form never tells; what shows between the lids does: an eyeball
// is not the colour of the skin around it.
#pragma once

#include <array>
#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ShutLidSettings {
    bool enabled = true;  ///< [A]
    /// Logarithms (color_signals.hpp), > 0. A shut lid is as the skin under it, and even; an
    /// eyeball is white, coloured and black: largest differences of the middle tones, and largest
    /// widths from the tenth to the ninetieth percentile, of redness and of darkness. [J]
    double alike_red = 0.12, alike_dark = 0.3, even_red = 0.15, even_dark = 0.7;
    double reach_mm = 8;  ///< mm, > 0: an eyeball lies behind the line between the lids [J]
    int columns = 5;  ///< >= 2: lines from the upper lid to the lower one that are looked at [J]
    /// Places on them, as shares of the way from the upper to the lower lid: on the eyeball, and
    /// below it on the skin. [J]
    std::array<double, 3> eyeball{0.25, 0.5, 0.75};
    std::array<double, 2> skin{1.5, 2};
};

/// Pins (scan frame) that bring the upper lids of shut eyes down to the lower ones; none where an
/// eye is open, where the scan has no colours or shows nothing there, or where the model does not
/// name eye_right_0 .. 5 and eye_left_0 .. 5 (68-point scheme). Needs state.places; `sigma_mm`: of
/// the pins.
std::vector<Pin> shut_lids(const DeformationModel& model, const ScanView& scan,
                           const FitState& state, double sigma_mm, const ShutLidSettings& settings,
                           const Context& context);

}  // namespace mien
