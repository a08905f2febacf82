#include "measure/measurement.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "measure/interval.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

constexpr double kLevel = 0.95;  ///< of low95_ml and high95_ml

SignedVolumeVerdict verdict_of(const VolumeParts& volume, const VolumePropagation* propagation,
                               const std::vector<char>& inside, double limit,
                               const Context& context) {
    SignedVolumeVerdict verdict;
    if (propagation != nullptr) {
        verdict.uncertainty = propagation->of(inside, context);
    } else {
        const double none = std::numeric_limits<double>::quiet_NaN();
        verdict.uncertainty = {none, none, none, none};
    }
    const Interval interval = normal_interval(volume.signed_ml, verdict.uncertainty.sd_ml, kLevel);
    verdict.low95_ml = interval.low;
    verdict.high95_ml = interval.high;
    if (limit > 0) verdict.detected = std::fabs(volume.signed_ml) >= limit ? 1 : 0;
    return verdict;
}

void write_volume(JsonText& json, const ZoneVolume& zone, const SignedVolumeVerdict& verdict) {
    json.begin_object();
    json.field("name", zone.name);
    json.field("signed_ml", zone.volume.signed_ml);
    json.field("positive_ml", zone.volume.positive_ml);
    json.field("negative_ml", zone.volume.negative_ml);
    json.field("absolute_ml", zone.volume.absolute_ml);
    json.field("sd_ml", verdict.uncertainty.sd_ml);
    json.field("low95_ml", verdict.low95_ml);
    json.field("high95_ml", verdict.high95_ml);
    json.key("sd_parts_ml");
    json.begin_object();
    json.field("surface", verdict.uncertainty.noise_ml);
    json.field("alignment", verdict.uncertainty.alignment_ml);
    json.field("bias", verdict.uncertainty.bias_ml);
    json.end_object();
    json.key("below_limit_of_detection");
    if (verdict.detected < 0)
        json.null();
    else
        json.boolean(verdict.detected == 0);
    json.field("area_before_mm2", zone.area_before_mm2);
    json.field("area_after_mm2", zone.area_after_mm2);
    json.end_object();
}

void write_distance(JsonText& json, const DistanceSummary& zone) {
    json.begin_object();
    json.field("name", zone.name);
    json.field("mean_signed_mm", zone.mean_signed_mm);
    json.field("sd_signed_mm", zone.sd_signed_mm);
    json.field("mean_absolute_mm", zone.mean_absolute_mm);
    json.field("rms_mm", zone.rms_mm);
    json.field("mean_length_mm", zone.mean_length_mm);
    json.field("median_length_mm", zone.median_length_mm);
    json.field("p95_length_mm", zone.p95_length_mm);
    json.field("max_length_mm", zone.max_length_mm);
    json.field("vertices", static_cast<double>(zone.num_vertices));
    json.end_object();
}

void write_curvature(JsonText& json, const CurvatureSummary& zone) {
    json.begin_object();
    json.field("name", zone.name);
    json.field("mean_mean_per_mm", zone.mean_mean_per_mm);
    json.field("sd_mean_per_mm", zone.sd_mean_per_mm);
    json.field("mean_gaussian_per_mm2", zone.mean_gaussian_per_mm2);
    json.field("mean_maximal_per_mm", zone.mean_maximal_per_mm);
    json.field("mean_minimal_per_mm", zone.mean_minimal_per_mm);
    json.field("bending_per_mm", zone.bending_per_mm);
    json.end_object();
}

}  // namespace

Measurement measure_volume_fully(const PointsRef& before, const PointsRef& after,
                                 const TrianglesRef& triangles, const MeasureOptions& options,
                                 const Context& context) {
    if (!(options.limit_of_detection_ml >= 0) || !std::isfinite(options.limit_of_detection_ml))
        fail(Status::invalid_argument,
             "limit of detection %g mL; give a positive one, or 0 for none",
             options.limit_of_detection_ml);
    Measurement result;
    result.limit_of_detection_ml = options.limit_of_detection_ml;
    result.shares = volume_per_vertex(before, after, triangles, context);
    result.volume = measure_volume(before, after, triangles, options.zones, context);
    std::optional<VolumePropagation> propagation;
    if (options.errors) propagation.emplace(before, after, triangles, *options.errors);
    const VolumePropagation* asked = propagation ? &*propagation : nullptr;
    auto verdict = [&](const ZoneVolume& zone, const std::vector<char>& inside) {
        return verdict_of(zone.volume, asked, inside, options.limit_of_detection_ml, context);
    };
    std::vector<char> uncovered(static_cast<std::size_t>(before.rows()), 1);
    for (std::size_t z = 0; z < options.zones.size(); ++z) {
        const std::vector<char> inside = membership(options.zones[z].vertices, before.rows());
        for (std::size_t v = 0; v < inside.size(); ++v)
            if (inside[v]) uncovered[v] = 0;
        result.zone_verdicts.push_back(verdict(result.volume->zones[z], inside));
        result.zone_names.push_back(options.zones[z].name);
    }
    result.rest_verdict = verdict(result.volume->rest, uncovered);
    const std::vector<char> all(static_cast<std::size_t>(before.rows()), 1);
    result.whole_verdict = verdict(result.volume->whole, all);
    return result;
}

Measurement measurement_of(const ScanVolumeReport& report, double limit_of_detection_ml) {
    if (!(limit_of_detection_ml >= 0) || !std::isfinite(limit_of_detection_ml))
        fail(Status::invalid_argument,
             "limit of detection %g mL; give a positive one, or 0 for none", limit_of_detection_ml);
    Measurement result;
    result.limit_of_detection_ml = limit_of_detection_ml;
    result.volume = report.volume;
    auto verdict = [&](const ZoneVolume& zone) {
        return verdict_of(zone.volume, nullptr, {}, limit_of_detection_ml, Context());
    };
    for (const ZoneVolume& zone : report.volume.zones) {
        result.zone_verdicts.push_back(verdict(zone));
        result.zone_names.push_back(zone.name);
    }
    result.rest_verdict = verdict(report.volume.rest);
    result.whole_verdict = verdict(report.volume.whole);
    return result;
}

void write_measurement(JsonText& json, const Measurement& m) {
    if (m.volume) {
        json.key("volume");
        json.begin_object();
        json.field("unit", "mL");
        json.field("sign", "positive: the after face lies outside the before face");
        json.key("zones_disjoint");
        json.boolean(m.volume->zones_disjoint);
        json.key("limit_of_detection_ml");
        if (m.limit_of_detection_ml > 0)
            json.number(m.limit_of_detection_ml);
        else
            json.null();
        json.key("whole");
        write_volume(json, m.volume->whole, m.whole_verdict);
        json.key("zones");
        json.begin_array();
        for (std::size_t z = 0; z < m.volume->zones.size(); ++z)
            write_volume(json, m.volume->zones[z], m.zone_verdicts[z]);
        json.end_array();
        json.key("rest");
        write_volume(json, m.volume->rest, m.rest_verdict);
        json.end_object();
    }
    if (m.distance) {
        json.key("distance");
        json.begin_object();
        json.field("unit", "mm");
        json.field("hausdorff_mm", m.distance->hausdorff_mm);
        json.key("whole");
        write_distance(json, m.distance->whole);
        json.key("zones");
        json.begin_array();
        for (const DistanceSummary& zone : m.distance->zones) write_distance(json, zone);
        json.end_array();
        json.end_object();
    }
    if (m.curvature) {
        json.key("curvature");
        json.begin_object();
        json.field("unit", "1/mm, Gaussian 1/mm^2");
        json.field("sign", "positive: bulges outwards");
        json.key("whole");
        write_curvature(json, m.curvature->whole);
        json.key("zones");
        json.begin_array();
        for (const CurvatureSummary& zone : m.curvature->zones) write_curvature(json, zone);
        json.end_array();
        json.end_object();
    }
}

std::string measurement_json(const Measurement& measurement) {
    JsonText json;
    json.begin_object();
    write_measurement(json, measurement);
    json.end_object();
    return json.take();
}

}  // namespace mien
