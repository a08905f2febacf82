// Numbers and ramps of one variable that every room uses.
#pragma once

#include <algorithm>

namespace mien {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadiansPerDegree = kPi / 180;

/// Smooth ramp 3 x^2 - 2 x^3: 0 below 0, 1 above 1. Filters fade with it instead of cutting,
/// because a cut amplifies rounding: the same vertex would pass in one frame of reference and not
/// in another.
inline double fade(double x) {
    x = std::min(1.0, std::max(0.0, x));
    return x * x * (3 - 2 * x);
}

}  // namespace mien
