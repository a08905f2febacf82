// Landmarks in plain text: MeshLab's picked points, Slicer's fiducials, tables of names and
// numbers.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "mesh/landmark_file.hpp"

namespace mien::landmark_formats {
namespace {

[[noreturn]] void fail_line(const std::string& path, std::size_t line, const char* what) {
    fail_at(Status::bad_format, static_cast<std::int64_t>(line), "%s: line %zu: %s",
            shown_path(path).c_str(), line, what);
}

std::string trimmed(const std::string& text) {
    const char* blanks = " \t\r\n\v\f";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos
               ? std::string()
               : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A number, or NaN for the words that mean "not picked". False for anything else.
bool read_number(std::string text, bool decimal_comma, double& value) {
    text = lower(trimmed(text));
    if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
    if (means_not_picked(text)) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
    const char* end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(begin, end, value);
    if (result.ec == std::errc::result_out_of_range)
        value = std::numeric_limits<double>::quiet_NaN();
    return result.ec != std::errc::invalid_argument && result.ptr == end;
}

void set_place(const double (&xyz)[3], Mark& mark) {
    if (!std::isfinite(xyz[0]) || !std::isfinite(xyz[1]) || !std::isfinite(xyz[2])) return;
    mark.point = Vector3(xyz[0], xyz[1], xyz[2]);
    mark.where = Mark::Where::place;
}

/// Lines with any of the three line ends.
std::vector<std::string> lines_of(const char* data, std::size_t size) {
    std::vector<std::string> lines(1);
    for (std::size_t i = 0; i < size; ++i) {
        if (data[i] == '\r' && i + 1 < size && data[i + 1] == '\n') continue;
        if (data[i] == '\n' || data[i] == '\r')
            lines.emplace_back();
        else
            lines.back() += data[i];
    }
    return lines;
}

/// Fields of a line; a separator of ' ' means any run of blanks. "..." keeps separators.
std::vector<std::string> fields_of(const std::string& line, char separator) {
    std::vector<std::string> fields;
    std::string field;
    bool quoted = false, was_quoted = false;
    const auto end_field = [&] {
        if (separator != ' ' || !field.empty() || was_quoted)
            fields.push_back(was_quoted ? field : trimmed(field));
        field.clear();
        was_quoted = false;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"')
                field += line[++i];
            else
                quoted = !quoted, was_quoted = true;
        } else if (!quoted && (c == separator || (separator == ' ' && c == '\t'))) {
            end_field();
        } else {
            field += c;
        }
    }
    end_field();
    return fields;
}

/// Where a table keeps what; -1: nowhere.
struct Columns {
    int name = -1, x = -1, y = -1, z = -1, vertex = -1, status = -1;
    bool has_place() const { return x >= 0 && y >= 0 && z >= 0; }
};

/// "x", "x_mm", "x (mm)", "pos.x" -> the axis and perhaps a unit.
bool axis_of(const std::string& title, char axis, double& unit) {
    const std::string text = lower(title);
    if (text.empty()) return false;
    if (text[0] != axis)
        return text.size() >= 2 && text.back() == axis && text.find(' ') == std::string::npos &&
               (text[text.size() - 2] == '.' || text[text.size() - 2] == '_');
    if (text.size() == 1) return true;
    std::string rest;
    for (const char c : text.substr(1))
        if (c >= 'a' && c <= 'z') rest += c;
    if (rest.empty()) return text[1] < '0' || text[1] > '9';
    const double told = unit_of_name(rest);
    if (told == 0) return false;
    unit = told;
    return true;
}

/// The titles of a table's first line; nothing found when it is no title line.
Columns read_titles(const std::vector<std::string>& titles, double& unit) {
    Columns columns;
    for (int i = 0; i < static_cast<int>(titles.size()); ++i) {
        const std::string title = lower(titles[static_cast<std::size_t>(i)]);
        if (columns.x < 0 && axis_of(title, 'x', unit))
            columns.x = i;
        else if (columns.y < 0 && axis_of(title, 'y', unit))
            columns.y = i;
        else if (columns.z < 0 && axis_of(title, 'z', unit))
            columns.z = i;
        else if (title == "vertex" || title == "index" || title == "vertex_index")
            columns.vertex = i;
        else if (title == "label" || title == "name" || title == "landmark" || title == "point")
            columns.name = i;
        else if (title == "id" && columns.name < 0)
            columns.name = i;
        else if (title == "positionstatus" || title == "status")
            columns.status = i;
    }
    return columns;
}

/// iBUG's header lines and Landmark's first lines; the number of points is remembered.
bool is_header(const std::vector<std::string>& fields, double& promised) {
    const std::string first = lower(fields[0]);
    if (first.compare(0, 8, "n_points") == 0) {
        read_number(fields.back().substr(fields.back().find(':') + 1), false, promised);
        return true;
    }
    return first == "{" || first == "}" || first.compare(0, 7, "version") == 0;
}

/// More columns than titles, or than name,x,y,z can need: decimal commas between commas.
void check_columns(const std::vector<std::string>& fields, std::size_t titles, char separator,
                   const std::string& path, std::size_t line) {
    std::size_t count = fields.size();
    while (count > 0 && fields[count - 1].empty()) --count;
    bool decimal_points = false;
    for (const std::string& field : fields)
        decimal_points = decimal_points || field.find('.') != std::string::npos;
    if (titles > 0 ? count > titles : separator == ',' && count >= 7 && !decimal_points)
        fail_line(
            path, line,
            "has more columns than the table; write decimal points, or put ; between columns");
}

/// Columns of a table without titles, by its first line of data.
Columns guess_columns(const std::vector<std::string>& fields, bool decimal_comma,
                      const std::string& path, std::size_t line) {
    double number = 0;
    const bool named = !read_number(fields[0], decimal_comma, number);
    Columns columns;
    const int n = static_cast<int>(fields.size());
    if (n == 1 && !named) {
        columns.vertex = 0;
    } else if (n == 2 && named) {
        columns.name = 0, columns.vertex = 1;
    } else if (n == 2) {
        fail_line(path, line, "holds points of an image (x, y), not of a scan (x, y, z)");
    } else if (n == 3 && !named) {
        columns.x = 0, columns.y = 1, columns.z = 2;
    } else if (n >= 4) {
        columns.name = 0, columns.x = 1, columns.y = 2, columns.z = 3;
    } else {
        fail_line(path, line, "expected name,x,y,z or x y z or name,vertex");
    }
    return columns;
}

char separator_of(const std::string& line) {
    for (const char candidate : {';', '\t', ','})
        if (line.find(candidate) != std::string::npos) return candidate;
    return ' ';
}

Mark read_row(const std::vector<std::string>& fields, const Columns& columns, bool decimal_comma,
              std::size_t number, const std::string& path, std::size_t line) {
    const auto field = [&](int column) -> std::string {
        const auto i = static_cast<std::size_t>(column);
        return column >= 0 && i < fields.size() ? fields[i] : std::string();
    };
    Mark mark;
    mark.name = field(columns.name);
    if (mark.name.empty()) mark.name = std::to_string(number);
    const std::string status = lower(field(columns.status));
    const bool defined = status.empty() || status == "defined" || status == "2";
    if (columns.has_place()) {
        double xyz[3];
        const int axes[3] = {columns.x, columns.y, columns.z};
        int missing = 0;
        for (int k = 0; k < 3; ++k) {
            if (!read_number(field(axes[k]), decimal_comma, xyz[k]))
                fail_line(path, line, "a coordinate is no number");
            missing += field(axes[k]).empty();
        }
        if (missing == 1 || missing == 2) fail_line(path, line, "a landmark has no x, y and z");
        if (defined) set_place(xyz, mark);
        return mark;
    }
    double vertex = 0;
    if (!read_number(field(columns.vertex), decimal_comma, vertex) || vertex > 4294967295.0 ||
        (vertex < 0 && vertex != -1) || (std::isfinite(vertex) && vertex != std::floor(vertex)))
        fail_line(path, line, "expected a vertex number");
    if (vertex >= 0 && defined) {
        mark.vertex = static_cast<std::uint32_t>(vertex);
        mark.where = Mark::Where::vertex;
    }
    return mark;
}

/// The value of an attribute of an XML element, entities resolved; false when it has none.
bool attribute(const std::string& element, const char* name, std::string& value) {
    const std::string wanted = name;
    for (std::size_t at = 0; (at = element.find(wanted, at)) != std::string::npos; ++at) {
        const bool begins = at > 0 && static_cast<unsigned char>(element[at - 1]) <= ' ';
        std::size_t i = at + wanted.size();
        while (i < element.size() && static_cast<unsigned char>(element[i]) <= ' ') ++i;
        if (!begins || i >= element.size() || element[i] != '=') continue;
        ++i;
        while (i < element.size() && static_cast<unsigned char>(element[i]) <= ' ') ++i;
        if (i >= element.size() || (element[i] != '"' && element[i] != '\'')) continue;
        const std::size_t end = element.find(element[i], i + 1);
        if (end == std::string::npos) return false;
        value = element.substr(i + 1, end - i - 1);
        static constexpr const char* kEntities[][2] = {
            {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}};
        for (const auto& entity : kEntities)
            for (std::size_t p = 0; (p = value.find(entity[0], p)) != std::string::npos; ++p)
                value.replace(p, std::string(entity[0]).size(), entity[1]);
        return true;
    }
    return false;
}

}  // namespace

bool means_not_picked(const std::string& given) {
    const std::string text = lower(given);
    static constexpr const char* kNothing[] = {
        "",        "-",           "?",          "na",         "n/a",      "#n/a",
        "nan",     "-nan",        "null",       "none",       "nil",      "undefined",
        "missing", "not defined", "notdefined", "not picked", "notpicked"};
    for (const char* word : kNothing)
        if (text == word) return true;
    // Windows programs write -1.#IND, 1.#QNAN, 1.#INF; others nan(ind), inf.
    return text.find("#ind") != std::string::npos || text.find("#qnan") != std::string::npos ||
           text.find("#inf") != std::string::npos || text.compare(0, 4, "nan(") == 0 ||
           text.compare(0, 5, "-nan(") == 0;
}

LandmarkFile read_picked_points(const char* data, std::size_t size, const std::string& path) {
    LandmarkFile file;
    file.format = "pp";
    const std::string text(data, size);
    if (text.find("<PickedPoints") == std::string::npos)
        fail(Status::bad_format, "%s: is XML, but not MeshLab's PickedPoints",
             shown_path(path).c_str());
    if (text.find("</PickedPoints") == std::string::npos)
        fail(Status::bad_format, "%s: does not end with </PickedPoints>: it was cut short",
             shown_path(path).c_str());
    for (std::size_t at = 0; (at = text.find("<point", at)) != std::string::npos;) {
        const std::size_t end = text.find('>', at);
        const std::size_t line =
            1 + static_cast<std::size_t>(
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        if (end == std::string::npos) fail_line(path, line, "the element <point> does not end");
        const std::string element = text.substr(at, end - at);
        at = end;
        if (element.size() <= 6 || static_cast<unsigned char>(element[6]) > ' ') continue;
        Mark mark;
        double xyz[3];
        static constexpr const char* kAxes[] = {"x", "y", "z"};
        for (int k = 0; k < 3; ++k) {
            std::string value;
            if (!attribute(element, kAxes[k], value) || !read_number(value, false, xyz[k]))
                fail_line(path, line, "a point has no x, y and z");
        }
        std::string active;
        if (!attribute(element, "name", mark.name) || mark.name.empty())
            mark.name = std::to_string(file.marks.size() + 1);
        if (!attribute(element, "active", active) || (active != "0" && lower(active) != "false"))
            set_place(xyz, mark);
        file.marks.push_back(std::move(mark));
    }
    return file;
}

LandmarkFile read_fiducial_csv(const char* data, std::size_t size, const std::string& path) {
    LandmarkFile file;
    file.format = "fcsv";
    file.system = "RAS";
    Columns columns;
    columns.name = 11, columns.x = 1, columns.y = 2, columns.z = 3, columns.status = 14;
    std::size_t number = 0;
    for (const std::string& line : lines_of(data, size)) {
        ++number;
        if (trimmed(line).empty()) continue;
        if (line[0] == '#') {
            const std::size_t equals = line.find('=');
            if (equals == std::string::npos) continue;
            const std::string key = lower(trimmed(line.substr(1, equals - 1)));
            const std::string value = trimmed(line.substr(equals + 1));
            if (key == "coordinatesystem") {
                if (value == "0" || value == "RAS")
                    file.system = "RAS";
                else if (value == "1" || value == "LPS")
                    file.system = "LPS";
                else
                    fail_line(path, number, "the coordinate system is neither LPS nor RAS");
            } else if (key == "columns") {
                columns = read_titles(fields_of(value, ','), file.unit_to_mm);
                if (!columns.has_place()) fail_line(path, number, "no columns x, y and z");
            }
            continue;
        }
        Mark mark =
            read_row(fields_of(line, ','), columns, false, file.marks.size() + 1, path, number);
        if (file.system == "RAS") mark.point.head<2>() *= -1;
        file.marks.push_back(std::move(mark));
    }
    return file;
}

LandmarkFile read_table(const char* data, std::size_t size, const std::string& path,
                        const char* format) {
    LandmarkFile file;
    file.format = format;
    Columns columns;
    bool known = false;
    const std::vector<std::string> lines = lines_of(data, size);
    std::size_t number = 0, rows = 0, titles = 0;
    double promised = -1;
    for (const std::string& raw : lines) {
        ++number;
        const std::string line = trimmed(raw);
        if (line.empty() || line[0] == '#') continue;
        const char separator = separator_of(line);
        const bool decimal_comma = separator == ';' || separator == '\t';
        const std::vector<std::string> fields = fields_of(line, separator);
        if (fields.empty() || is_header(fields, promised)) continue;
        if (!known) {
            columns = read_titles(fields, file.unit_to_mm);
            known = true;
            if (columns.has_place() || (columns.name >= 0 && columns.vertex >= 0)) {
                titles = fields.size();
                continue;
            }
            if (fields.size() == 1 && std::string(format) == "pts") {  // the number of points
                known = false;
                read_number(fields[0], false, promised);
                continue;
            }
            columns = guess_columns(fields, decimal_comma, path, number);
        }
        check_columns(fields, titles, separator, path, number);
        file.marks.push_back(read_row(fields, columns, decimal_comma, ++rows, path, number));
    }
    if (promised >= 0 && promised != static_cast<double>(rows))
        fail(Status::bad_format, "%s: promises %.0f points and holds %zu", shown_path(path).c_str(),
             promised, rows);
    return file;
}

}  // namespace mien::landmark_formats
