// The options of a registration, from the host's struct to the core's settings.
#pragma once

#include <vector>

#include "mien/mien.h"
#include "registration/registration.hpp"

namespace mien::abi {

/// Allocates nothing: it runs in a function that can report nothing. The core's defaults hold no
/// memory of their own (tests/oom/abi_defaults_oom.cpp).
mien_register_options default_register_options();

/// Throws Status::invalid_argument and unsupported_option.
RegistrationSettings register_settings(const mien_register_options& given);

/// The landmarks under the model's own names. Those it does not know keep theirs and are reported.
std::vector<LandmarkPoint> read_landmarks(const mien_register_options& given,
                                          const DeformationModel& model);

}  // namespace mien::abi
