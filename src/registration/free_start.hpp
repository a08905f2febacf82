// The first shape of a fit that no landmark holds: the strongest modes under much assumed noise,
// and a jaw that is searched for (jaw_search.hpp).
#pragma once

#include "registration/jaw_search.hpp"

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

/// `state` needs a motion and coefficients at full size; fills coefficients, motion and places, and
/// where an open jaw has won the coefficients that the prior expects. Openings are tried for models
/// without trained modes, which know open mouths. `fit`: the settings of the fit that follows, from
/// which those of the approach are derived.
void start_freely(const FitProblem& problem, const PriorState& prior, const LoopSettings& fit,
                  const ApproachSettings& approach, const OpeningSettings& openings,
                  FitState& state, const Context& context);

}  // namespace mien
