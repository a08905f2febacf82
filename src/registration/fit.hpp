// Stage 4, fit: the template onto the scan by all evidence there is (fit_loop.hpp, evidence.hpp).
#pragma once

#include "registration/start.hpp"

namespace mien {

/// Weights of a fit that no landmark holds: its hits slide together, so they tell less, and colours
/// tell more. [A] as a whole.
struct FreeFitSettings {
    double surface_weight = 0.02;  ///< > 0: instead of SurfaceEvidenceSettings::weight
    double color_weight = 0.13;    ///< >= 0: instead of ColorEvidenceSettings::weight
};

struct FitSettings {
    LoopSettings loop;
    FreeFitSettings free;
};

struct FitOutcome {
    FitState state;
    FitTrace trace;
};

/// The loop's settings for this start.
LoopSettings loop_for(const FitSettings& settings, bool is_free);

/// From the start's state on. Throws Status::no_solution when the equations have none.
FitOutcome fit_surface(const DeformationModel& model, const PriorState& prior,
                       const StartState& start, const FitSettings& settings,
                       const Context& context);

}  // namespace mien
