// The `mien` command's parts. Each file of commands adds its own to the application. Everything
// here stands on include/mien alone.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <mien/mien.hpp>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mien::cli {

/// What a session had to say beside its results, in order; from whichever thread.
struct SessionWarnings {
    std::mutex guard;
    std::vector<std::string> texts;
};

/// A session whose warnings (a missing texture image, points that were dropped) go to stderr, and
/// are kept for whoever shows them again.
class Session : public mien::Session {
  public:
    explicit Session(int num_threads = 1);
    std::vector<std::string> warnings() const;

  private:
    Session(std::shared_ptr<SessionWarnings> told, int num_threads);
    std::shared_ptr<SessionWarnings> told_;
};

/// Options that every command has.
struct Common {
    int num_threads = 1;
    std::uint64_t seed = 0;
    std::string json_path;   ///< empty: no machine-readable report
    std::string run_record;  ///< empty: the run is not recorded
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

/// By the library's own table of formats, in small or capital letters.
bool is_mesh_name(const std::string& path);

/// The picked landmarks of a file of a scan; of any kind that the library reads.
struct NamedPoint {
    std::string name;
    Position point;
};
std::vector<NamedPoint> read_landmark_points(const std::string& path);
/// The same of a list that was read from `path`.
std::vector<NamedPoint> picked_points(const Landmarks& landmarks, const std::string& path);
/// One line on stderr when a model does not know some of the landmarks; returns it without the
/// file's name, or empty text.
std::string warn_of_unknown_landmarks(const Landmarks& matched, const std::string& path);
/// Landmark files of a template: vertex numbers.
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

/// Prints what makes a mesh a bad template, draws the places when a picture is asked for, and
/// returns the findings of mien_template_check(). An empty path: none.
nlohmann::json print_template_check(const Session& session, const Mesh& mesh,
                                    const std::string& path, const std::string& landmarks,
                                    bool mirror, const std::string& picture);
/// mm per "mm", "cm", "dm", "m", "km", "in" or "ft"; throws std::runtime_error for another name.
double unit_in_mm(const std::string& name);
/// `mien model check`.
void add_template_check(CLI::App& model);
/// `mien model fit|synthesize|condition`.
void add_coefficient_commands(CLI::App& model);
/// `mien measure geodesic`.
void add_geodesic_command(CLI::App& measure);

// One function per file of commands; main.cpp calls them all.
void add_model_commands(CLI::App& app);
void add_registration_commands(CLI::App& app);
void add_batch_commands(CLI::App& app);
void add_transfer_commands(CLI::App& app);
void add_mesh_commands(CLI::App& app);
void add_landmark_commands(CLI::App& app);
void add_training_commands(CLI::App& app);
void add_expression_commands(CLI::App& app);
void add_face_commands(CLI::App& app);
void add_measure_commands(CLI::App& app);
void add_score_commands(CLI::App& app);
void add_network_commands(CLI::App& app);
void add_report_commands(CLI::App& app);
void add_spectral_commands(CLI::App& app);
void add_render_commands(CLI::App& app);

}  // namespace mien::cli
