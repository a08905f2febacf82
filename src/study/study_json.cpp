#include "study/study_json.hpp"

#include "base/json_text.hpp"

namespace mien {
namespace {

void write_value(JsonText& json, const char* name, const StudyValue& value) {
    json.key(name).begin_object();
    json.field("value", value.value);
    json.field("sd", value.sd);
    json.field("low", value.low);
    json.field("high", value.high);
    json.field("limit_of_detection", value.limit_of_detection);
    json.end_object();
}

void write_change(JsonText& json, const std::string& name, const ZoneChange& change) {
    json.begin_object();
    json.field("name", name);
    write_value(json, "signed_ml", change.signed_ml);
    write_value(json, "gained_ml", change.gained_ml);
    write_value(json, "lost_ml", change.lost_ml);
    write_value(json, "absolute_ml", change.absolute_ml);
    write_value(json, "area_change_mm2", change.area_mm2);
    write_value(json, "mean_distance_mm", change.mean_distance_mm);
    json.key("sd_parts_ml").begin_object();
    json.field("surface", change.surface_sd_ml);
    json.field("alignment", change.alignment_sd_ml);
    json.field("bias", change.bias_sd_ml);
    json.field("expression", change.expression_sd_ml);
    json.end_object();
    json.field("expression_removed_ml", change.expression_removed_ml);
    json.field("seen_share", change.seen_share);
    json.field("area_before_mm2", change.area_before_mm2);
    json.field("area_after_mm2", change.area_after_mm2);
    json.key("detected");
    if (change.detected < 0)
        json.null();
    else
        json.boolean(change.detected == 1);
    json.key("unknown");
    if (change.reason == WhyUnknown::nothing)
        json.null();
    else
        json.string(why_unknown(change.reason));
    json.end_object();
}

void write_recipe(JsonText& json, const Study& study) {
    const StudySettings& settings = study.data().settings;
    json.key("recipe").begin_object();
    json.field("expressions_removed", study.data().model != nullptr);
    json.field("treated", settings.zones.treated);
    json.field("margin_mm", settings.zones.margin_mm);
    json.field("unseen", settings.zones.unseen);
    json.field("stable", study.data().zones.stable_names);
    json.field("stable_is_untreated", study.data().zones.stable_is_untreated);
    json.field("noise_mm", settings.surface.noise_mm);
    json.field("correlation_length_mm", settings.surface.correlation_length_mm);
    json.field("slide_correlation_mm", settings.surface.slide_correlation_mm);
    json.field("unseen_apart_share", settings.surface.unseen_apart_share);
    json.field("common_bias_mm", settings.surface.common_bias_mm);
    json.field("posterior_factor", settings.expression.posterior_factor);
    json.field("untrained_share", settings.expression.untrained_share);
    json.field("level", settings.reporting.level);
    json.field("min_seen_share", settings.reporting.min_seen_share);
    json.field("least_seen_weight", settings.reporting.least_seen_weight);
    json.field("max_outside_share", settings.reporting.max_outside_share);
    json.field("blanks", study.num_blanks());
    json.end_object();
}

}  // namespace

std::string study_json(const Study& study) {
    JsonText json;
    json.begin_object();
    write_recipe(json, study);
    json.key("zones").begin_array();
    for (const Zone& zone : study.zones()) json.string(zone.name);
    json.end_array();
    json.key("visits").begin_array();
    for (std::size_t k = 0; k < study.num_visits(); ++k) {
        const std::size_t face = study.face_of(k);
        json.begin_object();
        json.field("captures", study.num_captures(k));
        json.field("expression", study.data().neutral.expressions[face]);
        json.field("fit_failed", study.data().faces[face].failed);
        if (k > 0) {
            const PairChange& change = study.change(0, k);
            json.field("alignment_rms_mm", change.alignment.rms_mm);
            json.key("changes_since_first").begin_array();
            for (std::size_t z = 0; z < change.zones.size(); ++z)
                write_change(json, study.zones()[z].name, change.zones[z]);
            json.end_array();
        }
        json.end_object();
    }
    json.end_array();
    json.end_object();
    return json.take();
}

}  // namespace mien
