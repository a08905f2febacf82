// A registration as JSON text, for hosts that want everything in one piece.
#pragma once

#include <string>

#include "registration/registration.hpp"

namespace mien {

/// Verdict, motion, energy, per-vertex summaries. Numbers are round-trip exact. `reference`: how it
/// was tied to another visit (tie_json()), or empty.
std::string registration_json(const RegistrationResult& result, const std::string& reference = {});

}  // namespace mien
