#include "expression/report_json.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/json.hpp"

namespace mien {
namespace {

/// One object under construction; numbers that JSON cannot hold become null.
class JsonObject {
  public:
    JsonObject& number(const char* key, double value) {
        begin(key);
        append(value);
        return *this;
    }
    JsonObject& integer(const char* key, std::int64_t value) {
        begin(key);
        text_ += std::to_string(value);
        return *this;
    }
    JsonObject& boolean(const char* key, bool value) {
        begin(key);
        text_ += value ? "true" : "false";
        return *this;
    }
    JsonObject& string(const char* key, const std::string& value) {
        begin(key);
        append_json_string(text_, value);
        return *this;
    }
    JsonObject& raw(const char* key, const std::string& json) {
        begin(key);
        text_ += json;
        return *this;
    }
    template <typename Values>
    JsonObject& numbers(const char* key, const Values& values) {
        begin(key);
        text_ += '[';
        for (Index k = 0; k < static_cast<Index>(values.size()); ++k) {
            if (k != 0) text_ += ", ";
            append(values[static_cast<std::size_t>(k)]);
        }
        text_ += ']';
        return *this;
    }
    std::string text() const { return text_ + "}"; }

  private:
    void begin(const char* key) {
        if (text_.size() > 1) text_ += ", ";
        append_json_string(text_, key);
        text_ += ": ";
    }
    void append(double value) {
        if (!std::isfinite(value)) {
            text_ += "null";
            return;
        }
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value);
        text_.append(digits, end.ptr);
    }
    std::string text_ = "{";
};

std::vector<double> as_list(const Vector& values) {
    return std::vector<double>(values.data(), values.data() + values.size());
}

void add_model(JsonObject& json, const ExpressionModel& model) {
    json.integer("vertices", model.num_vertices())
        .integer("triangles", model.triangles.rows())
        .integer("identity_modes", model.num_identity_modes())
        .integer("expression_modes", model.num_expression_modes())
        .number("map_noise_mm2", model.map_noise_mm2)
        .number("mixture_noise_mm2", model.mixture_noise_mm2)
        .number("expected_residual_mm", model.expected_residual_mm)
        .raw("expressions", json_string_list(model.expression_names));
    std::vector<std::string> names;
    for (const ExpressionComponent& component : model.components) names.push_back(component.name);
    json.raw("components", json_string_list(names));
    JsonObject info;
    for (const auto& [key, value] : model.info) info.string(key.c_str(), value);
    json.raw("info", info.text());
}

std::string errors_json(const ErrorSummary& summary) {
    JsonObject json;
    json.number("mean_mm", summary.mean_mm)
        .number("sd_mm", summary.deviation_mm)
        .number("max_vertex_mm", summary.max_vertex_mm);
    return json.text();
}

/// Mean errors of one expression, or of all but the neutral faces (expression < 0).
std::vector<double> errors_of(const EvaluatedFaces& faces, int expression, int neutral) {
    std::vector<double> values;
    for (std::size_t k = 0; k < faces.face.size(); ++k)
        if (expression >= 0 ? faces.expression[k] == expression : faces.expression[k] != neutral)
            values.push_back(faces.mean_mm[k]);
    return values;
}

std::string effect_json(const std::vector<double>& first, const std::vector<double>& second) {
    const Effect effect = effect_size(first, second);
    JsonObject json;
    json.number("cohens_d", effect.cohens_d).number("superiority", effect.superiority);
    return json.text();
}

}  // namespace

std::string evaluation_json(const FaceDataset& dataset, const EvaluatedFaces& baseline,
                            const EvaluatedFaces& result, const EvaluatedFaces* against) {
    const std::vector<std::string>& names = dataset.expression_names();
    const int neutral = dataset.neutral_expression();
    auto row = [&](const std::string& name, int expression, const ErrorSummary& untouched,
                   const ErrorSummary& own, const ErrorSummary* other) {
        JsonObject json;
        json.string("expression", name)
            .integer("faces", own.count)
            .raw("baseline", errors_json(untouched))
            .raw("result", errors_json(own))
            .raw("effect_over_baseline", effect_json(errors_of(baseline, expression, neutral),
                                                     errors_of(result, expression, neutral)));
        if (other != nullptr)
            json.raw("against", errors_json(*other))
                .raw("effect_over_against", effect_json(errors_of(*against, expression, neutral),
                                                        errors_of(result, expression, neutral)));
        return json.text();
    };
    const std::vector<ErrorSummary> untouched = summarize(baseline, names);
    const std::vector<ErrorSummary> own = summarize(result, names);
    const std::vector<ErrorSummary> other =
        against != nullptr ? summarize(*against, names) : std::vector<ErrorSummary>();
    std::string rows = "[";
    for (std::size_t k = 0; k < own.size(); ++k) {
        const int expression = static_cast<int>(
            std::find(names.begin(), names.end(), own[k].name) - names.begin());
        if (k != 0) rows += ", ";
        rows += row(own[k].name, expression, untouched[k], own[k],
                    against != nullptr ? &other[k] : nullptr);
    }
    rows += "]";
    const ErrorSummary all_untouched = summarize_moved(baseline, neutral);
    const ErrorSummary all_own = summarize_moved(result, neutral);
    const ErrorSummary all_other =
        against != nullptr ? summarize_moved(*against, neutral) : ErrorSummary();
    JsonObject json;
    json.raw("expressions", rows)
        .raw("all", row("all", -1, all_untouched, all_own, against != nullptr ? &all_other : nullptr));
    return json.text();
}

std::string model_json(const ExpressionModel& model) {
    JsonObject json;
    add_model(json, model);
    json.numbers("identity_deviations_mm", as_list(model.identity_deviations))
        .numbers("expression_deviations_mm", as_list(model.expression_deviations));
    return json.text();
}

std::string training_json(const ExpressionModel& model, const TrainReport& report) {
    JsonObject json;
    add_model(json, model);
    json.integer("subjects", report.subjects)
        .integer("faces", report.faces)
        .integer("skipped_faces", report.skipped_faces)
        .number("k", report.k)
        .number("lambda", report.lambda)
        .integer("iterations", report.iterations)
        .number("last_angle_rad", report.last_angle_rad)
        .boolean("converged", report.converged)
        .numbers("orthogonality", as_list(report.orthogonality))
        .numbers("joint_pca_orthogonality", as_list(report.joint_pca_orthogonality))
        .number("identity_explained", report.identity_explained)
        .number("expression_explained", report.expression_explained)
        .number("span_cut", report.span_cut)
        .number("cross_validated_map_error_mm", report.noise.map_error_mm)
        .number("cross_validated_mixture_error_mm", report.noise.mixture_error_mm);
    return json.text();
}

std::string neutralization_json(const ExpressionModel& model, const NeutralizationResult& result) {
    JsonObject json;
    json.number("mean_displacement_mm", result.mean_displacement_mm)
        .number("max_displacement_mm", result.max_displacement_mm)
        .number("rms_displacement_mm", result.rms_displacement_mm)
        .number("rms_uncertainty_mm", result.rms_uncertainty_mm)
        .number("residual_rms_mm", result.residual_rms_mm)
        .number("expected_residual_mm", model.expected_residual_mm)
        .number("noise_mm2", result.noise_mm2)
        .number("doubted_share", result.doubted_share)
        .number("unseen_share", result.unseen_share)
        .integer("sweeps", result.sweeps)
        .boolean("converged", result.converged);
    json.raw("warnings", json_string_list(neutralization_warnings(model, result)));
    if (!result.component_probabilities.empty()) {
        JsonObject expressions;
        std::size_t best = 0;
        for (std::size_t k = 0; k < result.component_probabilities.size(); ++k) {
            expressions.number(model.components[k].name.c_str(), result.component_probabilities[k]);
            if (result.component_probabilities[k] > result.component_probabilities[best]) best = k;
        }
        json.string("expression", model.components[best].name);
        json.raw("probabilities", expressions.text());
    }
    if (result.uncertainty_mm.size() != 0)
        json.number("mean_uncertainty_mm", result.uncertainty_mm.mean())
            .number("max_uncertainty_mm", result.uncertainty_mm.maxCoeff());
    json.numbers("identity_coordinates_mm", as_list(result.identity))
        .numbers("expression_coordinates_mm", as_list(result.expression));
    return json.text();
}

std::string series_json(const ExpressionModel& model, const SeriesResult& result) {
    std::string faces = "[";
    for (std::size_t k = 0; k < result.expressions.size(); ++k) {
        JsonObject face;
        if (!result.components.empty()) face.string("expression", result.components[k]);
        face.number("residual_rms_mm", result.residuals_mm[k])
            .number("distance_to_shared_mm", result.distances_mm[k])
            .raw("warnings", json_string_list(series_warnings(model, result, k)))
            .numbers("expression_coordinates_mm", as_list(result.expressions[k]));
        faces += (k == 0 ? "" : ", ") + face.text();
    }
    JsonObject json;
    json.raw("faces", faces + "]")
        .number("expected_residual_mm", model.expected_residual_mm)
        .numbers("identity_coordinates_mm", as_list(result.identity));
    return json.text();
}

}  // namespace mien
