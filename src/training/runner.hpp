// Runs configurations one after the other into folders, and puts their errors into one table with
// the linear model of the same size. What is finished is not done again; what was interrupted goes
// on where it stood.
#pragma once

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "training/configuration.hpp"

namespace mien::training {

/// Trains (or goes on), evaluates on training and test people, writes network.safetensors (last
/// epoch), best.safetensors (least validation loss) and result.json into folder/NAME. Gives the
/// row; null when `stop` came first.
nlohmann::json run_configuration(const Configuration& configuration, const std::string& folder,
                                 const std::atomic<bool>& stop);

/// The linear model of the configuration's code size on plain coordinates.
Configuration pca_of(const Configuration& configuration);

/// In front of the configurations those rows that every table needs and that they lack: the linear
/// model, or of expressions the rivals without training (kRivals).
std::vector<Configuration> with_rivals(std::vector<Configuration> configurations);

/// Marks rows that no other beats in both L1 and DAME ("on_front"), and adds "findings": sentences
/// about the linear model and about the orders that kosk-2024 found (9.2 of the specification).
nlohmann::json finish_table(std::vector<nlohmann::json> rows);
/// What a perfect predictor reaches on the data (data.oracle), in words; empty without such a file.
std::string oracle_text(const DataChoice& data);
std::string table_text(const nlohmann::json& table);

}  // namespace mien::training
