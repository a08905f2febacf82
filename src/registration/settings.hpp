// Every number that a registration goes by, stage by stage. A stage reads its own part and derives
// what it needs; nothing overwrites what the host gave.
//
// Each member says its meaning, unit and range. A tag in brackets says what chose its default:
//   [T]  a table of tests/bench/README.md, which is named
//   [A]  the ablation table there: switching it off, or to the plain choice, costs what it prints
//   [J]  judgement, not measured
// A tag at a struct holds for all its numbers. Those without a tag are published, exact, or bounds
// that a sensible fit never meets.
#pragma once

#include "registration/confidence.hpp"
#include "registration/far_scan.hpp"
#include "registration/gap.hpp"
#include "registration/inner_parts.hpp"
#include "registration/landmark_frame.hpp"
#include "registration/shifted_landmarks.hpp"
#include "registration/trained_span.hpp"
#include "registration/verdict.hpp"

namespace mien {

/// A scan whose size is a head's in no millimetres and in which no known unit shows a face: the
/// unit in which a face is found best. [J]
struct GuessSettings {
    bool enabled = true;
    double smallest_mm = 150, largest_mm = 800;  ///< mm, > 0: extents that are tried
    double step = 1.2;                           ///< > 1: from one to the next
    double sure = 0.65;                          ///< 0 to 1: search score below which none is taken
};

struct RegistrationSettings {
    IntakeSettings intake;
    FarScanSettings far;
    LandmarkFrameSettings frame;
    PriorSettings prior;
    TrainedSpanSettings span;
    ShiftedLandmarkSettings shifted;
    ColorFeatureSettings colors;
    InnerSettings inner;
    StartSettings start;
    GuessSettings guess;
    FitSettings fit;
    GapSettings gap;
    FoldSettings folds;
    ConfidenceSettings confidence;
    VerdictSettings verdict;
};

/// Throws Status::invalid_argument, naming the member and its range.
void check_settings(const RegistrationSettings& settings);

}  // namespace mien
