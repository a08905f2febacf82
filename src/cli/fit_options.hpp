// How a scan is fitted, as `mien register` and `mien batch` are told: one list of options for both.
#pragma once

#include <optional>

#include "commands.hpp"

namespace mien::cli {

struct FitArguments {
    std::string weights = "none", growth = "constant", units = "detect", start = "automatic";
    double landmark_sigma = 2;
    int max_modes = -1, max_pca_modes = -1, iterations = 0;
    double max_distance = 0, mutual = 0, soft = 0;
    std::optional<double> max_angle;
    bool keep_border = false, no_close_gap = false, no_colors = false, mend_landmarks = false;
    bool accept_failed = false;
};

/// `landmarks`: the option that names landmark files; what is about landmarks needs it.
void add_fit_options(CLI::App& command, FitArguments& arguments, CLI::Option* landmarks);
/// Without landmarks.
RegisterOptions register_options(const FitArguments& arguments);
/// Reads the landmarks of a scan into `options`, those that the model knows; returns what became of
/// them.
nlohmann::json add_landmarks(const Session& session, const Model& model, const std::string& path,
                             RegisterOptions& options);
/// What --json tells of a fit: its verdict, and its numbers for each vertex.
nlohmann::json fit_report(const Registration& fit, bool per_vertex);
/// The verdict in one line: the quality, reasons, notes, the expected error.
std::string verdict_line(const nlohmann::json& report);
std::string first_reason(const nlohmann::json& report);

}  // namespace mien::cli
