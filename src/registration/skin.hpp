// How likely is a colour that of skin? The rule of Kolkur et al. (Human skin detection using RGB,
// HSV and YCbCr colour models, 2017), softened: each of its limits becomes a slope, and the weight
// is the product, so that a shade at the edge of the rule is doubted and not cut.
#pragma once

#include "base/types.hpp"

namespace mien {

/// #V weights in [floor, 1] from #V x 3 colours.
Vector skin_weights(const Colors& colors, double floor);

}  // namespace mien
