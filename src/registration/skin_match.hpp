// How far has the skin moved between two pictures? Around each place that is asked for, the window
// of the first picture is compared with the second at every move within reach (normalised
// correlation of what both pictures show):
//
//   r(d) = sum a(p) b(p + d) / sqrt(sum a(p)^2 B(p + d) sum b(p + d)^2 A(p)),   A, B: seen
//
// The best move, between pixels by the parabola through its neighbours, counts as much as r is
// curved there: a freckle holds it in every direction, the rim of a lip only across. What noise
// the window has, r itself says:
//
//   precision = n r^2 / (1 - r^2) (-r''/r),   n: independent pixels of the window
//
// (the bound of Cramer and Rao for a shift in white noise).
#pragma once

#include "registration/skin_image.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct SkinMatchSettings {
    double window_mm = 8;     ///< mm, > 0: side of the window
    int reach = 2;            ///< >= 1, pixels: largest move in each direction
    double least_seen = 0.4;  ///< 0 to 1: of the window, in both pictures [J]
    double apart_mm = 2;      ///< mm: a second best move farther away makes the best doubtful [J]
    double pixels_each = 4;   ///< > 0: neighbouring pixels that say the same [J]
};

struct SkinMatch {
    bool found = false;
    double agreement = 0;                                 ///< r at the best move, -1 to 1
    double at_rest = 0;                                   ///< r where nothing moves
    double lead = 0;                                      ///< r less that of the second best move
    Eigen::Vector2d move_mm = Eigen::Vector2d::Zero();    ///< from the first picture to the second
    Eigen::Matrix2d precision = Eigen::Matrix2d::Zero();  ///< 1/mm^2
};

/// `places`: pixel numbers. The pictures are of one view and resolution. A best move at the end of
/// the reach is none. O(moves pixels).
std::vector<SkinMatch> match_skin(const SkinImage& first, const SkinImage& second,
                                  const std::vector<std::uint32_t>& places,
                                  const SkinMatchSettings& settings, const Context& context);

}  // namespace mien
