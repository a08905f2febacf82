#include "registration/skin.hpp"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

// 0 well below `limit`, 1 well above, over about +- width.
double above(double value, double limit, double width) {
    return 1 / (1 + std::exp(-4 * (value - limit) / width));
}

double probability(double r, double g, double b) {
    const double high = std::max({r, g, b}), low = std::min({r, g, b}), spread = high - low;
    double hue = 0;
    if (spread > 0) {
        if (high == r)
            hue = 60 * (g - b) / spread;
        else if (high == g)
            hue = 60 * (2 + (b - r) / spread);
        else
            hue = 60 * (4 + (r - g) / spread);
    }
    if (hue < 0) hue += 360;
    const double saturation = high > 0 ? spread / high : 0;
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    const double cb = 128 - 0.168736 * r - 0.331264 * g + 0.5 * b;
    const double cr = 128 + 0.5 * r - 0.418688 * g - 0.081312 * b;
    const double redness = above(r, 95, 20) * above(g, 40, 15) * above(b, 20, 10) *
                           above(r - g, 0, 12) * above(r - b, 0, 12) * above(spread, 15, 10);
    // Lips and shaded skin have hues just below 360: the rule's 0..50 is read on the circle.
    const double turned = hue > 180 ? hue - 360 : hue;
    const double tint = above(turned, -10, 10) * above(50 - turned, 0, 10) *
                        above(saturation, 0.23, 0.08) * above(0.68 - saturation, 0, 0.08);
    const double chroma = above(cr, 135, 6) * above(cb, 85, 8) * above(y, 80, 20) *
                          above(1.5862 * cb + 20 - cr, 0, 8) *
                          above(cr - (0.3448 * cb + 76.2069), 0, 8);
    // Kolkur: (RGB and HSV) or (RGB and YCbCr).
    return redness * std::max(tint, chroma);
}

}  // namespace

Vector skin_weights(const Colors& colors, double floor) {
    Vector weights(colors.rows());
    for (Index i = 0; i < colors.rows(); ++i)
        weights[i] = floor + (1 - floor) * probability(colors(i, 0), colors(i, 1), colors(i, 2));
    return weights;
}

}  // namespace mien
