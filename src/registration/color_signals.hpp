// What a scan's colours say, as two numbers that light changes little: redness log(R / G), which
// lips have and skin has not, and darkness -log(luminance), which brows have. Luminance by the
// weights of Rec. 601.
#pragma once

#include "base/types.hpp"

namespace mien {

/// #V x 2, logarithms: redness and darkness.
using ColorSignals = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;
enum class ColorSignal : int { redness = 0, darkness = 1 };

struct ColorSignalSettings {
    float black = 8;  ///< of 255, > 0: added to every channel, as near black a camera's noise is
                      ///< all there is and a logarithm blows it up [J]
};

/// Of one colour, 0 to 255.
Eigen::Vector2d color_signal(const Vector3& color, const ColorSignalSettings& settings);

/// #V x 2 from #V x 3 colours.
ColorSignals color_signals(const Colors& colors, const ColorSignalSettings& settings);

}  // namespace mien
