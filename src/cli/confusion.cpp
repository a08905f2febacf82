#include "confusion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mien::cli {
namespace {

constexpr int kCell = 46, kLeft = 58, kTop = 62, kRight = 16, kBottom = 14;  // pixels
constexpr Rgb kFull{24, 86, 150};
constexpr std::size_t kAcross = 3;

Rgb shade(double share) {
    Rgb color;
    for (std::size_t k = 0; k < 3; ++k)
        color[k] =
            static_cast<std::uint8_t>(std::lround(kWhite[k] + share * (kFull[k] - kWhite[k])));
    return color;
}

void centre_text(Image& canvas, int x, int y, const std::string& text, Rgb color) {
    draw_text(canvas, x - text_width(text) / 2, y - 4, text, color);
}

void draw_frame(Image& canvas, int x, int y, Rgb color, double width) {
    draw_line(canvas, x, y, x + kCell, y, color, width);
    draw_line(canvas, x, y + kCell, x + kCell, y + kCell, color, width);
    draw_line(canvas, x, y, x, y + kCell, color, width);
    draw_line(canvas, x + kCell, y, x + kCell, y + kCell, color, width);
}

}  // namespace

std::vector<std::vector<double>> confusion_counts(const std::vector<int>& rows,
                                                  const std::vector<int>& columns, int grades) {
    if (rows.size() != columns.size())
        throw std::invalid_argument("a confusion matrix needs two grades of each subject");
    for (const int grade : rows) grades = std::max(grades, grade + 1);
    for (const int grade : columns) grades = std::max(grades, grade + 1);
    const auto size = static_cast<std::size_t>(std::max(grades, 1));
    std::vector<std::vector<double>> counts(size, std::vector<double>(size, 0.0));
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (rows[k] >= 0 && columns[k] >= 0)
            ++counts[static_cast<std::size_t>(rows[k])][static_cast<std::size_t>(columns[k])];
    return counts;
}

Image draw_confusion(const Confusion& confusion) {
    const std::size_t size = confusion.counts.size();
    if (size == 0) throw std::invalid_argument("a confusion matrix without grades");
    for (const auto& row : confusion.counts)
        if (row.size() != size) throw std::invalid_argument("a confusion matrix must be square");
    const int side = kCell * static_cast<int>(size);
    const int width = std::max(kLeft + side + kRight, text_width(confusion.title) + 16);
    Image canvas(width, kTop + side + kBottom);
    draw_text(canvas, 8, 10, confusion.title);
    centre_text(canvas, kLeft + side / 2, 32, confusion.column_label, kGrey);
    draw_text(canvas, 10, kTop + side / 2 - text_width(confusion.row_label) / 2,
              confusion.row_label, kGrey, 1, true);
    for (std::size_t i = 0; i < size; ++i) {
        const int along = kCell * static_cast<int>(i);
        centre_text(canvas, kLeft + along + kCell / 2, kTop - 10, std::to_string(i), kBlack);
        centre_text(canvas, kLeft - 16, kTop + along + kCell / 2, std::to_string(i), kBlack);
        double total = 0;
        for (const double count : confusion.counts[i]) total += count;
        for (std::size_t j = 0; j < size; ++j) {
            const double count = confusion.counts[i][j], share = total > 0 ? count / total : 0;
            const int x = kLeft + kCell * static_cast<int>(j), y = kTop + along;
            fill_box(canvas, x, y, kCell, kCell, shade(share));
            draw_frame(canvas, x, y, kLightGrey, 1);
            centre_text(canvas, x + kCell / 2, y + kCell / 2, short_number(count),
                        share > 0.55 ? kWhite : kBlack);
        }
    }
    for (std::size_t i = 0; i < size; ++i)
        draw_frame(canvas, kLeft + kCell * static_cast<int>(i), kTop + kCell * static_cast<int>(i),
                   kBlack, 1.6);
    return canvas;
}

Image draw_confusions(const std::vector<Confusion>& matrices) {
    if (matrices.empty()) throw std::invalid_argument("no confusion matrix to draw");
    std::vector<Image> parts;
    parts.reserve(matrices.size());
    for (const Confusion& one : matrices) parts.push_back(draw_confusion(one));
    int cell_width = 0, cell_height = 0;
    for (const Image& part : parts) {
        cell_width = std::max(cell_width, part.width);
        cell_height = std::max(cell_height, part.height);
    }
    const std::size_t across = std::min(kAcross, parts.size());
    const std::size_t lines = (parts.size() + across - 1) / across;
    Image canvas(cell_width * static_cast<int>(across), cell_height * static_cast<int>(lines));
    for (std::size_t k = 0; k < parts.size(); ++k)
        paste(canvas, parts[k], cell_width * static_cast<int>(k % across),
              cell_height * static_cast<int>(k / across));
    return canvas;
}

}  // namespace mien::cli
