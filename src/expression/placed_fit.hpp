// A face put into the training's frame and taken apart, however it lies and however well it was
// measured.
//
// Pose. A rigid motion is part of the linear fit, v = mean + B c + Z g with Z the six motions of
// the mean face, and eliminated from its normal equations (Schur complement), so that every fit
// method and every component of the mixture answers with the pose that suits it: a dropped jaw is
// not taken for a nod.
//
// Faces that were measured worse than the training faces (hair, a collar, a template that slid).
// Where even the most flexible fit, all expressions at once under a small noise, stays far from a
// vertex, the vertex is wrong, not the person: its weight falls by the Geman-McClure rule (1 +
// (r/k)^2)^-2. Only then the mixture decides. The flexible fit comes first because a fit that still
// believes in a neutral face would call the smile the outlier.
#pragma once

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/fit.hpp"

namespace mien {

/// Where a face lies against the training faces. The numbers are the C ABI's numbers.
enum class Pose : std::int32_t {
    automatic = 0,  ///< aligned on the model's stable zone where it has one; else like `rigid` when
                    ///< the face lies more than 3 degrees or 8 mm away from the mean face and a
                    ///< rigid motion explains it clearly better, else like `keep`
    keep = 1,       ///< in the training's frame
    rigid = 2,      ///< anywhere: a rigid motion is fitted together with identity and expression
};

struct PlacedFit {
    Similarity to_model;
    FitResult fit;
    double residual_rms_mm = 0;  ///< distance of the face from the fitted model per vertex
    double noise_mm2 = 0;        ///< of the fit; 0 for fits without a prior
    double doubted_share =
        0;  ///< of the given weights, taken away from vertices that nothing explains
};

/// Vertices and weights as check_face() accepts them. Throws as fit_face().
PlacedFit place_and_fit(const Context& context, const ExpressionModel& model,
                        const PointsRef& vertices, const Vector& weights_per_vertex,
                        const FitOptions& options, Pose pose);

}  // namespace mien
