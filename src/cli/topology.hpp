// A face in one template's topology as a face in another's: by where each vertex of the other
// template lies on this one, found once and kept in a file.
#pragma once

#include "commands.hpp"

namespace mien::cli {

struct TopologyArguments {
    std::string model;           ///< whose template the face was fitted with
    std::string fitted;          ///< the face
    std::string to;              ///< the other template, fitted to this model's template
    std::string correspondence;  ///< file to write, or to read when `to` is empty
    std::string out;             ///< mesh to write
};

/// Writes the face in the other topology, the correspondence, or both; returns what was done.
nlohmann::json transfer_topology(const Session& session, const TopologyArguments& arguments);

/// The 52 names that face trackers drive, in their customary order.
const std::vector<std::string>& face_tracking_names();
/// Files called by those names in their order; throws std::runtime_error unless all are there, and
/// no other.
std::vector<std::string> in_tracking_order(const std::vector<std::string>& sources);

}  // namespace mien::cli
