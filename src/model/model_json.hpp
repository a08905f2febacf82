// What a deformation model is, as JSON text for hosts and reports.
#pragma once

#include <string>

#include "model/deformation_model.hpp"

namespace mien {

/// {"vertices", "triangles", "scalar_modes", "deformation_modes", "pca_modes", "landmarks": {name:
/// vertex}, "zones": {name: count}, "info": {...}}. Entries of info that are numbers stand as
/// numbers.
std::string model_json(const DeformationModel& model);

/// A plain, finite number of info: no "inf", no hexadecimal, no text around; false for others.
bool read_info_number(const std::string& text, double& value);

}  // namespace mien
