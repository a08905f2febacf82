#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "font.hpp"

namespace mien::cli {

Image::Image(int columns, int rows, Rgb fill) : width(columns), height(rows) {
    rgb.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * 3);
    for (std::size_t k = 0; k < rgb.size(); ++k) rgb[k] = fill[k % 3];
}

void Image::set(int x, int y, Rgb color) {
    if (!contains(x, y)) return;
    std::copy(color.begin(), color.end(),
              rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + x));
}

void Image::blend(int x, int y, Rgb color, double cover) {
    if (!contains(x, y) || !(cover > 0)) return;
    cover = std::min(cover, 1.0);
    const Rgb below = at(x, y);
    Rgb mixed;
    for (std::size_t k = 0; k < 3; ++k)
        mixed[k] = static_cast<std::uint8_t>(std::lround(below[k] + cover * (color[k] - below[k])));
    set(x, y, mixed);
}

Rgb Image::at(int x, int y) const {
    const std::size_t k = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x));
    return {rgb[k], rgb[k + 1], rgb[k + 2]};
}

void paste(Image& canvas, const Image& part, int x, int y) {
    for (int j = 0; j < part.height; ++j)
        for (int i = 0; i < part.width; ++i) canvas.set(x + i, y + j, part.at(i, j));
}

void draw_line(Image& canvas, double x0, double y0, double x1, double y1, Rgb color, double width) {
    if (!std::isfinite(x0 + y0 + x1 + y1)) return;
    const double reach = width / 2 + 1, dx = x1 - x0, dy = y1 - y0;
    const double length2 = std::max(dx * dx + dy * dy, 1e-12);
    const auto low = [&](double a, double b) {
        return static_cast<int>(std::max(0.0, std::floor(std::min(a, b) - reach)));
    };
    const auto high = [&](double a, double b, int end) {
        return static_cast<int>(std::min<double>(end - 1, std::ceil(std::max(a, b) + reach)));
    };
    for (int y = low(y0, y1); y <= high(y0, y1, canvas.height); ++y)
        for (int x = low(x0, x1); x <= high(x0, x1, canvas.width); ++x) {
            const double t = std::clamp(((x - x0) * dx + (y - y0) * dy) / length2, 0.0, 1.0);
            const double d = std::hypot(x - x0 - t * dx, y - y0 - t * dy);
            canvas.blend(x, y, color, std::min(1.0, width / 2 + 0.5 - d));
        }
}

void fill_box(Image& canvas, int x, int y, int width, int height, Rgb color) {
    for (int j = std::max(0, y); j < std::min(canvas.height, y + height); ++j)
        for (int i = std::max(0, x); i < std::min(canvas.width, x + width); ++i)
            canvas.set(i, j, color);
}

void draw_disc(Image& canvas, double x, double y, double radius, Rgb color) {
    if (!std::isfinite(x + y)) return;
    const int reach = static_cast<int>(radius) + 2;
    const int cx = static_cast<int>(std::lround(std::clamp(x, -1e6, 1e6)));
    const int cy = static_cast<int>(std::lround(std::clamp(y, -1e6, 1e6)));
    for (int j = cy - reach; j <= cy + reach; ++j)
        for (int i = cx - reach; i <= cx + reach; ++i)
            canvas.blend(i, j, color, radius + 0.5 - std::hypot(i - x, j - y));
}

void draw_text(Image& canvas, int x, int y, const std::string& text, Rgb color, int scale,
               bool upward) {
    static constexpr unsigned char kBox[5] = {0x7f, 0x41, 0x41, 0x41, 0x7f};
    int along = 0;
    for (const char character : text) {
        const int code = static_cast<unsigned char>(character);
        if (code >= 0x80 && code < 0xC0) continue;  // the rest of a UTF-8 character
        const unsigned char* glyph = code >= 32 && code < 127 ? kFont[code - 32] : kBox;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 7; ++j)
                if (glyph[i] >> j & 1) {
                    const int u = along + i * scale, v = j * scale;
                    if (upward)
                        fill_box(canvas, x + v, y - u - scale + 1, scale, scale, color);
                    else
                        fill_box(canvas, x + u, y + v, scale, scale, color);
                }
        along += 6 * scale;
    }
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::fabs(value) < 1e-300 ? 0.0 : value);
    return text;
}

std::vector<double> round_ticks(double low, double high, int count) {
    std::vector<double> ticks;
    if (!(high > low) || !std::isfinite(high - low)) return {low};
    const double raw = (high - low) / std::max(1, count);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * power;
    for (double factor : {1.0, 2.0, 2.5, 5.0})
        if (factor * power >= raw) {
            step = factor * power;
            break;
        }
    const double slack = 1e-9 * step;
    for (double k = std::ceil((low - slack) / step); k * step <= high + slack && ticks.size() < 100;
         ++k)
        ticks.push_back(k * step);
    return ticks;
}

}  // namespace mien::cli
