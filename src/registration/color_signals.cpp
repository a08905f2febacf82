#include "registration/color_signals.hpp"

#include <cmath>

namespace mien {

Eigen::Vector2d color_signal(const Vector3& color, const ColorSignalSettings& settings) {
    const Vector3 light = color.array() + static_cast<double>(settings.black);
    Eigen::Vector2d signal;
    signal[static_cast<int>(ColorSignal::redness)] = std::log(light[0] / light[1]);
    signal[static_cast<int>(ColorSignal::darkness)] =
        -std::log(0.299 * light[0] + 0.587 * light[1] + 0.114 * light[2]);
    return signal;
}

ColorSignals color_signals(const Colors& colors, const ColorSignalSettings& settings) {
    const Eigen::ArrayX3f light = colors.cast<float>().array() + settings.black;
    ColorSignals signals(colors.rows(), 2);
    signals.col(static_cast<int>(ColorSignal::redness)) = (light.col(0) / light.col(1)).log();
    signals.col(static_cast<int>(ColorSignal::darkness)) =
        -(0.299f * light.col(0) + 0.587f * light.col(1) + 0.114f * light.col(2)).log();
    return signals;
}

}  // namespace mien
