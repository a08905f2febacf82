#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace mien::cli {
namespace {

constexpr int kLeft = 78, kRight = 18, kTop = 34, kBottom = 48;

/// One axis: data to 0..1, linear or logarithmic.
struct Axis {
    double low = 0, high = 1;
    bool log = false;

    double at(double value) const {
        if (log)
            return (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
        return (value - low) / (high - low);
    }
    std::vector<double> ticks(int count) const {
        if (!log) return round_ticks(low, high, count);
        std::vector<double> out;
        for (double e = std::floor(std::log10(low)); e <= std::ceil(std::log10(high)); ++e)
            for (double factor : {1.0, 2.0, 5.0}) {
                const double t = factor * std::pow(10.0, e);
                if (t >= low * 0.999 && t <= high * 1.001 && (factor == 1.0 || high / low < 120))
                    out.push_back(t);
            }
        return out;
    }
};

class Range {
  public:
    explicit Range(bool positive_only) : positive_only_(positive_only) {}
    void add(double x) {
        if (!std::isfinite(x) || (positive_only_ && x <= 0)) return;
        low_ = std::min(low_, x);
        high_ = std::max(high_, x);
    }
    Axis axis(double low, double high, double pad) const {
        Axis axis;
        axis.log = positive_only_;
        axis.low = low_ <= high_ ? low_ : (positive_only_ ? 0.1 : 0);
        axis.high = low_ <= high_ ? high_ : 1;
        const double span = axis.high - axis.low;
        if (span <= 1e-12 * std::fabs(axis.high) || span == 0) {
            const double widen = axis.high == 0 ? 1 : 0.1 * std::fabs(axis.high);
            axis.low -= positive_only_ ? 0 : widen;
            axis.high += widen;
        } else if (!positive_only_) {
            axis.low -= pad * span;
            axis.high += pad * span;
        }
        if (!std::isnan(low)) axis.low = low;
        if (!std::isnan(high)) axis.high = high;
        if (!(axis.high > axis.low))
            throw std::invalid_argument("an axis must end above where it begins");
        if (axis.log && axis.low <= 0)
            throw std::invalid_argument("a logarithmic axis must begin above zero");
        return axis;
    }

  private:
    bool positive_only_;
    double low_ = HUGE_VAL, high_ = -HUGE_VAL;
};

class Canvas {
  public:
    Canvas(const PlotOptions& options, Axis x, Axis y)
        : image(options.width, options.height), x_(x), y_(y) {
        if (options.width < 160 || options.height < 120 || options.width > 8192 ||
            options.height > 8192)
            throw std::invalid_argument("a plot must be 160 x 120 to 8192 x 8192 pixels");
        width_ = options.width - kLeft - kRight;
        height_ = options.height - kTop - kBottom;
    }
    double px(double x) const { return kLeft + x_.at(x) * width_; }
    double py(double y) const { return kTop + (1 - y_.at(y)) * height_; }
    int left() const { return kLeft; }
    int right() const { return kLeft + width_; }
    int bottom() const { return kTop + height_; }

    void frame(const PlotOptions& options, bool x_ticks) {
        for (double t : y_.ticks(6)) {
            const int y = static_cast<int>(std::lround(py(t)));
            fill_box(image, kLeft, y, width_, 1, kLightGrey);
            const std::string text = short_number(t);
            draw_text(image, kLeft - 6 - text_width(text), y - 3, text);
        }
        if (x_ticks)
            for (double t : x_.ticks(8)) {
                const int x = static_cast<int>(std::lround(px(t)));
                fill_box(image, x, kTop, 1, height_, kLightGrey);
                const std::string text = short_number(t);
                draw_text(image, x - text_width(text) / 2, bottom() + 7, text);
            }
        fill_box(image, kLeft, kTop, 1, height_, kBlack);
        fill_box(image, kLeft, bottom(), width_ + 1, 1, kBlack);
        const int title_scale = text_width(options.title, 2) < options.width - 20 ? 2 : 1;
        draw_text(image, (options.width - text_width(options.title, title_scale)) / 2, 9,
                  options.title, kBlack, title_scale);
        draw_text(image, kLeft + (width_ - text_width(options.x_label)) / 2, options.height - 16,
                  options.x_label);
        draw_text(image, 8, kTop + (height_ + text_width(options.y_label)) / 2, options.y_label,
                  kBlack, 1, true);
    }
    void legend(const std::vector<std::string>& labels, const std::vector<Rgb>& colors) {
        int longest = 0, rows = 0;
        for (const std::string& label : labels)
            if (!label.empty()) {
                longest = std::max(longest, text_width(label));
                ++rows;
            }
        if (rows == 0) return;
        const int width = longest + 34, height = 13 * rows + 6;
        const int x = emptiest_corner(width, height), y = kTop + 6;
        fill_box(image, x, y, width, height, kLightGrey);
        fill_box(image, x + 1, y + 1, width - 2, height - 2, kWhite);
        int row = 0;
        for (std::size_t k = 0; k < labels.size(); ++k) {
            if (labels[k].empty()) continue;
            const int line = y + 5 + 13 * row++;
            draw_line(image, x + 6, line + 3, x + 22, line + 3, colors[k], 2.5);
            draw_text(image, x + 28, line, labels[k]);
        }
    }
    Image image;

  private:
    // Of the upper corners, the one that hides less of the curves.
    int emptiest_corner(int width, int height) const {
        const int at[2] = {right() - width - 6, kLeft + 8};
        int hidden[2] = {0, 0};
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i)
                    if (image.contains(at[k] + i, kTop + 6 + j)) {
                        const Rgb c = image.at(at[k] + i, kTop + 6 + j);
                        hidden[k] += c != kWhite && c != kLightGrey;
                    }
        return at[hidden[1] < hidden[0]];
    }
    Axis x_, y_;
    int width_ = 0, height_ = 0;
};

}  // namespace

Rgb palette_color(int k) {
    // Hues that stay apart for people who do not tell red from green (Okabe and Ito 2008).
    static constexpr Rgb kColors[] = {{0, 114, 178}, {213, 94, 0},   {0, 158, 115}, {204, 121, 167},
                                      {230, 159, 0}, {86, 180, 233}, {120, 94, 60}, {90, 90, 90}};
    return kColors[static_cast<std::size_t>(k < 0 ? 0 : k) % 8];
}

Image draw_plot(const std::vector<Curve>& curves, const PlotOptions& options) {
    Range x_range(options.log_x), y_range(options.log_y);
    std::size_t count = 0;
    for (const Curve& c : curves) {
        if (c.x.size() != c.y.size() || (!c.error.empty() && c.error.size() != c.y.size()))
            throw std::invalid_argument("curve '" + c.label + "': x, y and error differ in length");
        count += c.x.size();
        for (std::size_t k = 0; k < c.x.size(); ++k) {
            const double e = c.error.empty() || !std::isfinite(c.error[k]) ? 0 : c.error[k];
            x_range.add(c.x[k]);
            y_range.add(c.y[k] - e);
            y_range.add(c.y[k] + e);
            if (options.equal_axes) {
                x_range.add(c.y[k]);
                y_range.add(c.x[k]);
            }
        }
    }
    if (count == 0) throw std::invalid_argument("there is nothing to plot");
    if (options.zero_y && !options.log_y) y_range.add(0);
    Axis y_axis = y_range.axis(options.y_low, options.y_high, 0.05);
    if (options.zero_y && !options.log_y && std::isnan(options.y_low) && y_axis.low < 0 &&
        y_axis.low > -0.1 * y_axis.high)
        y_axis.low = 0;
    Canvas canvas(options, x_range.axis(options.x_low, options.x_high, 0.03), y_axis);
    canvas.frame(options, true);
    if (options.equal_axes)
        draw_line(canvas.image, canvas.left(),
                  canvas.py(x_range.axis(options.x_low, options.x_high, 0.03).low), canvas.right(),
                  canvas.py(x_range.axis(options.x_low, options.x_high, 0.03).high), kGrey);
    std::vector<std::string> labels;
    std::vector<Rgb> colors;
    for (std::size_t n = 0; n < curves.size(); ++n) {
        const Curve& c = curves[n];
        const Rgb color = palette_color(c.color >= 0 ? c.color : static_cast<int>(n));
        labels.push_back(c.label);
        colors.push_back(color);
        for (std::size_t k = 0; k < c.x.size(); ++k) {
            const double x = canvas.px(c.x[k]), y = canvas.py(c.y[k]);
            if (!std::isfinite(x + y)) continue;
            if (c.line && k > 0)
                draw_line(canvas.image, canvas.px(c.x[k - 1]), canvas.py(c.y[k - 1]), x, y, color,
                          2.0);
            if (!c.error.empty() && c.error[k] > 0) {
                const double top = canvas.py(c.y[k] + c.error[k]);
                double foot = canvas.py(c.y[k] - c.error[k]);
                if (!std::isfinite(foot)) foot = canvas.bottom();
                draw_line(canvas.image, x, top, x, foot, color);
                draw_line(canvas.image, x - 3, top, x + 3, top, color);
                draw_line(canvas.image, x - 3, foot, x + 3, foot, color);
            }
            if (c.markers) draw_disc(canvas.image, x, y, 3.2, color);
        }
    }
    canvas.legend(labels, colors);
    return canvas.image;
}

Image draw_bars(const std::vector<std::string>& names, const std::vector<std::string>& series,
                const std::vector<std::vector<double>>& values, const PlotOptions& options) {
    if (names.empty() || series.empty() || values.size() != series.size())
        throw std::invalid_argument("bars need names, and one row of values per series");
    Range range(false);
    range.add(0);
    for (const auto& row : values) {
        if (row.size() != names.size())
            throw std::invalid_argument("a row of bars has another length than the names");
        for (double v : row) range.add(v);
    }
    Axis x;
    x.low = 0;
    x.high = static_cast<double>(names.size());
    Axis y = range.axis(options.y_low, options.y_high, 0.06);
    if (y.low < 0 && y.low > -0.1 * y.high) y.low = 0;
    // Names that do not fit side by side stand upright and take room below.
    std::size_t longest = 0;
    for (const std::string& name : names) longest = std::max(longest, name.size());
    const double room =
        static_cast<double>(options.width - kLeft - kRight) / static_cast<double>(names.size());
    const bool upright = 6.0 * static_cast<double>(longest) > room - 4;
    const int extra = upright ? 6 * static_cast<int>(longest) : 0;
    PlotOptions inner = options;
    inner.height = std::max(160, options.height - extra);
    Canvas canvas(inner, x, y);
    canvas.frame(inner, false);
    const double step = 0.8 / static_cast<double>(series.size());
    std::vector<Rgb> colors;
    for (std::size_t s = 0; s < series.size(); ++s) {
        colors.push_back(palette_color(static_cast<int>(s)));
        for (std::size_t k = 0; k < names.size(); ++k) {
            const double v = values[s][k];
            if (!std::isfinite(v)) continue;
            const double x0 =
                canvas.px(static_cast<double>(k) + 0.1 + step * static_cast<double>(s));
            const double x1 =
                canvas.px(static_cast<double>(k) + 0.1 + step * static_cast<double>(s + 1));
            const double y0 = canvas.py(std::max(v, 0.0)), y1 = canvas.py(std::min(v, 0.0));
            fill_box(canvas.image, static_cast<int>(x0), static_cast<int>(y0),
                     std::max(1, static_cast<int>(x1 - x0) - 1),
                     std::max(1, static_cast<int>(y1 - y0)), colors.back());
        }
    }
    canvas.legend(series, colors);
    Image out(canvas.image.width, inner.height + extra);
    paste(out, canvas.image, 0, 0);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const int centre = static_cast<int>(canvas.px(static_cast<double>(k) + 0.5));
        if (upright)
            draw_text(out, centre - 3, canvas.bottom() + 8 + text_width(names[k]), names[k], kBlack,
                      1, true);
        else
            draw_text(out, centre - text_width(names[k]) / 2, canvas.bottom() + 7, names[k]);
    }
    return out;
}

}  // namespace mien::cli
