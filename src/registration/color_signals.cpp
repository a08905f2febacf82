#include "registration/color_signals.hpp"

namespace mien {

ColorSignals color_signals(const Colors& colors, const ColorSignalSettings& settings) {
    const Eigen::ArrayX3f light = colors.cast<float>().array() + settings.black;
    ColorSignals signals(colors.rows(), 2);
    signals.col(static_cast<int>(ColorSignal::redness)) = (light.col(0) / light.col(1)).log();
    signals.col(static_cast<int>(ColorSignal::darkness)) =
        -(0.299f * light.col(0) + 0.587f * light.col(1) + 0.114f * light.col(2)).log();
    return signals;
}

}  // namespace mien
