// Pictures in memory, and drawing on them: lines, boxes, text in a built-in 5x7 font.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mien::cli {

using Rgb = std::array<std::uint8_t, 3>;

inline constexpr Rgb kWhite{255, 255, 255}, kBlack{20, 20, 20}, kGrey{130, 130, 130},
    kLightGrey{225, 225, 225};

/// Rows from the top, red green blue.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    Image() = default;
    Image(int columns, int rows, Rgb fill = kWhite);
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    void set(int x, int y, Rgb color);
    /// Mixes `color` over the pixel with weight `cover`, 0..1.
    void blend(int x, int y, Rgb color, double cover);
    Rgb at(int x, int y) const;
};

/// Copies `part` onto `canvas` with its upper left corner at (x, y); what sticks out is cut off.
void paste(Image& canvas, const Image& part, int x, int y);

/// An anti-aliased line between pixel positions.
void draw_line(Image& canvas, double x0, double y0, double x1, double y1, Rgb color,
               double width = 1.0);
void fill_box(Image& canvas, int x, int y, int width, int height, Rgb color);
void draw_disc(Image& canvas, double x, double y, double radius, Rgb color);

/// ASCII text with its upper left corner at (x, y); a character takes 6 x 8 pixels times `scale`.
/// Other bytes are drawn as a box. `upward` turns the text to run from bottom to top.
void draw_text(Image& canvas, int x, int y, const std::string& text, Rgb color = kBlack,
               int scale = 1, bool upward = false);
inline int text_width(const std::string& text, int scale = 1) {
    return 6 * scale * static_cast<int>(text.size());
}

/// A number in few digits, as for axes and colour bars.
std::string short_number(double value);
/// About `count` round positions covering low..high; both ends inside.
std::vector<double> round_ticks(double low, double high, int count);

/// PNG bytes; throws std::runtime_error when the encoder fails or the image is empty.
std::string encode_png(const Image& image);
void write_png(const std::string& path, const Image& image);
std::string base64(const std::string& bytes);
/// "data:image/png;base64,...", for HTML that stands alone.
std::string png_data_uri(const Image& image);

}  // namespace mien::cli
