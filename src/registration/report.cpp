#include "registration/report.hpp"

#include <charconv>
#include <cmath>

#include "base/json.hpp"

namespace mien {
namespace {

void add_number(std::string& json, double value) {
    if (!std::isfinite(value)) {
        json += "null";
        return;
    }
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value);
    json.append(text, end.ptr);
}

void add_key(std::string& json, const char* key) {
    if (json.back() != '{' && json.back() != '[') json += ',';
    json += '"';
    json += key;
    json += "\":";
}

void add(std::string& json, const char* key, double value) {
    add_key(json, key);
    add_number(json, value);
}

void add(std::string& json, const char* key, const std::string& value) {
    add_key(json, key);
    append_json_string(json, value);
}

void add(std::string& json, const char* key, const std::vector<std::string>& values) {
    add_key(json, key);
    json += json_string_list(values);
}

template <typename Values>
void add_list(std::string& json, const char* key, const Values& values) {
    add_key(json, key);
    json += '[';
    bool first = true;
    for (const double value : values) {
        if (!first) json += ',';
        first = false;
        add_number(json, value);
    }
    json += ']';
}

void add_motion(std::string& json, const char* key, const Similarity& motion) {
    add_key(json, key);
    json += '{';
    add(json, "scale", motion.scale);
    std::vector<double> rotation, translation;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) rotation.push_back(motion.rotation(i, j));
        translation.push_back(motion.translation[i]);
    }
    add_list(json, "rotation", rotation);
    add_list(json, "translation_mm", translation);
    json += '}';
}

const char* quality_name(FitQuality quality) {
    switch (quality) {
        case FitQuality::good: return "good";
        case FitQuality::doubtful: return "doubtful";
        case FitQuality::failed: return "failed";
    }
    return "failed";
}

}  // namespace

std::string registration_json(const RegistrationResult& result) {
    const Verdict& v = result.verdict;
    std::string json = "{";
    add(json, "quality", std::string(quality_name(v.quality)));
    add(json, "reasons", v.reasons);
    add(json, "coverage", v.coverage);
    add(json, "inlier_share", v.inlier_share);
    add(json, "mean_residual_mm", v.mean_residual_mm);
    add(json, "landmark_rms_mm", v.landmark_rms_mm);
    add(json, "landmarks_used", v.landmarks_used);
    add(json, "landmarks_rejected", v.landmarks_rejected);
    add(json, "landmarks_unknown", result.unknown_landmarks);
    add(json, "size_ratio", v.size_ratio);
    add(json, "mean_deviation", v.mean_deviation);
    add(json, "flipped_triangles", v.flipped_triangles);
    add(json, "repaired_triangles", v.repaired_triangles);
    add(json, "self_intersections", v.self_intersections);
    add(json, "search_score", v.search_score);
    add(json, "unit_to_mm", v.unit_to_mm);
    add_key(json, "color_agreement");
    json += '{';
    for (const ColorAgreement& feature : v.colors) add(json, feature.name.c_str(), feature.correlation);
    json += '}';
    add(json, "iterations", result.iterations);
    add(json, "noise_mm", result.sigma_mm);
    add_list(json, "energy_mm2", result.energy);
    add_motion(json, "start", result.start);
    add_motion(json, "motion", result.motion);
    add(json, "mean_absolute_residual_mm",
        result.residual_mm.size() > 0 ? result.residual_mm.cwiseAbs().mean() : 0);
    add(json, "mean_weight", result.weight.size() > 0 ? result.weight.mean() : 0);
    add(json, "mean_deviation_mm", result.confidence_mm.size() > 0 ? result.confidence_mm.mean() : 0);
    json += '}';
    return json;
}

}  // namespace mien
