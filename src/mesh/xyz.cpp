// Clouds of points as text: a point a line, x y z and perhaps more columns, between blanks, commas
// or semicolons. A first line with words or with a count alone is stepped over. Six columns are a
// colour after the position when the last three are all whole numbers of 0 to 255, or fractions
// that are no unit vectors; else a normal, which has no use here. Seven are an intensity and a
// colour, nine a normal and a colour.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

constexpr int kMostColumns = 16;

/// How the numbers of a line are kept apart. A comma with no blank beside it may stand between two
/// numbers or inside of one; beside blanks or semicolons it can only be a decimal comma.
struct Between {
    bool bare_comma = false, other = false;
    bool has_decimal_comma() const { return bare_comma && other; }
};

/// Steps over blanks, commas and semicolons; what they were is noted when a number follows.
void skip_separators(TextCursor& text, Between& between, bool after_number) {
    const std::size_t before = text.remaining();
    text.skip_blanks();
    int commas = 0;
    bool semicolon = false;
    for (; text.peek() == ',' || text.peek() == ';'; text.skip_blanks()) {
        semicolon = semicolon || text.peek() == ';';
        ++commas;
        text.advance();
    }
    if (!after_number || text.at_line_end() || text.peek() == '#') return;
    if (commas == 0 || semicolon)
        between.other = true;
    else if (before - text.remaining() == 1)
        between.bare_comma = true;
}

/// The numbers of the line; the cursor stays at its end, or before what is no number.
int read_line(TextCursor& text, double (&values)[kMostColumns], Between& between) {
    int count = 0;
    for (; count < kMostColumns; ++count) {
        skip_separators(text, between, count > 0);
        if (text.at_line_end() || text.peek() == '#' || !text.number(values[count])) return count;
    }
    skip_separators(text, between, true);
    return count;
}

/// What the last three columns of six are, seen over all lines.
struct ColorEvidence {
    bool bytes = true, fractions = true, units = true;
    void add(const double* values) {
        double squares = 0.0;
        for (int k = 0; k < 3; ++k) {
            const double value = values[k];
            bytes = bytes && value >= 0.0 && value <= 255.0 && value == std::floor(value);
            fractions = fractions && value >= 0.0 && value <= 1.0;
            squares += value * value;
        }
        units = units && std::abs(squares - 1.0) < 0.01;
    }
    bool is_color() const { return (bytes || fractions) && !units; }
};

}  // namespace

TriMesh read_xyz(const Source& source, const Context& context) {
    TextCursor text(source.bytes.data, source.bytes.data + source.bytes.size);
    std::vector<double> positions;
    std::vector<float> colors;
    ColorEvidence evidence;
    int columns = 0;
    std::size_t num_lines = 0;
    for (; !text.at_end(); text.skip_line()) {
        if (num_lines++ % kCancelInterval == 0) context.check_cancelled();
        double values[kMostColumns];
        Between between;
        const int count = read_line(text, values, between);
        const bool whole =
            text.at_line_end() || text.peek() == '#' || (text.peek() == '/' && count == 0);
        if (count == 0 && whole) continue;
        const bool heading = positions.empty() && (!whole || count == 1);
        if (heading && text.line() <= 2) continue;
        if (!whole || count < 3)
            fail_at(Status::bad_format, text.line(),
                    "line %lld: a point needs three numbers and nothing else",
                    static_cast<long long>(text.line()));
        if (between.has_decimal_comma())
            fail_at(Status::bad_format, text.line(),
                    "line %lld has decimal commas; write decimal points",
                    static_cast<long long>(text.line()));
        if (columns == 0) columns = count;
        if (count != columns)
            fail_at(Status::bad_format, text.line(),
                    "line %lld has %d numbers, those before it have %d",
                    static_cast<long long>(text.line()), count, columns);
        positions.insert(positions.end(), values, values + 3);
        if (columns != 6 && columns != 7 && columns != 9 && columns != 10) continue;
        const double* color = values + (columns == 10 ? 6 : columns - 3);
        evidence.add(color);
        for (int k = 0; k < 3; ++k) colors.push_back(static_cast<float>(color[k]));
    }
    if (positions.empty())
        fail(Status::bad_format, "no points: an XYZ file has three numbers a line");
    TriMesh mesh;
    mesh.vertices =
        Eigen::Map<const Points>(positions.data(), static_cast<Index>(positions.size() / 3), 3);
    if (!colors.empty() && evidence.is_color()) mesh.colors = colors_from_numbers(colors);
    return mesh;
}

}  // namespace mien::formats
