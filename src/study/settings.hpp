// The settings of a study, one struct per part of the recipe. All numbers were chosen on four
// simulated people (injection study, seed 77) and reported on twenty others (seed 78): the table is
// in tests/bench/README.md, "An injection into a cheek". What was not measured says so.
#pragma once

#include <string>
#include <vector>

#include "geometry/surface_errors.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// How far a fitted surface lies off the skin.
struct SurfaceErrorSettings {
    /// Deviation of a scanner's surface along its normal where the scan was seen, mm, >= 0. 0.08:
    /// scans with 0.15 mm of noise per point, smoothed by the fit (injection study, seed 77).
    double noise_mm = 0.08;
    /// Over which the errors of a fitted surface go together, mm, >= 0 (injection study, seed 77).
    double correlation_length_mm = kSurfaceCorrelationMm;
    /// Along the skin, over which a template slides together, mm, >= 0. Enters the error of areas
    /// alone. Not measured: the reach of the kernels' prior.
    double slide_correlation_mm = 15.0;
    /// Of the deviation of a place that neither of two visits saw, the part by which two fits of
    /// one person differ there, 0 to 1. What was not seen is guessed from the skin around it:
    /// visits of one person guess alike, and a change is surer than either place. Chosen and held
    /// against other people in tests/bench/README.md, "What a change's surface leaves open".
    double unseen_apart_share = 0.1;
    /// An error common to all vertices that no repetition shows, mm, >= 0 (injection study).
    double common_bias_mm = 0.01;
};

/// What taking expressions off leaves open.
struct ExpressionErrorSettings {
    /// On the posterior deviation of the expressions, >= 0; 1: the fit's own word.
    double posterior_factor = 1.0;
    /// Of the volume that an expression accounted for, >= 0: no training set holds every way of
    /// smiling (injection study, seed 77, neutral against smile).
    double untrained_share = 0.06;
};

/// Which parts of the face are measured, which may have changed, which hold still.
struct StudyZoneSettings {
    std::vector<Zone> zones;           ///< measured, in this order; vertices of the faces
    std::vector<std::string> treated;  ///< names of zones where the person may have changed
    /// Names of zones to align on. Empty: all zones without the treated ones when zones are treated
    /// and expressions are taken off (the farther the aligned skin reaches, the less a face can
    /// tilt), otherwise "forehead" and "nose", which expressions move least; without any zone the
    /// whole face.
    std::vector<std::string> stable;
    /// Around the treated zones, mm, 0 to 100: no witness of expression or pose either, and
    /// measured with them as "NAME and 10 mm around": treatments spread.
    double margin_mm = 10.0;
    /// Zones keep what no scan saw: the walls in nostrils, lips and lids (model/template_walls.hpp)
    /// and skin that no visit saw. A fit guesses it, and a guess that moves is no change:
    /// tests/bench/README.md, "Injections elsewhere".
    bool unseen = false;
};

/// When a number may be told, and how.
struct ReportingSettings {
    double level = 0.95;  ///< of the intervals, above 0 and below 1
    /// Share of a zone's area that both visits must have seen, 0 to 1; below it nothing is told.
    /// Not measured: a zone of which less was seen is the model's guess.
    double min_seen_share = 0.1;
    /// Skin whose weight stayed below this in every visit was seen by none, 0 to 1. Judgement:
    /// other values were not tried.
    double least_seen_weight = 0.3;
    /// Share of a zone's area behind the expression model's rim, 0 to 1, above which there is no
    /// deviation: what expressions do there is not known. Not measured.
    double max_outside_share = 0.2;
};

struct StudySettings {
    StudyZoneSettings zones;
    SurfaceErrorSettings surface;
    ExpressionErrorSettings expression;
    ReportingSettings reporting;
};

/// Throws Status::invalid_argument naming the setting that is out of its range.
void check_study_settings(const StudySettings& settings);

}  // namespace mien
