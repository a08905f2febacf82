// How likely is a colour that of skin? The rule of Kolkur et al. (Human skin detection using RGB,
// HSV and YCbCr colour models, 2017), softened: each of its limits becomes a slope, and the weight
// is the product, so that a shade at the edge of the rule is doubted and not cut.
#pragma once

#include "base/types.hpp"

namespace mien {

/// 0 well below `limit`, 1 well above, a logistic slope of about +- `width` between.
struct SoftLimit {
    double limit = 0, width = 1;  ///< width > 0
};

/// Limits as published (R, G, B, Y, Cb, Cr 0 to 255; hue in degrees; saturation 0 to 1); widths by
/// judgement, not measured.
struct SkinSettings {
    double floor = 0.05;  ///< 0 to 1: least weight, so that a scan in odd light keeps some [J]
    SoftLimit red{95, 20}, green{40, 15}, blue{20, 10};
    SoftLimit red_over_green{0, 12}, red_over_blue{0, 12}, spread{15, 10};
    /// Lips and shaded skin have hues just below 360, so the rule's 0 to 50 is read on the circle
    /// and begins at -10.
    SoftLimit hue_from{-10, 10};
    double hue_to_deg = 50;
    SoftLimit saturation_from{0.23, 0.08};
    double saturation_to = 0.68;
    SoftLimit cr{135, 6}, cb{85, 8}, luma{80, 20};
    double cr_slope_above = 1.5862, cr_above = 20;       ///< Cr <= 1.5862 Cb + 20
    double cr_slope_below = 0.3448, cr_below = 76.2069;  ///< Cr >= 0.3448 Cb + 76.2069
    double cr_line_width = 8, hue_to_width = 10, saturation_to_width = 0.08;
};

/// The weight, in [floor, 1], of one colour, 0 to 255.
double skin_weight(const Vector3& color, const SkinSettings& settings);

/// #V weights in [floor, 1] from #V x 3 colours.
Vector skin_weights(const Colors& colors, const SkinSettings& settings);

}  // namespace mien
