// The `mien` command's parts. Each file of commands adds its own to the application. Everything
// here stands on include/mien alone.
#pragma once

#include <CLI/CLI.hpp>
#include <mien/mien.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mien::cli {

/// Options that every command has.
struct Common {
    int num_threads = 1;
    std::uint64_t seed = 0;
    std::string json_path;  ///< empty: no machine-readable report
};

/// Adds --threads and --json to a command; --seed where chance is involved.
void add_common_options(CLI::App& command, Common& common, bool with_seed = false);

/// Writes the report where --json asked for it.
void write_report(const Common& common, const nlohmann::json& report);

/// Reads and writes JSON files with errors that name the file.
nlohmann::json read_json(const std::string& path);
void write_json(const std::string& path, const nlohmann::json& value);
/// Writes a text or binary file whole; throws std::runtime_error naming the file.
void write_file(const std::string& path, const std::string& content);

/// Landmark files {"points": {name: [x, y, z]}} of a scan.
struct NamedPoint {
    std::string name;
    Position point;
};
std::vector<NamedPoint> read_landmark_points(const std::string& path);
/// Landmark files {"vertices": {name: index}} of a template.
std::vector<std::pair<std::string, std::uint32_t>> read_landmark_vertices(const std::string& path);
/// Zone files {"zones": {name: [vertex, ...]}}; `beside`: names of lists that may stand beside
/// "zones" and are zones too.
std::vector<std::pair<std::string, std::vector<std::uint32_t>>> read_zones(
    const std::string& path, const std::vector<std::string>& beside = {});

/// One weight per vertex: a plain list, or the list under a key, as `mien register --json` writes
/// "weight".
std::vector<double> read_weights(const std::string& path, const char* key);

/// Vertices of some zones of a zone file, together; `names` are separated by commas.
std::vector<std::uint32_t> zone_vertices(const std::string& path, const std::string& names);
/// A zone file is made for the whole template; a model may cover its first vertices only.
void keep_below(std::vector<std::uint32_t>& vertices, std::uint64_t count);

/// A progress bar on stderr when it is a terminal, else silent.
Progress progress_bar();

// One function per file of commands; main.cpp calls them all.
void add_model_commands(CLI::App& app);
void add_registration_commands(CLI::App& app);
void add_training_commands(CLI::App& app);
void add_expression_commands(CLI::App& app);
void add_measure_commands(CLI::App& app);
void add_score_commands(CLI::App& app);
void add_report_commands(CLI::App& app);
void add_spectral_commands(CLI::App& app);
void add_render_commands(CLI::App& app);

}  // namespace mien::cli
