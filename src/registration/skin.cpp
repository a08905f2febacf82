#include "registration/skin.hpp"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

double above(double value, const SoftLimit& soft) {
    return 1 / (1 + std::exp(-4 * (value - soft.limit) / soft.width));
}

// Degrees, 0 to 360 (HSV).
double hue_of(double r, double g, double b, double high, double spread) {
    double hue = 0;
    if (spread > 0) {
        if (high == r)
            hue = 60 * (g - b) / spread;
        else if (high == g)
            hue = 60 * (2 + (b - r) / spread);
        else
            hue = 60 * (4 + (r - g) / spread);
    }
    return hue < 0 ? hue + 360 : hue;
}

double probability(double r, double g, double b, const SkinSettings& s) {
    const double high = std::max({r, g, b}), low = std::min({r, g, b}), spread = high - low;
    const double hue = hue_of(r, g, b, high, spread);
    const double saturation = high > 0 ? spread / high : 0;
    // YCbCr of JPEG (Rec. 601).
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    const double cb = 128 - 0.168736 * r - 0.331264 * g + 0.5 * b;
    const double cr = 128 + 0.5 * r - 0.418688 * g - 0.081312 * b;
    const double redness = above(r, s.red) * above(g, s.green) * above(b, s.blue) *
                           above(r - g, s.red_over_green) * above(r - b, s.red_over_blue) *
                           above(spread, s.spread);
    const double turned = hue > 180 ? hue - 360 : hue;
    const double tint = above(turned, s.hue_from) *
                        above(s.hue_to_deg - turned, {0, s.hue_to_width}) *
                        above(saturation, s.saturation_from) *
                        above(s.saturation_to - saturation, {0, s.saturation_to_width});
    const double chroma = above(cr, s.cr) * above(cb, s.cb) * above(y, s.luma) *
                          above(s.cr_slope_above * cb + s.cr_above - cr, {0, s.cr_line_width}) *
                          above(cr - (s.cr_slope_below * cb + s.cr_below), {0, s.cr_line_width});
    // Kolkur: (RGB and HSV) or (RGB and YCbCr).
    return redness * std::max(tint, chroma);
}

}  // namespace

double skin_weight(const Vector3& color, const SkinSettings& settings) {
    return settings.floor +
           (1 - settings.floor) * probability(color[0], color[1], color[2], settings);
}

Vector skin_weights(const Colors& colors, const SkinSettings& settings) {
    Vector weights(colors.rows());
    for (Index i = 0; i < colors.rows(); ++i)
        weights[i] = skin_weight(Vector3(colors(i, 0), colors(i, 1), colors(i, 2)), settings);
    return weights;
}

}  // namespace mien
