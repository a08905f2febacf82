#include "model/model_json.hpp"

#include <charconv>
#include <cmath>

#include "base/json_text.hpp"

namespace mien {
bool read_info_number(const std::string& text, double& value) {
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() &&
           std::isfinite(value);
}

std::string model_json(const DeformationModel& model) {
    JsonText json;
    json.begin_object()
        .field("vertices", model.num_vertices())
        .field("triangles", model.template_mesh.triangles.rows())
        .field("scalar_modes", model.basis.cols)
        .field("deformation_modes", 3 * model.basis.cols)
        .field("pca_modes", model.pca_modes.cols);
    json.key("landmarks").begin_object();
    for (const Landmark& landmark : model.landmarks) json.field(landmark.name, landmark.vertex);
    json.end_object().key("zones").begin_object();
    for (const Zone& zone : model.zones) json.field(zone.name, zone.vertices.size());
    json.end_object().key("info").begin_object();
    for (const auto& [key, value] : model.info) {
        double number = 0;
        if (read_info_number(value, number))
            json.field(key, number);
        else
            json.field(key, value);
    }
    return json.end_object().end_object().take();
}

}  // namespace mien
