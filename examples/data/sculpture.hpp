// The head as an implicit surface: sculpture(p) < 0 inside, 0 on the skin, > 0 outside; close to a
// distance in mm near the skin. Made of ellipsoids and capsules that melt into each other (smooth
// minimum) plus soft bumps and dents, the measures after ordinary adult anthropometry (head 228 mm
// high, 152 wide, 195 long; pupils 63 apart; mouth 50 wide). Symmetric in x.
// Axes: +x the subject's left, +y up, +z out of the face; the origin lies between the ears.
#pragma once

#include "numbers.hpp"

namespace mien::demo {

double sculpture(V3 p);
V3 sculpture_gradient(V3 p);  ///< central differences

/// Curves on the face that the mesh must follow, as seen from the front.
namespace plan {
inline constexpr double kEyeX = 31.5, kEyeY = 25.0;          ///< pupil
inline constexpr double kEyeInner = 16.5, kEyeOuter = 45.5;  ///< |x| of the eye corners
inline constexpr V3 kEyeball{31.5, 25.0, 70.5};              ///< centre of the left eyeball
inline constexpr double kEyeballRadius = 12.0;
inline constexpr double kMouthHalfWidth = 25.0;
inline constexpr double kNeckRim = -150.0;

/// Negative within the left eye's opening, zero on the edge of the lids (an almond whose corners
/// are smooth), positive outside; not a distance.
double eye_outline(double x, double y);
double mouth_line(double x);  ///< y of the line between the lips
double lip_top(double x);     ///< y of the border between red and skin
double lip_bottom(double x);
}  // namespace plan

}  // namespace mien::demo
