// The first motion from landmarks, whatever a minority of them says: the best of many three-point
// motions by the median distance (least median of squares; Rousseeuw, 1984), then a reweighted
// least-squares fit with Cauchy weights 1 / (1 + (d / s)^2).
#pragma once

#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct PinAlignmentSettings {
    Index fewest_for_trials = 5;  ///< >= 4: fewer pins are aligned as they are [J]
    int trials = 300;             ///< >= 0: three-point motions [J]
    std::uint32_t seed = 12345;   ///< of their choice: the same pins give the same motion
    double least_area_mm2 = 400;  ///< >= 0: twice the area that three pins must span [J]
    double clearly = 0.6;         ///< 0 to 1: of the best median, to take its place [J]
    int rounds = 10;              ///< >= 0: of reweighting [J]
    double least_scale_mm = 3;    ///< mm, > 0: floor of the weights' scale [J]
    double scale_medians = 2;     ///< > 0: that scale in median distances [J]
};

/// Template (with its mean displacement) -> places. At least three pins. Throws Status::no_solution
/// when the pins lie on a line. O(trials #pins).
Similarity align_pins(const DeformationModel& model, const std::vector<Pin>& pins, bool with_scale,
                      const PinAlignmentSettings& settings);

}  // namespace mien
