#include "mesh/landmark_file.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "mesh/text_cursor.hpp"

namespace mien {
namespace landmark_formats {

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

double unit_of_name(const std::string& name) {
    struct Unit {
        const char* name;
        double to_mm;
    };
    static constexpr Unit kUnits[] = {
        {"mm", 1},          {"millimeter", 1},  {"millimetre", 1},  {"millimeters", 1},
        {"millimetres", 1}, {"cm", 10},         {"centimeter", 10}, {"centimetre", 10},
        {"dm", 100},        {"decimeter", 100}, {"decimetre", 100}, {"m", 1000},
        {"meter", 1000},    {"metre", 1000},    {"meters", 1000},   {"metres", 1000},
        {"km", 1e6},        {"in", 25.4},       {"inch", 25.4},     {"inches", 25.4},
        {"ft", 304.8},      {"foot", 304.8},    {"feet", 304.8},    {"um", 1e-3},
    };
    const std::string wanted = lower(name);
    for (const Unit& unit : kUnits)
        if (wanted == unit.name) return unit.to_mm;
    return 0;
}

}  // namespace landmark_formats

namespace {

void check_names(const std::vector<Mark>& marks, const std::string& path) {
    std::set<std::string> seen;
    for (const Mark& mark : marks)
        if (!seen.insert(mark.name).second)
            fail(Status::invalid_argument,
                 "%s: the landmark '%s' stands there twice; keep one of them",
                 shown_path(path).c_str(), shown_name(mark.name).c_str());
}

}  // namespace

std::size_t drop_placeholders(std::vector<Mark>& marks) {
    // Places that people pick never agree to the last bit, except where two names mean one place.
    // So three alike are no picks, and neither are two on a diagonal point such as 0 0 0.
    std::map<std::tuple<double, double, double>, std::size_t> counts;
    const auto key = [](const Mark& mark) {
        return std::make_tuple(mark.point[0] + 0.0, mark.point[1] + 0.0, mark.point[2] + 0.0);
    };
    for (const Mark& mark : marks)
        if (mark.where == Mark::Where::place) ++counts[key(mark)];
    std::size_t dropped = 0;
    for (Mark& mark : marks) {
        if (mark.where != Mark::Where::place) continue;
        const std::size_t alike = counts[key(mark)];
        const bool diagonal = std::abs(mark.point[0]) == std::abs(mark.point[1]) &&
                              std::abs(mark.point[1]) == std::abs(mark.point[2]);
        if (alike < 2 || (alike < 3 && !diagonal)) continue;
        mark.where = Mark::Where::not_picked;
        mark.point.setZero();
        ++dropped;
    }
    return dropped;
}

LandmarkFile parse_landmarks(const char* data, std::size_t size, const std::string& path) {
    using namespace landmark_formats;
    if (size >= 3 && std::memcmp(data, "\xef\xbb\xbf", 3) == 0) data += 3, size -= 3;
    const char* first = data;
    while (first != data + size && static_cast<unsigned char>(*first) <= ' ') ++first;
    const std::size_t rest = static_cast<std::size_t>(data + size - first);
    const std::string name = lower(path);
    if (rest == 0) fail(Status::bad_format, "%s: is empty", shown_path(path).c_str());
    if (std::memchr(data, '\0', size) != nullptr)
        fail(Status::bad_format, "%s: is no text, so no landmark file; save it as UTF-8",
             shown_path(path).c_str());
    LandmarkFile file;
    // A .pts file of iBUG has a line "{" of its own, but never at its beginning.
    if (*first == '{' || *first == '[')
        file = read_json(first, rest, path);
    else if (*first == '<')
        file = read_picked_points(first, rest, path);
    else if (ends_with(name, ".fcsv") ||
             (*first == '#' &&
              std::string(first, std::min<std::size_t>(rest, 200)).find("Markups fiducial") !=
                  std::string::npos))
        file = read_fiducial_csv(first, rest, path);
    else
        file = read_table(first, rest, path, ends_with(name, ".pts") ? "pts" : "csv");
    if (file.marks.empty())
        fail(Status::bad_format, "%s: holds no landmarks", shown_path(path).c_str());
    drop_placeholders(file.marks);
    check_names(file.marks, path);
    return file;
}

LandmarkFile read_landmark_file(const std::string& path, const Context& context) {
    const FileBytes bytes = read_whole_file(path, context);
    return parse_landmarks(bytes.data, bytes.size, path);
}

}  // namespace mien
