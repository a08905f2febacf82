// A finished measurement: numbers per zone with their uncertainty and the verdict against the limit
// of detection, fields per vertex, and all of it as JSON.
#pragma once

#include <optional>
#include <string>

#include "base/json_text.hpp"
#include "measure/curvature_summary.hpp"
#include "measure/distance.hpp"
#include "measure/scan_volume.hpp"
#include "measure/uncertainty.hpp"
#include "measure/volume.hpp"

namespace mien {

struct MeasureOptions {
    std::vector<Zone> zones;
    std::optional<VolumeErrorModel> errors;  ///< none: no deviation is reported
    double limit_of_detection_ml = 0.0;      ///< 0: unknown; otherwise > 0
};

/// One zone's signed volume with its 95 % interval.
struct SignedVolumeVerdict {
    VolumeUncertainty uncertainty;  ///< not a number throughout when no error model was given
    double low95_ml = 0.0, high95_ml = 0.0;
    int detected =
        -1;  ///< 1: |signed| reaches the limit of detection, 0: below, -1: no limit known
};

struct Measurement {
    std::optional<VolumeReport> volume;
    SignedVolumeVerdict whole_verdict, rest_verdict;
    std::vector<SignedVolumeVerdict> zone_verdicts;
    double limit_of_detection_ml = 0.0;
    VertexVolumes shares;  ///< empty unless `volume`
    std::optional<DistanceReport> distance;
    std::optional<CurvatureReport> curvature;
    std::vector<std::string> zone_names;
};

/// Volume between faces in correspondence. Failures: as measure_volume() and VolumePropagation.
Measurement measure_volume_fully(const PointsRef& before, const PointsRef& after,
                                 const TrianglesRef& triangles, const MeasureOptions& options,
                                 const Context& context);

/// A scan-to-scan volume as a measurement without deviations; limit as in MeasureOptions. Shares
/// per vertex are not kept.
Measurement measurement_of(const ScanVolumeReport& report, double limit_of_detection_ml);

/// UTF-8, numbers shortest that read back the same; what is not known is null.
std::string measurement_json(const Measurement& measurement);
/// The members of measurement_json()'s object alone, into an open one.
void write_measurement(JsonText& json, const Measurement& measurement);

}  // namespace mien
