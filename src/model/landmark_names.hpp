// Which of a model's landmarks the names of a file mean. Names agree whatever their case, their
// separators and the zeros before their numbers ("Mouth-Outer-0" is "mouth_outer_00"). Numbers
// alone are read in the schemes that people number landmarks by, where the model holds the 68
// names of the scheme (jaw_00 .. mouth_inner_7):
//   iBUG-68 from 1 (its .pts files) or from 0 (dlib, most Python programs)
//   MediaPipe face mesh, 468 or 478 numbers: those 52 that lie where one of the 68 lies. Its jaw
//   runs along the outline of the picture, not along the bone: of it the chin alone is taken.
#pragma once

#include <string>
#include <vector>

#include "mesh/landmark_file.hpp"
#include "model/deformation_model.hpp"

namespace mien {

struct NameMatch {
    /// One per given name: number in the model's landmarks, or -1.
    std::vector<int> landmark;
    /// "names", "iBUG-68 from 1", "iBUG-68 from 0" or "MediaPipe"; empty when nothing matched.
    std::string scheme;
    std::size_t matched = 0;
};

/// Matches names with the model's landmarks. Where numbers could be of more than one scheme, the
/// one whose places lie like the template's is taken. Marks that were not picked take no part in
/// that. Throws Status::invalid_argument when two names mean the same landmark, or when numbers fit
/// two schemes alike. O(names log landmarks).
NameMatch match_landmark_names(const DeformationModel& model, const std::vector<Mark>& marks);

/// "'jaw_00', 'jaw_01', ..., " for messages: some of the model's names, spread over its list.
std::string known_landmark_examples(const DeformationModel& model);

/// Throws Status::not_found with examples of known names when nothing matched.
void require_known_landmark(const DeformationModel& model, const NameMatch& match,
                            const std::vector<Mark>& marks);

}  // namespace mien
