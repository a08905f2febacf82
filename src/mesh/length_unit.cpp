#include "mesh/length_unit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"

namespace mien {

const std::vector<LengthUnit>& length_units() {
    static const std::vector<LengthUnit> units = {
        {"mm", 1}, {"cm", 10}, {"in", 25.4}, {"dm", 100}, {"ft", 304.8}, {"m", 1000}, {"km", 1e6}};
    return units;
}

std::string unit_text(double to_mm) {
    char text[60];
    for (const LengthUnit& unit : length_units())
        if (std::abs(to_mm / unit.to_mm - 1) < 1e-9) {
            std::snprintf(text, sizeof text, "%s (%g mm)", unit.name, to_mm);
            return to_mm == 1 ? std::string("mm") : std::string(text);
        }
    std::snprintf(text, sizeof text, "%g mm", to_mm);
    return text;
}

double robust_extent(const PointsRef& vertices, Index stray) {
    if (vertices.rows() == 0) return 0;
    Vector3 extent;
    std::vector<double> values(static_cast<std::size_t>(vertices.rows()));
    for (int axis = 0; axis < 3; ++axis) {
        for (Index i = 0; i < vertices.rows(); ++i)
            values[static_cast<std::size_t>(i)] = vertices(i, axis);
        const std::size_t low = values.size() / static_cast<std::size_t>(stray),
                          high = values.size() - 1 - low;
        const auto at = [&](std::size_t k) {
            const auto place = values.begin() + static_cast<std::ptrdiff_t>(k);
            std::nth_element(values.begin(), place, values.end());
            return *place;
        };
        const double a = at(low);
        extent[axis] = at(high) - a;
    }
    return extent.norm();
}

std::vector<LengthUnit> plausible_units(double extent) {
    constexpr double kFace_mm = 110, kHead_mm = 280, kBust_mm = 900, kBody_mm = 2600;
    std::vector<LengthUnit> heads, bodies;
    for (const LengthUnit& unit : length_units()) {
        const double size_mm = extent * unit.to_mm;
        if (size_mm >= kFace_mm && size_mm <= kBody_mm)
            (size_mm <= kBust_mm ? heads : bodies).push_back(unit);
    }
    const auto off = [&](const LengthUnit& unit) {
        return std::abs(std::log(extent * unit.to_mm / kHead_mm));
    };
    std::stable_sort(heads.begin(), heads.end(),
                     [&](const LengthUnit& a, const LengthUnit& b) { return off(a) < off(b); });
    heads.insert(heads.end(), bodies.begin(), bodies.end());
    return heads;
}

void check_same_unit(const PointsRef& first, const char* first_name, const PointsRef& second,
                     const char* second_name, double too_different) {
    if (first.rows() < 3 || second.rows() < 3) return;
    const double a = robust_extent(first), b = robust_extent(second);
    if (!(a > 0) || !(b > 0)) return;
    const bool first_larger = a > b;
    const double ratio = first_larger ? a / b : b / a;
    if (ratio < too_different) return;
    const LengthUnit* nearest = &length_units()[1];
    for (const LengthUnit& unit : length_units())
        if (std::abs(std::log(ratio / unit.to_mm)) < std::abs(std::log(ratio / nearest->to_mm)))
            nearest = &unit;
    const char* larger = first_larger ? first_name : second_name;
    const char* smaller = first_larger ? second_name : first_name;
    fail(Status::mismatch,
         "%s is %.3g times larger than %s: they are not in one unit (when %s is in mm, %s is in "
         "%s); bring both to mm first, as `mien mesh scale` does",
         larger, ratio, smaller, larger, smaller, nearest->name);
}

}  // namespace mien
