// A scan far from the origin, in a site's grid or a country's, is fitted near it: lever arms of
// kilometres would drown the face in the normal equations, and the search would run out of cells.
#pragma once

#include "base/types.hpp"

namespace mien {

/// [J]; tags in brackets: registration/settings.hpp. Scanners put the origin into the camera or the
/// turntable, a few metres away; these scans keep their coordinates.
struct FarScanSettings {
    double spreads = 300;  ///< > 0: standard deviations of the vertices, beyond which it is far
};

/// The middle of the vertices that are finite, in their unit; zero when it is not far.
/// O(#vertices).
Vector3 far_origin(const PointsRef& vertices, const FarScanSettings& settings);

}  // namespace mien
