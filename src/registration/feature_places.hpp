// Where the brows and the lips of a template lie, by its named landmarks and zones.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "model/deformation_model.hpp"

namespace mien {

/// #V: how far each vertex lies inside of the band of `half_mm` about the line through brow_SIDE_0
/// .. 4, mm, negative outside; empty when the model does not name them. `side`: right or left.
std::vector<double> inside_brow_mm(const DeformationModel& model, const std::string& side,
                                   double half_mm);

/// The same for the lips: inside of the zone "lips" (the vermilion), else of the ring
/// mouth_outer_00 .. 11, seen along the ring's normal and no farther from it than `depth_mm` (the
/// throat and the nape lie within the ring too, seen from the front); empty when the model has
/// neither. O(#V log of the rim).
std::vector<double> inside_lips_mm(const DeformationModel& model, double depth_mm,
                                   const Context& context);

}  // namespace mien
