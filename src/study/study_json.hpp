// A study as JSON text: the recipe, the visits, and what changed in each zone since the first.
#pragma once

#include <string>

#include "study/study.hpp"

namespace mien {

/// UTF-8; numbers are the shortest that read back the same; what is not known is null.
std::string study_json(const Study& study);

}  // namespace mien
