// What the surroundings of a fitted place tell of it: the other half of the face, the shape that
// the prior expects, where the fit came from, and the landmarks and colours nearby. One number for
// each vertex; fit_measures.hpp averages them over zones.
#pragma once

#include "registration/fit_measures.hpp"

namespace mien {

/// Each #V, in the meaning of the ZoneMeasures of that name; shape2 squared.
struct PlaceMeasures {
    Vector asymmetry_mm, shape2, slid_mm, pin_far_mm, pin_misfit_mm, color_hold, color_doubt;
};

/// Displacement that the prior expects of the kernel (an open jaw; zeros else), #V x 3, model
/// frame. Not of trained modes. O(V K) where it is not zero.
Points expected_opening(const DeformationModel& model, const FitState& state);

/// `opening`: expected_opening(). `whole`: #V, 1 for the vertices of the face, which the mirrored
/// face is laid over. Inner vertices are not asked about pins and colours: far_mm and zeros. O(V (P
/// + F) + V K) for P landmarks, F colour features and K modes.
PlaceMeasures measure_places(const MeasuredFit& finished, const Points& opening,
                             const std::vector<std::uint8_t>& whole,
                             const std::vector<ColorAgreement>& colors,
                             const ZoneMeasureSettings& settings, const Context& context);

}  // namespace mien
