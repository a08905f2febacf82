// Landmark files as other programs read them.
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json_text.hpp"
#include "mesh/landmark_file.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/text_cursor.hpp"

namespace mien {
namespace {

std::string digits(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, value + 0.0).ptr);
}

std::string place_of(const Mark& mark, const char* between) {
    return digits(mark.point[0]) + between + digits(mark.point[1]) + between +
           digits(mark.point[2]);
}

bool picked(const Mark& mark) {
    return mark.where == Mark::Where::place;
}

/// "cm", or empty for a unit that is not told.
std::string unit_name(const LandmarkFile& file) {
    for (const LengthUnit& unit : length_units())
        if (unit.to_mm == file.unit_to_mm) return unit.name;
    return std::string();
}

LandmarkFile in_mm(LandmarkFile file) {
    if (file.unit_to_mm == 0) return file;
    for (Mark& mark : file.marks) mark.point *= file.unit_to_mm;
    file.unit_to_mm = 1;
    return file;
}

void put_place(JsonText& json, const Mark& mark) {
    if (!picked(mark)) {
        json.null();
        return;
    }
    json.begin_array();
    for (int k = 0; k < 3; ++k) json.number(mark.point[k] + 0.0);
    json.end_array();
}

std::string own_json(const LandmarkFile& file, bool vertices) {
    JsonText json;
    json.begin_object();
    const std::string unit = unit_name(file);
    if (!unit.empty()) json.field("unit", unit);
    json.key(vertices ? "vertices" : "points").begin_object();
    for (const Mark& mark : file.marks) {
        json.key(mark.name);
        if (!vertices)
            put_place(json, mark);
        else if (mark.where == Mark::Where::vertex)
            json.integer(mark.vertex);
        else
            json.null();
    }
    return json.end_object().end_object().take() + "\n";
}

std::string markups_json(const LandmarkFile& file) {
    JsonText json;
    json.begin_object().key("markups").begin_array().begin_object();
    json.field("type", std::string("Fiducial")).field("coordinateSystem", std::string("LPS"));
    const std::string unit = unit_name(file);
    if (!unit.empty()) json.field("coordinateUnits", unit);
    json.key("controlPoints").begin_array();
    std::int64_t number = 0;
    for (const Mark& mark : file.marks) {
        json.begin_object()
            .field("id", std::to_string(++number))
            .field("label", mark.name)
            .key("position")
            .begin_array();
        for (int k = 0; k < 3; ++k) json.number(mark.point[k] + 0.0);
        json.end_array()
            .field("positionStatus", std::string(picked(mark) ? "defined" : "undefined"))
            .end_object();
    }
    return json.end_array().end_object().end_array().end_object().take() + "\n";
}

std::string menpo_json(const LandmarkFile& file) {
    JsonText json;
    json.begin_object().field("version", 2).key("labels").begin_array();
    std::int64_t number = 0;
    for (const Mark& mark : file.marks) {
        json.begin_object().field("label", mark.name).key("mask").begin_array();
        json.integer(number++).end_array().end_object();
    }
    json.end_array().key("landmarks").begin_object().key("points").begin_array();
    for (const Mark& mark : file.marks) {
        json.begin_array();
        for (int k = 0; k < 3; ++k)
            if (picked(mark))
                json.number(mark.point[k] + 0.0);
            else
                json.null();
        json.end_array();
    }
    return json.end_array().end_object().end_object().take() + "\n";
}

std::string xml_text(const std::string& text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '&':
                out += "&amp;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

std::string picked_points(const LandmarkFile& file) {
    std::string text = "<!DOCTYPE PickedPoints>\n<PickedPoints>\n";
    for (const Mark& mark : file.marks)
        text += " <point x=\"" + digits(mark.point[0]) + "\" y=\"" + digits(mark.point[1]) +
                "\" z=\"" + digits(mark.point[2]) + "\" active=\"" + (picked(mark) ? "1" : "0") +
                "\" name=\"" + xml_text(mark.name) + "\"/>\n";
    return text + "</PickedPoints>\n";
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\";\n\r\t") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

std::string table(const LandmarkFile& file, bool vertices) {
    const std::string name = unit_name(file), unit = name.empty() ? name : "_" + name;
    std::string text =
        vertices ? "name,vertex\n" : "name,x" + unit + ",y" + unit + ",z" + unit + "\n";
    for (const Mark& mark : file.marks) {
        text += csv_field(mark.name) + ",";
        if (vertices)
            text += mark.where == Mark::Where::vertex ? std::to_string(mark.vertex) : "";
        else
            text += picked(mark) ? place_of(mark, ",") : ",,";
        text += "\n";
    }
    return text;
}

std::string fiducials(const LandmarkFile& file) {
    std::string text =
        "# Markups fiducial file version = 5.0\n# CoordinateSystem = LPS\n"
        "# columns = id,x,y,z,label,positionStatus\n";
    std::size_t number = 0;
    for (const Mark& mark : file.marks)
        text += std::to_string(++number) + "," + place_of(mark, ",") + "," + csv_field(mark.name) +
                "," + (picked(mark) ? "2" : "0") + "\n";
    return text;
}

std::string points_text(const LandmarkFile& file) {
    std::string text = "version: 1\nn_points: " + std::to_string(file.marks.size()) + "\n{\n";
    for (const Mark& mark : file.marks)
        text += picked(mark) ? place_of(mark, " ") + "\n" : std::string("nan nan nan\n");
    return text + "}\n";
}

}  // namespace

void write_landmark_file(const std::string& path, const LandmarkFile& given) {
    const std::string name = landmark_formats::lower(path);
    // Slicer takes fiducials for mm; a unit without a name can be told nowhere.
    const bool to_mm = ends_with(name, ".fcsv") || unit_name(given).empty();
    const LandmarkFile file = to_mm ? in_mm(given) : given;
    bool vertices = false, places = false;
    for (const Mark& mark : file.marks) {
        vertices = vertices || mark.where == Mark::Where::vertex;
        places = places || mark.where == Mark::Where::place;
    }
    if (vertices && places)
        fail(Status::invalid_argument,
             "%s: some landmarks are places and some vertex numbers; write them to two files",
             shown_path(path).c_str());
    const bool markups = ends_with(name, ".mrk.json"), json = ends_with(name, ".json"),
               csv = ends_with(name, ".csv");
    if (vertices && (markups || !(json || csv)))
        fail(Status::invalid_argument,
             "%s: this format holds places, and the landmarks are vertex numbers; give the mesh "
             "that they belong to, or write .json or .csv",
             shown_path(path).c_str());
    std::string text;
    if (markups)
        text = markups_json(file);
    else if (json)
        text = own_json(file, vertices);
    else if (csv)
        text = table(file, vertices);
    else if (ends_with(name, ".ljson"))
        text = menpo_json(file);
    else if (ends_with(name, ".fcsv"))
        text = fiducials(file);
    else if (ends_with(name, ".pp"))
        text = picked_points(file);
    else if (ends_with(name, ".pts"))
        text = points_text(file);
    else
        fail(Status::bad_format,
             "%s: unknown kind of landmark file; use .json, .mrk.json, .fcsv, .pp, .pts, .ljson or "
             ".csv",
             shown_path(path).c_str());
    AtomicFile out(path);
    out.write(text);
    out.commit();
}

}  // namespace mien
