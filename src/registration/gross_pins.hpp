// Landmarks that are plainly wrong (at the origin, on the shoulder), found before anything is
// estimated from them: no landmark near them on the template moved as they did. An open mouth moves
// its landmarks far, but together.
#pragma once

#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// [J]; tags in brackets: registration/settings.hpp. Neighbours across the lips of a wide open
/// mouth differ by 40 mm, but each lip's own move alike.
struct GrossPinSettings {
    bool enabled = true;
    std::size_t fewest = 6;      ///< >= 4: fewer pins say nothing of each other
    std::size_t neighbours = 6;  ///< >= 1: nearest ones on the template
    double apart_mm = 14;        ///< mm, > 0: a displacement that no neighbour comes so near to
    double together = 0.25;      ///< 0 to 1: of their distance on the template; two that stand
                                 ///< so near to each other do not speak for each other
    double most = 0.34;          ///< 0 to 1: when a larger share would go, none does
    double far = 30;             ///< > 1: half extents of the scan from its middle; no picked place
                                 ///< lies beyond
};

/// Numbers of the pins, ascending, which lie so far from a scan within low .. high (mm) that
/// nothing can be aligned with them: a sum of places over which one at 1e30 has the say forgets the
/// others.
std::vector<std::size_t> far_pins(const std::vector<Pin>& pins, const Vector3& low,
                                  const Vector3& high, const GrossPinSettings& settings);

/// Numbers of the pins, ascending. `motion` aligned robustly. O(#pins^2).
std::vector<std::size_t> gross_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                                    const Similarity& motion, const GrossPinSettings& settings);

}  // namespace mien
