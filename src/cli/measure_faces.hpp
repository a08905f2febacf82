// What the commands that measure faces share: faces with their errors, zones, fields.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report_fits.hpp"

namespace mien::cli {

/// A face and what is known of its errors at each vertex, mm.
struct KnownFace {
    Mesh mesh;
    std::vector<double> sd_mm;        ///< along the normal; empty: not known
    std::vector<double> place_sd_mm;  ///< of the place, per axis; empty: not known
};

/// A record of a fit, a fitted mesh with what `mien register --json` wrote beside it (json), or a
/// bare mesh that lies within sd_mm everywhere.
KnownFace read_known_face(const Session& session, const std::string& path, const std::string& json,
                          const std::optional<double>& sd_mm);

std::vector<MeasureZone> measure_zones(const std::string& path);

/// One value per vertex, one per line: what `mien render --scalar` reads.
void write_field(const std::string& path, const std::vector<double>& values);

void add_anthropometry_commands(CLI::App& measure);

}  // namespace mien::cli
