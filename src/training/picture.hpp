// The table as a picture: L1 against DAME on the test people, with the Pareto front.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien::training {

/// A PNG. Throws std::runtime_error when it cannot be written.
void write_table_picture(const std::string& path, const nlohmann::json& table);

}  // namespace mien::training
