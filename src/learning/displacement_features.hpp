// What an expression adds to a person's neutral face, as features (kosk-2024, 5.1): coordinates
// (expression - neutral) / scale, or the deformation of the person's own neutral face into the
// expression. The thesis deforms the mean face instead; here wrinkles and pores come from the
// person, and turns are right.
#pragma once

#include "learning/blendshapes.hpp"
#include "learning/face_features.hpp"

namespace mien {

/// Both faces in the frame of the neutral faces' mean (onto_mean_shape() of the neutral one; the
/// expression moved alike), before statistics: #V x 3 or #V x 9. A deformation costs a factor of
/// the neutral face.
Features raw_displacement(const FaceFeatures& output, const Points& neutral,
                          const Points& expression, const Context& context);
/// The statistics of displacements over pairs, with mean shape and scale of `neutral`. `kind` is
/// not one that is centred on the mean face.
std::shared_ptr<const FaceFeatures> train_displacements(const FaceFeatures& neutral,
                                                        const FacePairs& pairs, FeatureKind kind,
                                                        FeatureSpread spread,
                                                        const Context& context);
/// The neutral face (in the mean's frame) with the displacement of `features`, which are as a
/// network gives them. A deformation knows no place: its face keeps the neutral one's centre.
Points add_displacement(const FaceFeatures& output, const Points& neutral,
                        const Eigen::Ref<const Features>& features, const Context& context);

}  // namespace mien
