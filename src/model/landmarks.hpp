// Look-up of a template's named places.
#pragma once

#include <string>
#include <vector>

#include "mesh/tri_mesh.hpp"

namespace mien {

/// The first landmark or zone of that name, or null. Names are compared byte by byte.
const Landmark* find_landmark(const std::vector<Landmark>& landmarks, const std::string& name);
const Zone* find_zone(const std::vector<Zone>& zones, const std::string& name);

}  // namespace mien
