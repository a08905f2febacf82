#include "expression/report_json.hpp"

#include <algorithm>

#include "base/json_text.hpp"

namespace mien {
namespace {

void add_model(JsonText& json, const ExpressionModel& model) {
    json.field("vertices", model.num_vertices())
        .field("triangles", model.triangles.rows())
        .field("identity_modes", model.num_identity_modes())
        .field("expression_modes", model.num_expression_modes())
        .field("map_noise_mm2", model.map_noise_mm2)
        .field("mixture_noise_mm2", model.mixture_noise_mm2)
        .field("expected_residual_mm", model.expected_residual_mm)
        .field("expressions", model.expression_names);
    std::vector<std::string> names;
    for (const ExpressionComponent& component : model.components) names.push_back(component.name);
    json.field("components", names);
    json.key("info").begin_object();
    for (const auto& [key, value] : model.info) json.field(key, value);
    json.end_object();
}

void add_errors(JsonText& json, const char* key, const ErrorSummary& summary) {
    json.key(key).begin_object();
    json.field("mean_mm", summary.mean_mm)
        .field("sd_mm", summary.deviation_mm)
        .field("max_vertex_mm", summary.max_vertex_mm);
    json.end_object();
}

/// Mean errors of one expression, or of all but the neutral faces (expression < 0).
std::vector<double> errors_of(const EvaluatedFaces& faces, int expression, int neutral) {
    std::vector<double> values;
    for (std::size_t k = 0; k < faces.face.size(); ++k)
        if (expression >= 0 ? faces.expression[k] == expression : faces.expression[k] != neutral)
            values.push_back(faces.mean_mm[k]);
    return values;
}

using Volumes = std::vector<std::vector<double>>;  ///< per zone, over faces

Volumes volumes_of(const EvaluatedFaces& faces, int expression, int neutral) {
    Volumes volumes;
    for (std::size_t k = 0; k < faces.face.size(); ++k) {
        if (expression >= 0 ? faces.expression[k] != expression : faces.expression[k] == neutral)
            continue;
        volumes.resize(faces.volumes_ml[k].size());
        for (std::size_t z = 0; z < volumes.size(); ++z)
            volumes[z].push_back(faces.volumes_ml[k][z]);
    }
    return volumes;
}

void add_effect(JsonText& json, const char* key, const std::vector<double>& first,
                const std::vector<double>& second) {
    const Effect effect = effect_size(first, second);
    json.key(key).begin_object();
    json.field("cohens_d", effect.cohens_d).field("superiority", effect.superiority).end_object();
}

void add_reading(JsonText& json, const char* key, const ZoneReading& reading) {
    json.key(key).begin_object();
    json.field("expression", reading.expression)
        .field("probability", reading.probability)
        .field("removed_mm", reading.removed_mm)
        .field("removed_ml", reading.removed_ml);
    json.end_object();
}

void add_volumes(JsonText& json, const std::vector<std::string>& names, const Volumes& baseline,
                 const Volumes& result, const Volumes& against) {
    const auto add = [&](const char* key, const std::vector<double>& volumes) {
        const VolumeSummary summary = summarize_volume(volumes);
        json.key(key).begin_object();
        json.field("mean_ml", summary.mean_ml)
            .field("sd_ml", summary.deviation_ml)
            .field("median_ml", summary.median_ml);
        json.end_object();
    };
    json.key("volumes").begin_array();
    for (std::size_t z = 0; z < names.size() && z < result.size(); ++z) {
        json.begin_object().field("zone", names[z]);
        add("baseline", baseline[z]);
        add("result", result[z]);
        add_effect(json, "effect_over_baseline", baseline[z], result[z]);
        if (!against.empty()) {
            add("against", against[z]);
            add_effect(json, "effect_over_against", against[z], result[z]);
        }
        json.end_object();
    }
    json.end_array();
}

}  // namespace

std::string evaluation_json(const FaceDataset& dataset, const EvaluatedFaces& baseline,
                            const EvaluatedFaces& result, const EvaluatedFaces* against,
                            const std::vector<std::string>& volume_names) {
    const std::vector<std::string>& names = dataset.expression_names();
    const int neutral = dataset.neutral_expression();
    JsonText json;
    const auto add_row = [&](const std::string& name, int expression, const ErrorSummary& untouched,
                             const ErrorSummary& own, const ErrorSummary* other) {
        const std::vector<double> errors = errors_of(result, expression, neutral);
        json.begin_object().field("expression", name).field("faces", own.count);
        add_errors(json, "baseline", untouched);
        add_errors(json, "result", own);
        add_effect(json, "effect_over_baseline", errors_of(baseline, expression, neutral), errors);
        if (other != nullptr) {
            add_errors(json, "against", *other);
            add_effect(json, "effect_over_against", errors_of(*against, expression, neutral),
                       errors);
        }
        if (!volume_names.empty()) {
            const auto chosen = [&](const EvaluatedFaces& faces) {
                return volumes_of(faces, expression, neutral);
            };
            add_volumes(json, volume_names, chosen(baseline), chosen(result),
                        against != nullptr ? chosen(*against) : Volumes());
        }
        json.end_object();
    };
    const std::vector<ErrorSummary> untouched = summarize(baseline, names);
    const std::vector<ErrorSummary> own = summarize(result, names);
    const std::vector<ErrorSummary> other =
        against != nullptr ? summarize(*against, names) : std::vector<ErrorSummary>();
    json.begin_object().key("expressions").begin_array();
    for (std::size_t k = 0; k < own.size(); ++k) {
        const int expression =
            static_cast<int>(std::find(names.begin(), names.end(), own[k].name) - names.begin());
        add_row(own[k].name, expression, untouched[k], own[k],
                against != nullptr ? &other[k] : nullptr);
    }
    json.end_array().key("all");
    const ErrorSummary all_other =
        against != nullptr ? summarize_moved(*against, neutral) : ErrorSummary();
    add_row("all", -1, summarize_moved(baseline, neutral), summarize_moved(result, neutral),
            against != nullptr ? &all_other : nullptr);
    return json.end_object().take();
}

std::string model_json(const ExpressionModel& model) {
    JsonText json;
    add_model(json.begin_object(), model);
    json.field("identity_deviations_mm", model.identity_deviations)
        .field("expression_deviations_mm", model.expression_deviations);
    return json.end_object().take();
}

std::string training_json(const ExpressionModel& model, const TrainReport& report) {
    JsonText json;
    add_model(json.begin_object(), model);
    json.field("subjects", report.subjects)
        .field("faces", report.faces)
        .field("skipped_faces", report.skipped_faces)
        .field("k", report.k)
        .field("lambda", report.lambda)
        .field("iterations", report.iterations)
        .field("last_angle_rad", report.last_angle_rad)
        .field("converged", report.converged)
        .field("orthogonality", report.orthogonality)
        .field("joint_pca_orthogonality", report.joint_pca_orthogonality)
        .field("identity_explained", report.identity_explained)
        .field("expression_explained", report.expression_explained)
        .field("span_cut", report.span_cut)
        .field("cross_validated_map_error_mm", report.noise.map_error_mm)
        .field("cross_validated_mixture_error_mm", report.noise.mixture_error_mm);
    json.field("smooth_modes", report.smooth_modes)
        .field("smooth_variance_mm2", report.smooth_variance_mm2);
    json.key("tried_smoothness").begin_array();
    for (const TriedSmoothness& tried : report.tried_smoothness)
        json.begin_object()
            .field("variance_mm2", tried.variance_mm2)
            .field("held_out_mm", tried.held_out_mm)
            .end_object();
    json.end_array();
    json.key("tried_modes").begin_array();
    for (const TriedModes& pair : report.tried_modes)
        json.begin_object()
            .field("identity", pair.identity)
            .field("expression", pair.expression)
            .field("held_out_mm", pair.held_out_mm)
            .end_object();
    json.end_array();
    return json.end_object().take();
}

std::string neutralization_json(const ExpressionModel& model, const NeutralizationResult& result,
                                const TreatedReadings* readings) {
    std::vector<std::string> warnings = neutralization_warnings(model, result);
    if (readings != nullptr && readings->differ) warnings.push_back(treated_warning(*readings));
    JsonText json;
    json.begin_object()
        .field("mean_displacement_mm", result.mean_displacement_mm)
        .field("max_displacement_mm", result.max_displacement_mm)
        .field("rms_displacement_mm", result.rms_displacement_mm)
        .field("rms_uncertainty_mm", result.rms_uncertainty_mm)
        .field("residual_rms_mm", result.residual_rms_mm)
        .field("expected_residual_mm", model.expected_residual_mm)
        .field("noise_mm2", result.noise_mm2)
        .field("doubted_share", result.doubted_share)
        .field("unseen_share", result.unseen_share)
        .field("sweeps", result.sweeps)
        .field("converged", result.converged);
    json.field("warnings", warnings);
    if (readings != nullptr) {
        json.key("treated_zone").begin_object();
        add_reading(json, "treated", readings->treated);
        add_reading(json, "as_expression", readings->as_expression);
        json.field("differ", readings->differ).end_object();
    }
    if (!result.component_probabilities.empty()) {
        std::size_t best = 0;
        json.key("probabilities").begin_object();
        for (std::size_t k = 0; k < result.component_probabilities.size(); ++k) {
            json.field(model.components[k].name, result.component_probabilities[k]);
            if (result.component_probabilities[k] > result.component_probabilities[best]) best = k;
        }
        json.end_object()
            .field("expression", model.components[best].name)
            .field("intensity", result.intensity);
    }
    if (result.uncertainty_mm.size() != 0)
        json.field("mean_uncertainty_mm", result.uncertainty_mm.mean())
            .field("max_uncertainty_mm", result.uncertainty_mm.maxCoeff());
    json.field("identity_coordinates_mm", result.identity)
        .field("expression_coordinates_mm", result.expression);
    return json.end_object().take();
}

std::string visits_json(const ExpressionModel& model, const VisitsResult& result) {
    JsonText json;
    json.begin_object().key("faces").begin_array();
    for (std::size_t k = 0; k < result.expressions.size(); ++k) {
        json.begin_object();
        if (!result.components.empty()) json.field("expression", result.components[k]);
        json.field("residual_rms_mm", result.residuals_mm[k])
            .field("distance_to_shared_mm", result.distances_mm[k])
            .field("warnings", visit_warnings(model, result, k))
            .field("expression_coordinates_mm", result.expressions[k])
            .end_object();
    }
    json.end_array()
        .field("expected_residual_mm", model.expected_residual_mm)
        .field("identity_coordinates_mm", result.identity);
    return json.end_object().take();
}

}  // namespace mien
