#include "model/model_json.hpp"

#include <charconv>
#include <cmath>

#include "base/json.hpp"
#include "model/model_builder.hpp"

namespace mien {
namespace {

/// Plain JSON numbers only: no "inf", no hexadecimal, no text around.
bool read_number(const std::string& text, double& value) {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() &&
           std::isfinite(value);
}

void append_key(std::string& json, const char* separator, const std::string& key) {
    json += separator;
    append_json_string(json, key);
    json += ": ";
}

}  // namespace

void append_json_number(std::string& json, double value) {
    json += std::isfinite(value) ? info_number(value) : "null";
}

std::string model_json(const DeformationModel& model) {
    std::string json = "{";
    const auto count = [&](const char* key, Index value) {
        append_key(json, json.size() == 1 ? "" : ", ", key);
        json += std::to_string(value);
    };
    count("vertices", model.num_vertices());
    count("triangles", model.template_mesh.triangles.rows());
    count("scalar_modes", model.basis.cols);
    count("deformation_modes", 3 * model.basis.cols);
    count("pca_modes", model.pca_modes.cols);
    json += ", \"landmarks\": {";
    for (std::size_t i = 0; i < model.landmarks.size(); ++i) {
        append_key(json, i == 0 ? "" : ", ", model.landmarks[i].name);
        json += std::to_string(model.landmarks[i].vertex);
    }
    json += "}, \"zones\": {";
    for (std::size_t i = 0; i < model.zones.size(); ++i) {
        append_key(json, i == 0 ? "" : ", ", model.zones[i].name);
        json += std::to_string(model.zones[i].vertices.size());
    }
    json += "}, \"info\": {";
    bool first = true;
    for (const auto& [key, value] : model.info) {
        append_key(json, first ? "" : ", ", key);
        first = false;
        double number = 0;
        if (read_number(value, number))
            json += info_number(number);
        else
            append_json_string(json, value);
    }
    return json + "}}";
}

}  // namespace mien
