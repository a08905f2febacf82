// Landmarks in JSON: the project's own, 3D Slicer's markups, menpo's ljson.
#include <cmath>
#include <initializer_list>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "base/json_value.hpp"
#include "mesh/landmark_file.hpp"

namespace mien::landmark_formats {
namespace {

using Kind = JsonValue::Kind;

/// [x, y, z] with numbers or nulls; null or [] alone, and a null or "NaN" among them, mean not
/// picked.
void read_place(const JsonValue& value, const std::string& path, Mark& mark) {
    if (value.is(Kind::null) || (value.is(Kind::array) && value.items.empty())) return;
    if (!value.is(Kind::array) || value.items.size() != 3)
        fail(Status::bad_format, "%s: landmark '%s' is not [x, y, z]", shown_path(path).c_str(),
             shown_name(mark.name).c_str());
    bool picked = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const JsonValue& one = value.items[k];
        const bool nothing =
            one.is(Kind::null) || (one.is(Kind::string) && means_not_picked(one.text));
        if (!one.is(Kind::number) && !nothing)
            fail(Status::bad_format, "%s: landmark '%s' has a coordinate that is no number",
                 shown_path(path).c_str(), shown_name(mark.name).c_str());
        picked = picked && one.is(Kind::number) && std::isfinite(one.number);
        if (!nothing) mark.point[static_cast<Index>(k)] = one.number;
    }
    if (picked)
        mark.where = Mark::Where::place;
    else
        mark.point.setZero();
}

void read_vertex(const JsonValue& value, const std::string& path, Mark& mark) {
    if (value.is(Kind::null)) return;
    if (value.is(Kind::number) && value.number == -1) return;  // "no vertex" of many programs
    if (!value.is(Kind::number) || !(value.number >= 0) || value.number > 4294967295.0 ||
        value.number != std::floor(value.number))
        fail(Status::bad_format, "%s: landmark '%s' is not a vertex number",
             shown_path(path).c_str(), shown_name(mark.name).c_str());
    mark.vertex = static_cast<std::uint32_t>(value.number);
    mark.where = Mark::Where::vertex;
}

/// An object {name: value}, or a list whose entries get their numbers as names.
template <typename Read>
void read_named(const JsonValue& list, const std::string& path, const char* shape, Read read,
                LandmarkFile& file) {
    if (!list.is(Kind::object) && !list.is(Kind::array))
        fail(Status::bad_format, "%s: expected %s", shown_path(path).c_str(), shape);
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        Mark mark;
        mark.name = list.is(Kind::object) ? list.keys[i] : std::to_string(i + 1);
        read(list.items[i], path, mark);
        file.marks.push_back(std::move(mark));
    }
}

/// mm per unit of the first of these keys that holds a name; 0 when none does.
double told_unit(const JsonValue& holder, std::initializer_list<const char*> keys,
                 const std::string& path) {
    const JsonValue* unit = nullptr;
    for (const char* key : keys)
        if (unit == nullptr) unit = holder.find(key);
    if (unit == nullptr || !unit->is(Kind::string) || unit->text.empty()) return 0;
    const double unit_to_mm = unit_of_name(unit->text);
    if (unit_to_mm == 0)
        fail(Status::bad_format, "%s: the unit '%s' is unknown; use mm, cm, dm, m, km, in or ft",
             shown_path(path).c_str(), shown_name(unit->text).c_str());
    return unit_to_mm;
}

// https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema
LandmarkFile read_markups(const JsonValue& markups, const std::string& path) {
    LandmarkFile file;
    file.format = "mrk.json";
    for (const JsonValue& list : markups.items) {
        const JsonValue* system = list.find("coordinateSystem");
        const std::string told = system == nullptr          ? "LPS"
                                 : system->is(Kind::string) ? system->text
                                 : system->number == 0      ? "RAS"
                                                            : "LPS";
        if (told != "LPS" && told != "RAS")
            fail(Status::bad_format, "%s: the coordinate system '%s' is neither LPS nor RAS",
                 shown_path(path).c_str(), shown_name(told).c_str());
        file.system = told;
        const double unit_to_mm = told_unit(list, {"coordinateUnits"}, path);
        if (!file.marks.empty() && unit_to_mm != file.unit_to_mm)
            fail(Status::bad_format,
                 "%s: its lists of points are in different units; bring them "
                 "to one",
                 shown_path(path).c_str());
        file.unit_to_mm = unit_to_mm;
        const JsonValue* points = list.find("controlPoints");
        if (points == nullptr || !points->is(Kind::array)) continue;
        for (const JsonValue& point : points->items) {
            Mark mark;
            const JsonValue* label = point.find("label");
            const JsonValue* status = point.find("positionStatus");
            const JsonValue* position = point.find("position");
            mark.name = label != nullptr && label->is(Kind::string) && !label->text.empty()
                            ? label->text
                            : std::to_string(file.marks.size() + 1);
            const bool defined =
                status == nullptr || (status->is(Kind::string) && lower(status->text) == "defined");
            if (defined && position != nullptr) read_place(*position, path, mark);
            if (told == "RAS") mark.point.head<2>() *= -1;
            file.marks.push_back(std::move(mark));
        }
    }
    return file;
}

/// "labels": [{"label": "chin", "mask": [8]}, ...] names a point where a label holds it alone.
void name_by_labels(const JsonValue* labels, std::vector<Mark>& marks) {
    if (labels == nullptr || !labels->is(Kind::array)) return;
    for (const JsonValue& label : labels->items) {
        const JsonValue *name = label.find("label"), *mask = label.find("mask");
        if (name == nullptr || !name->is(Kind::string) || name->text.empty() || mask == nullptr ||
            mask->items.size() != 1 || !mask->items[0].is(Kind::number))
            continue;
        const double number = mask->items[0].number;
        if (number >= 0 && number < static_cast<double>(marks.size()) && marks.size() > 1)
            marks[static_cast<std::size_t>(number)].name = name->text;
    }
}

// Version 1 groups points under labels, version 2 lists them, version 3 holds named groups of 2.
LandmarkFile read_ljson(const JsonValue& root, const std::string& path) {
    LandmarkFile file;
    file.format = "ljson";
    const JsonValue* holder = &root;
    if (const JsonValue* groups = root.find("groups")) {
        if (groups->is(Kind::array)) {
            for (const JsonValue& group : groups->items)
                if (const JsonValue* landmarks = group.find("landmarks"))
                    for (const JsonValue& landmark : landmarks->items) {
                        Mark mark;
                        mark.name = std::to_string(file.marks.size() + 1);
                        if (const JsonValue* point = landmark.find("point"))
                            read_place(*point, path, mark);
                        file.marks.push_back(std::move(mark));
                    }
            return file;
        }
        if (groups->items.size() != 1)
            fail(Status::bad_format, "%s: holds %zu groups of landmarks; keep one",
                 shown_path(path).c_str(), groups->items.size());
        holder = &groups->items[0];
    }
    const JsonValue* landmarks = holder->find("landmarks");
    const JsonValue* points = landmarks == nullptr ? nullptr : landmarks->find("points");
    if (points == nullptr)
        fail(Status::bad_format, "%s: holds no landmarks.points", shown_path(path).c_str());
    if (points->is(Kind::array) && !points->items.empty() && points->items[0].items.size() == 2)
        fail(Status::bad_format, "%s: holds points of an image (x, y), not of a scan (x, y, z)",
             shown_path(path).c_str());
    read_named(*points, path, "landmarks.points [[x, y, z], ...]", read_place, file);
    name_by_labels(holder->find("labels"), file.marks);
    return file;
}

}  // namespace

LandmarkFile read_json(const char* data, std::size_t size, const std::string& path) {
    const JsonValue root = parse_json_value(data, size, shown_path(path).c_str());
    if (const JsonValue* markups = root.find("markups")) return read_markups(*markups, path);
    if (root.find("groups") != nullptr || root.find("landmarks") != nullptr)
        return read_ljson(root, path);
    LandmarkFile file;
    file.format = "json";
    const JsonValue *points = root.find("points"), *vertices = root.find("vertices");
    if (points == nullptr && vertices == nullptr)
        fail(Status::bad_format,
             "%s: holds neither {\"points\": {name: [x, y, z]}} nor {\"vertices\": {name: index}} "
             "nor markups nor landmarks",
             shown_path(path).c_str());
    file.unit_to_mm = told_unit(root, {"unit", "units"}, path);
    if (points != nullptr)
        read_named(*points, path, "{\"points\": {name: [x, y, z]}}", read_place, file);
    else
        read_named(*vertices, path, "{\"vertices\": {name: vertex}}", read_vertex, file);
    return file;
}

}  // namespace mien::landmark_formats
