// The first shape of a fit that no landmark holds: the strongest modes under much assumed noise,
// and a jaw that is tried at several openings.
#pragma once

#include <array>

#include "registration/fit_loop.hpp"
#include "registration/jaw.hpp"

namespace mien {

/// The first, rough fit. Tags in brackets: registration/settings.hpp.
struct ApproachSettings {
    double sigma_mm = 12;      ///< mm, > 0: noise level of its first round; it ends at the fit's
                               ///< first [J]
    int rounds = 30;           ///< >= 1 [J]
    double weight = 0.05;      ///< > 0: independent hits per vertex [J]
    double tangential = 0.02;  ///< 0 to 1 [J]
    Index pca_modes = 40;      ///< >= 0: the strongest trained modes, when there are any, ... [J]
    Index scalar_modes = 20;   ///< >= 0: ... else the strongest kernel modes [J]
    Index stride = 5;          ///< >= 1: one vertex in so many [J]
};

/// Jaws tried after it. [A] as a whole.
struct OpeningSettings {
    bool enabled = true;
    /// deg: an opening of zero starts again without the approach's own idea of the mouth. [J]
    std::array<double, 4> openings_deg{0, 10, 20, 30};
    double amplitude = 2;      ///< > 0: of the kernel, as a jaw moves by centimetres [J]
    double clearly = 0.01;     ///< >= 0: by how much an opening must agree better [J]
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

/// `state` needs a motion and coefficients at full size; fills coefficients, motion and places, and
/// raises the kernel's amplitude (unless the host gave one) where an open jaw has won. Openings are
/// tried for models without trained modes, which know open mouths. `fit`: the settings of the fit
/// that follows, from which those of the approach are derived.
void start_freely(const FitProblem& problem, const PriorState& prior, const LoopSettings& fit,
                  const ApproachSettings& approach, const OpeningSettings& openings,
                  FitState& state, const Context& context);

}  // namespace mien
