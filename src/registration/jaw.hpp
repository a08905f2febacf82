// A jaw that opens, for fits without landmarks: a closest point never finds a lip that has gone
// down by more than its own height, so a free start searches for the opening of the jaw
// (jaw_search.hpp).
#pragma once

#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// How the jaw turns as a whole. Tags in brackets: registration/settings.hpp.
struct JawSettings {
    double axis_back = 0;  ///< of the width between jaw_00 and jaw_16: how far the axis of the turn
                           ///< lies behind them, at the height of the jaw's angle jaw_03. [T] table
                           ///< "Open jaws"
    /// Shares of the turn, 0 to 1, of the jaw's outline counted from the ear (jaw_04, 05, 06 and
    /// their mirrors), of the corners of the mouth. [J]
    double share_4 = 0.3, share_5 = 0.5, share_6 = 0.8, share_corner = 0.4;
    double sigma_mm = 1.5;  ///< mm, > 0: of the pins [J]
};

/// Pins (scan frame) at the landmarks of the face in `state` with its jaw turned down; none when
/// the model does not name jaw_00, jaw_03, jaw_16 and mouth_outer_09 (68-point scheme).
std::vector<Pin> open_jaw(const DeformationModel& model, const FitState& state, double opening_rad,
                          const JawSettings& settings);

}  // namespace mien
