#include "mesh/zone_file.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json_text.hpp"
#include "base/json_value.hpp"

namespace mien {
namespace {

bool is_vertex_list(const JsonValue& list) {
    if (!list.is(JsonValue::Kind::array)) return false;
    for (const JsonValue& value : list.items)
        if (!value.is(JsonValue::Kind::number)) return false;
    return true;
}

Zone read_zone(const std::string& name, const JsonValue& list, const std::string& path) {
    if (!list.is(JsonValue::Kind::array))
        fail(Status::bad_format, "%s: zone '%s' is not a list of vertices",
             shown_path(path).c_str(), shown_name(name).c_str());
    Zone zone;
    zone.name = name;
    zone.vertices.reserve(list.items.size());
    for (const JsonValue& value : list.items) {
        if (!value.is(JsonValue::Kind::number) || !(value.number >= 0) ||
            value.number > 4294967295.0 || value.number != std::floor(value.number))
            fail_at(Status::bad_format, static_cast<std::int64_t>(zone.vertices.size()),
                    "%s: zone '%s' holds what is no vertex number, at entry %zu",
                    shown_path(path).c_str(), shown_name(name).c_str(), zone.vertices.size());
        zone.vertices.push_back(static_cast<std::uint32_t>(value.number));
    }
    return zone;
}

}  // namespace

std::vector<Zone> parse_zones(const char* data, std::size_t size, const std::string& path) {
    const JsonValue root = parse_json_value(data, size, shown_path(path).c_str());
    const JsonValue* listed = root.find("zones");
    if (listed == nullptr || !listed->is(JsonValue::Kind::object))
        fail(Status::bad_format, "%s: expected {\"zones\": {name: [vertex, ...]}}",
             shown_path(path).c_str());
    std::vector<Zone> zones;
    const auto known = [&](const std::string& name) {
        for (const Zone& zone : zones)
            if (zone.name == name) return true;
        return false;
    };
    for (std::size_t i = 0; i < listed->items.size(); ++i) {
        if (known(listed->keys[i]))
            fail(Status::invalid_argument, "%s: the zone '%s' stands there twice",
                 shown_path(path).c_str(), shown_name(listed->keys[i]).c_str());
        zones.push_back(read_zone(listed->keys[i], listed->items[i], path));
    }
    for (std::size_t i = 0; i < root.items.size(); ++i)
        if (root.keys[i] != "zones" && is_vertex_list(root.items[i]) && !known(root.keys[i]))
            zones.push_back(read_zone(root.keys[i], root.items[i], path));
    return zones;
}

std::vector<Zone> read_zone_file(const std::string& path, const Context& context) {
    const FileBytes bytes = read_whole_file(path, context);
    return parse_zones(bytes.data, bytes.size, path);
}

void write_zone_file(const std::string& path, const std::vector<Zone>& zones) {
    JsonText json;
    json.begin_object().key("zones").begin_object();
    for (const Zone& zone : zones) json.field(zone.name, zone.vertices);
    AtomicFile file(path);
    file.write(json.end_object().end_object().take() + "\n");
    file.commit();
}

}  // namespace mien
