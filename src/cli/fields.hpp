// Fields: one number per vertex, in files and as pictures.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "commands.hpp"
#include "render.hpp"

namespace mien::cli {

/// One number per vertex: JSON ([..] or {"values": [..]}, null: no value) or text, separated by
/// space, comma or line.
std::vector<double> read_field(const std::string& path);

/// How a field is drawn.
struct FieldPicture {
    std::string label;       ///< beside the colour bar, with its unit
    std::string title;       ///< above the views
    bool is_signed = false;  ///< blue - white - red about zero
    double low = std::numeric_limits<double>::quiet_NaN();  ///< of the colours; NaN: from the data
    std::vector<Position> points;                           ///< drawn as dots
};

/// Draws the field on the mesh as `mien render --scalar` does, seen from three sides; nothing for
/// an empty path. Infinite values are grey.
void draw_field(const std::string& path, const Mesh& mesh, std::vector<double> field,
                const FieldPicture& how);

struct FieldSummary {
    double least = 0, mean = 0, most = 0;  ///< of the finite values
};
FieldSummary summary_of(const std::vector<double>& field);
nlohmann::json summary_json(const FieldSummary& summary);

}  // namespace mien::cli
