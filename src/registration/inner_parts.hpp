// Stage 6, inner parts: walls that no scanner sees go with the skin before them, and triangles that
// folded are straightened. Measured against what the trained modes make of the template: what they
// fold, faces have been seen to fold, and only the rest has to lie as the template does.
#pragma once

#include "registration/folds.hpp"
#include "registration/prior.hpp"

namespace mien {

struct InnerPartsState {
    Points places;     ///< #V x 3, scan frame
    FoldCounts folds;  ///< before and after straightening
};

/// `places`: after the gap was closed.
InnerPartsState settle_inner_parts(const DeformationModel& model, const PriorState& prior,
                                   const FitState& state, const VertexRings& rings, Points places,
                                   const InnerSettings& inner, const FoldSettings& folds,
                                   const Context& context);

}  // namespace mien
