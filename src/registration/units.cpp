#include "registration/units.hpp"

#include <algorithm>
#include <vector>

#include "base/error.hpp"

namespace mien {

double detect_unit_mm(const PointsRef& vertices, const UnitSettings& settings) {
    Vector3 extent;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values(static_cast<std::size_t>(vertices.rows()));
        for (Index i = 0; i < vertices.rows(); ++i)
            values[static_cast<std::size_t>(i)] = vertices(i, axis);
        const std::size_t low = values.size() / static_cast<std::size_t>(settings.stray),
                          high = values.size() - 1 - low;
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(low),
                         values.end());
        const double a = values[low];
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(high),
                         values.end());
        extent[axis] = values[high] - a;
    }
    const double size = extent.norm();
    for (const double unit : settings.candidates_mm)
        if (size * unit >= settings.smallest_mm && size * unit <= settings.largest_mm) return unit;
    return 0;
}

double choose_unit_mm(const PointsRef& vertices, UnitRule rule, const UnitSettings& settings) {
    if (rule == UnitRule::millimetres) return 1;
    const double unit = detect_unit_mm(vertices, settings);
    if (rule == UnitRule::refuse && unit != 1)
        fail(Status::invalid_argument,
             unit == 0 ? "the scan's size fits no head in mm, cm, dm, inches or metres"
                       : "the scan is not in millimetres: one unit seems to be %g mm; scale it or "
                         "let units be detected",
             unit);
    return unit == 0 ? 1 : unit;
}

}  // namespace mien
