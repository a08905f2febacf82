// Small plots for reports: axes with round ticks, labelled curves, error bars, markers, bars.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "image.hpp"

namespace mien::cli {

struct Curve {
    std::string label;          ///< in the legend; empty: not listed
    std::vector<double> x, y;   ///< of one length; a y that is not a number interrupts the line
    std::vector<double> error;  ///< half length of error bars, or empty
    bool line = true;
    bool markers = false;
    int color = -1;  ///< index into the palette; -1: by position
};

struct PlotOptions {
    std::string title, x_label, y_label;
    int width = 640, height = 420;  ///< pixels
    bool log_x = false, log_y = false;
    bool zero_y = false;      ///< the y axis begins at zero
    bool equal_axes = false;  ///< both axes cover one range, with the diagonal drawn
    double x_low = std::numeric_limits<double>::quiet_NaN();  ///< NaN: from the data
    double x_high = std::numeric_limits<double>::quiet_NaN();
    double y_low = std::numeric_limits<double>::quiet_NaN();
    double y_high = std::numeric_limits<double>::quiet_NaN();
};

/// Throws std::invalid_argument when x and y differ in length or there is nothing to draw.
Image draw_plot(const std::vector<Curve>& curves, const PlotOptions& options);

/// One bar per name and series, grouped; `series` gives the labels and values[s][name] the heights.
Image draw_bars(const std::vector<std::string>& names, const std::vector<std::string>& series,
                const std::vector<std::vector<double>>& values, const PlotOptions& options);

Rgb palette_color(int k);

}  // namespace mien::cli
