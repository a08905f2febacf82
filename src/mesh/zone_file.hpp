// Zone files: {"zones": {name: [vertex, ...]}}, perhaps with further lists of vertices beside
// "zones", such as "lips", which are zones of those names.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Zones in the file's order, those beside "zones" last; other text beside them is left alone.
/// Throws Status::io, bad_format (with the zone), invalid_argument for a name that comes twice.
std::vector<Zone> read_zone_file(const std::string& path, const Context& context);

/// The same from memory; `path` is named in errors.
std::vector<Zone> parse_zones(const char* data, std::size_t size, const std::string& path);

/// Writes {"zones": {...}}. Throws Status::io, invalid_argument (a name that is no UTF-8).
void write_zone_file(const std::string& path, const std::vector<Zone>& zones);

}  // namespace mien
