// What one unit of a scan is in millimetres, by the size of what was scanned: a face alone measures
// about 200 mm across corners, a bust 700. Landmarks and a face that was found settle it better
// (landmark_frame.hpp, registration.cpp).
#pragma once

#include "base/types.hpp"
#include "mesh/length_unit.hpp"

namespace mien {

/// What one unit of the scan is. The numbers are the C ABI's numbers.
enum class UnitRule : std::int32_t {
    detect = 0,       ///< by the size of what was scanned; scale to millimetres
    millimetres = 1,  ///< as given
    refuse = 2,       ///< throw Status::invalid_argument when it does not look like millimetres
};

struct UnitSettings {
    double smallest_mm = 110, largest_mm = 900;  ///< diagonal of the extent of a face, a bust [J]
    double usual_mm = 280;  ///< of a head: the unit that comes nearest to it is taken [J]
    Index stray = 50;       ///< one vertex in so many at each end of an axis may lie anywhere [J]
};

/// One of length_units(); 0 when none fits a head. O(V).
double detect_unit_mm(const PointsRef& vertices, const UnitSettings& settings);

/// The unit under `rule`; 1 when nothing fits and the rule does not refuse.
double choose_unit_mm(const PointsRef& vertices, UnitRule rule, const UnitSettings& settings);

}  // namespace mien
