// How far the jaw of a scan is open, for fits without landmarks: a closest point never finds a lip
// that has gone down by more than its own height, and a chin that no prior leads stays behind it.
#pragma once

#include <array>

#include "registration/fit_loop.hpp"
#include "registration/jaw.hpp"

namespace mien {

/// Jaws tried after it: an opening is the mean of the prior, so that the chin goes with the lips,
/// and of several the likeliest is taken and turned on. [T] table "Open jaws"; one by one [J].
struct OpeningSettings {
    bool enabled = true;
    /// deg: an opening of zero starts again without the approach's own idea of the mouth.
    std::array<double, 4> openings_deg{0, 10, 20, 30};
    double amplitude = 2;  ///< > 0: of the kernel in a jaw's own shape, which moves by centimetres
    double hits = 600;     ///< > 0: independent hits that the agreement stands for, against the
                           ///< prior's half squared deviations. [T] 300 loses an open jaw of
                           ///< five, 1000 is the same
    int steps = 6;         ///< >= 0: of the opening towards the likeliest, at most
    double slope_deg = 5;  ///< deg, > 0: over which a jaw's turn is taken to be straight
    double overshoot = 1.5;    ///< > 0: of a step, as the deformation holds on to the last opening
    double most_deg = 40;      ///< deg, > 0: no jaw opens farther
    double settled_deg = 0.5;  ///< deg, >= 0: a smaller step ends them
    double least_deg = 3;      ///< deg, >= 0: a jaw that opens less is taken to be shut
    double sigma_mm = 4;       ///< mm, > 0: noise level of the first round [J]
    int rounds = 12;           ///< >= 1 [J]
    double tangential = 0.05;  ///< 0 to 1 [J]
    Index scalar_modes = 80;   ///< >= 0 [J]
    // Agreement with the scan: mean over the open skin near the nose's tip of
    // exp(-d^2 / 2 s^2) cos^4 of the normals. Unlike a residual it counts what has found no scan.
    double scale_mm = 2;       ///< s, mm, > 0 [J]
    double radius_mm = 100;    ///< mm, > 0: about the tip [J]
    double reach = 4;          ///< > 0, scales [J]
    double color_share = 0.1;  ///< >= 0: of the colours' mean agreement, added [J]
    JawSettings jaw;
    PinFitSettings pins;
};

/// Puts into `rough`, a first fit from `start` (motion and coefficients at full size, at rest), the
/// likeliest jaw: coefficients, motion, places, and with an open one the coefficients that the
/// prior expects. Leaves it alone where the model does not name the jaw (jaw.hpp). `loop`: of each
/// trial. A dozen of these fits.
void search_jaw(const FitProblem& problem, const PriorState& prior, const LoopSettings& loop,
                const OpeningSettings& settings, const FitState& start, FitState& rough,
                const Context& context);

}  // namespace mien
