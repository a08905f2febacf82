#include "registration/units.hpp"

#include <cmath>

#include "base/error.hpp"

namespace mien {

double detect_unit_mm(const PointsRef& vertices, const UnitSettings& settings) {
    const double extent = robust_extent(vertices, settings.stray);
    double best = 0, least = HUGE_VAL;
    for (const LengthUnit& unit : length_units()) {
        const double size_mm = extent * unit.to_mm;
        const double off = std::abs(std::log(size_mm / settings.usual_mm));
        if (size_mm < settings.smallest_mm || size_mm > settings.largest_mm || !(off < least))
            continue;
        least = off;
        best = unit.to_mm;
    }
    return best;
}

double choose_unit_mm(const PointsRef& vertices, UnitRule rule, const UnitSettings& settings) {
    if (rule == UnitRule::millimetres) return 1;
    const double unit = detect_unit_mm(vertices, settings);
    if (rule == UnitRule::refuse && unit != 1)
        fail(Status::invalid_argument,
             unit == 0 ? "the scan's size fits no head in mm, cm, dm, inches, feet, m or km"
                       : "the scan is not in millimetres: one unit seems to be %g mm; scale it or "
                         "let units be detected",
             unit);
    return unit == 0 ? 1 : unit;
}

}  // namespace mien
