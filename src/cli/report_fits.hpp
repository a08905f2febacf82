// The visits of a folder as registrations: scans are registered, records and fitted meshes are
// read.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"

namespace mien::cli {

struct Capture {
    std::string mesh;       ///< or a record that `mien register --record` wrote
    std::string landmarks;  ///< or what `mien register --json` wrote; empty: nothing lies beside it
};
struct Visit {
    std::string name;
    std::vector<Capture> captures;
};

/// One visit per entry of the folder, in the order of their names; throws unless there are two.
std::vector<Visit> find_visits(const std::string& folder);

struct Fitted {
    Registration fit;
    std::string verdict;  ///< in words
    bool good = true;
    nlohmann::json report;  ///< null for meshes that were fitted beforehand
};

/// Registers a scan.
Fitted fit_scan(const Session& session, const Model& model, const Capture& capture);

/// A fit that is there already: a record, or a mesh with what `mien register --json` wrote beside
/// it. A bare mesh lies within sd_mm of the skin; without sd_mm nothing is known of its errors.
Fitted read_fitted(const Session& session, const Capture& capture, std::optional<double> sd_mm);

/// True for files that `mien register --record` writes, by their name.
bool is_record(const std::string& path);

}  // namespace mien::cli
