#include "registration/report.hpp"

#include "base/json_text.hpp"

namespace mien {
namespace {

void add_motion(JsonText& json, const char* key, const Similarity& motion) {
    json.key(key).begin_object().field("scale", motion.scale);
    json.key("rotation").begin_array();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) json.number(motion.rotation(i, j));
    json.end_array().field("translation_mm", motion.translation).end_object();
}

const char* quality_name(FitQuality quality) {
    switch (quality) {
        case FitQuality::good:
            return "good";
        case FitQuality::doubtful:
            return "doubtful";
        case FitQuality::failed:
            return "failed";
    }
    return "failed";
}

void add_measures(JsonText& json, const Verdict& v) {
    const WholeMeasures& w = v.whole;
    json.key("measures").begin_object();
    json.field("search_miss", w.search_miss);
    json.field("landmark_misfit", w.landmark_misfit);
    json.field("landmarks_out", w.landmarks_out);
    json.field("color_miss", w.color_miss);
    json.field("trained_deviation", w.trained_deviation);
    json.field("kernel_deviation", w.kernel_deviation);
    json.field("kernel_mm", w.kernel_mm);
    json.field("size", w.size);
    json.field("folds", w.folds);
    json.field("is_free", w.is_free);
    json.field("is_trained", w.is_trained);
    json.field("no_colors", w.no_colors);
    json.field("landmarks", w.landmarks);
    json.field("lips_miss", w.lips_miss);
    json.field("brows_miss", w.brows_miss);
    json.field("worst_open_mm", w.worst_open_mm);
    json.field("worst_unseen", w.worst_unseen);
    json.end_object();
    json.key("zones").begin_object();
    for (const ZoneMeasures& zone : v.zones) {
        json.key(zone.name).begin_object();
        json.field("unseen", zone.unseen);
        json.field("residual_mm", zone.residual_mm);
        json.field("open_mm", zone.open_mm);
        json.field("turn", zone.turn);
        json.field("deviation_mm", zone.deviation_mm);
        json.field("stretch", zone.stretch);
        json.field("landmark_mm", zone.landmark_mm);
        json.field("landmarks", zone.landmarks);
        json.field("open_most_mm", zone.open_most_mm);
        json.field("asymmetry_mm", zone.asymmetry_mm);
        json.field("shape_deviation", zone.shape_deviation);
        json.field("slid_mm", zone.slid_mm);
        json.field("pin_far_mm", zone.pin_far_mm);
        json.field("pin_misfit_mm", zone.pin_misfit_mm);
        json.field("color_hold", zone.color_hold);
        json.field("color_doubt", zone.color_doubt);
        json.end_object();
    }
    json.end_object();
    json.key("expected_error").begin_object();
    for (const ExpectedError& error : v.expected) {
        json.key(error.zone).begin_object();
        json.field("expected_mm", error.expected_mm);
        json.field("low_mm", error.low_mm);
        json.field("high_mm", error.high_mm);
        json.field("quality", quality_name(error.quality));
        json.end_object();
    }
    json.end_object();
}

}  // namespace

std::string registration_json(const RegistrationResult& result, const std::string& reference) {
    const Verdict& v = result.verdict;
    JsonText json;
    json.begin_object();
    json.field("quality", quality_name(v.quality));
    json.field("reasons", v.reasons);
    json.field("notes", v.notes);
    json.field("coverage", v.coverage);
    json.field("inlier_share", v.inlier_share);
    json.field("mean_residual_mm", v.mean_residual_mm);
    json.field("landmark_rms_mm", v.landmark_rms_mm);
    json.field("landmarks_used", v.landmarks_used);
    json.field("landmarks_rejected", v.landmarks_rejected);
    json.field("landmarks_unknown", result.unknown_landmarks);
    json.field("size_ratio", v.size_ratio);
    json.field("mean_deviation", v.mean_deviation);
    json.field("flipped_triangles", v.flipped_triangles);
    json.field("repaired_triangles", v.repaired_triangles);
    json.field("self_intersections", v.self_intersections);
    json.field("search_score", v.search_score);
    json.field("turned_over", v.turned_over);
    json.field("turned_triangles", v.turned_triangles);
    json.field("unit_to_mm", v.unit_to_mm);
    json.key("color_agreement").begin_object();
    for (const ColorAgreement& feature : v.colors) json.field(feature.name, feature.correlation);
    json.end_object();
    json.field("colors_left_out", v.colors_left_out);
    add_measures(json, v);
    json.field("iterations", result.iterations);
    json.field("noise_mm", result.sigma_mm);
    json.field("energy_mm2", result.energy);
    add_motion(json, "start", result.start);
    add_motion(json, "motion", result.motion);
    json.field("mean_absolute_residual_mm",
               result.residual_mm.size() > 0 ? result.residual_mm.cwiseAbs().mean() : 0);
    json.field("mean_weight", result.weight.size() > 0 ? result.weight.mean() : 0);
    json.field("mean_deviation_mm",
               result.confidence_mm.size() > 0 ? result.confidence_mm.mean() : 0);
    if (!reference.empty()) json.key("reference").raw(reference);
    json.end_object();
    return json.take();
}

}  // namespace mien
