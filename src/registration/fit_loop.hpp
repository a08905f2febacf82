// The loop of a fit (non-rigid ICP, 2.5): correspond, gather evidence, solve, move, with more modes
// and less assumed noise each round.
//
// Of `rounds` rounds the k-th assumes the noise sigma_start (sigma_end / sigma_start)^f with
// f = k / (rounds - 1), and looks at one vertex in `sparse_stride` while f < sparse_share, because
// the modes that matter then are smooth.
#pragma once

#include <vector>

#include "registration/evidence.hpp"
#include "registration/prior.hpp"

namespace mien {

/// (2.15). The numbers are the C ABI's numbers.
enum class ModeGrowth : std::int32_t { constant = 0, linear = 1, exponential = 2, cubic = 3 };

/// Tags in brackets: registration/settings.hpp.
struct LoopSettings {
    int rounds = 16;                 ///< 1 to 10000 [J]
    double sigma_start_mm = 3;       ///< mm, > 0: noise level of a surface hit, first ... [J]
    double sigma_end_mm = 0.5;       ///< ... and last [J]
    double robust_factor = 2;        ///< > 0: robust scale in noise levels [J]
    double reach = 4;                ///< > 0, robust scales: farther hits are not looked for [J]
    double stop_movement_mm = 0.01;  ///< mm, >= 0: mean movement that ends the last noise level [J]
    ModeGrowth growth = ModeGrowth::constant;  ///< [T] table "Growing modes"
    Index first_modes = 10;                    ///< >= 1: scalar modes that a growth begins with [J]
    double sparse_share = 0.85;   ///< >= 0, share of the way: sparse rounds; above 1: all [J]
    Index sparse_stride = 3;      ///< >= 1 [J]
    double tolerance = 0.1;       ///< 0 to 1: by how much a round reduces its equations' residual;
                                  ///< the next goes on [J]
    double last_tolerance = 0.1;  ///< times that in the last round [J]
    CorrespondenceSettings match;
    EvidenceSettings evidence;
    SolverSettings solver;
};

/// What a fit leaves besides its state.
struct FitTrace {
    Vector weight;               ///< #V, or #rows of a sparse last round: the last round's weights
    std::vector<double> energy;  ///< one per round: weighted mean squared distance, mm^2
    int rounds = 0;
    double sigma_mm = 0;  ///< last noise level
};

/// Number of scalar modes at progress f in [0, 1] of the way to `all`.
Index modes_at(ModeGrowth growth, double f, Index first, Index all);

/// Improves `state` from its motion and coefficients on. Throws Status::no_solution when the
/// equations have none.
FitTrace run_fit(const FitProblem& problem, const FitFreedom& freedom, const LoopSettings& settings,
                 FitState& state, const Context& context);

/// Tags in brackets: registration/settings.hpp.
struct PinFitSettings {
    int rounds = 3;              ///< >= 1 [J]
    Index other_vertices = 500;  ///< >= 1: beside the pins, to hold the motion's centre [J]
    SolverSettings solver;
};

/// Deforms towards the pins alone: the posterior mean given the landmarks (2.2.3).
void fit_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const FitFreedom& freedom, const PinFitSettings& settings, FitState& state,
              const Context& context);

}  // namespace mien
