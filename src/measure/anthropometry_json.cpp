// Anthropometric measurements as JSON text.
#include "base/json_text.hpp"
#include "measure/norms.hpp"

namespace mien {
namespace {

const char* kind_name(AnthropometricKind kind) {
    switch (kind) {
        case AnthropometricKind::length:
            return "length";
        case AnthropometricKind::surface_length:
            return "surface length";
        case AnthropometricKind::angle:
            return "angle";
        case AnthropometricKind::inclination:
            return "inclination";
        case AnthropometricKind::proportion:
            return "proportion";
        case AnthropometricKind::line_offset:
            return "distance from a line";
    }
    return "";
}

void write_value(JsonText& json, const AnthropometricValue& value, const NormSet* norms) {
    const AnthropometricDefinition& definition = *value.definition;
    json.begin_object();
    json.field("name", definition.name);
    json.field("title", definition.title);
    json.field("kind", kind_name(definition.kind));
    json.field("unit", unit_of(definition.kind));
    json.key("landmarks").begin_array();
    for (int k = 0; k < mark_count(definition.kind); ++k)
        json.string(definition.marks[static_cast<std::size_t>(k)]);
    json.end_array();
    json.field("source", definition.source);
    json.field("value", value.value);
    json.field("sd", value.sd);
    if (!value.reason.empty()) json.field("reason", value.reason);
    if (norms != nullptr) {
        const NormScore score = score_against(norms, value);
        json.field("z", score.z);
        json.field("z_sd", score.sd);
        json.field("norm_mean", score.mean);
        json.field("norm_sd", score.population_sd);
        json.field("norm_people", static_cast<std::int64_t>(score.people));
    }
    json.end_object();
}

}  // namespace

std::string anthropometry_json(const std::vector<AnthropometricValue>& values,
                               const std::vector<FacePlace>& places, const NormSet* norms) {
    JsonText json;
    json.begin_object().key("anthropometry").begin_object();
    json.key("measurements").begin_array();
    for (const AnthropometricValue& value : values) write_value(json, value, norms);
    json.end_array();
    json.key("landmarks").begin_object();
    const std::vector<AnatomicalPlace> found = find_anatomical_places(places);
    for (std::size_t k = 0; k < found.size(); ++k)
        if (!found[k].places.empty()) json.field(anatomical_landmarks()[k].name, found[k].from);
    json.end_object().end_object().end_object();
    return json.take();
}

}  // namespace mien
