#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "commands.hpp"
#include "image.hpp"

#if defined(_WIN32)
#include <io.h>
#else
#include <unistd.h>
#endif

namespace mien::cli {
namespace {

bool stderr_is_terminal() {
#if defined(_WIN32)
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(fileno(stderr)) != 0;
#endif
}

const char* stage_name(int stage) {
    switch (stage) {
        case MIEN_STAGE_READING:
            return "reading";
        case MIEN_STAGE_GEODESICS:
            return "geodesics";
        case MIEN_STAGE_BASIS:
            return "basis";
        case MIEN_STAGE_ALIGNMENT:
            return "alignment";
        case MIEN_STAGE_FITTING:
            return "fitting";
        case MIEN_STAGE_REFINING:
            return "refining";
        case MIEN_STAGE_TRAINING:
            return "training";
        case MIEN_STAGE_NEUTRALIZING:
            return "neutralizing";
        case MIEN_STAGE_MEASURING:
            return "measuring";
        case MIEN_STAGE_WRITING:
            return "writing";
        default:
            return "working";
    }
}

/// The object under `key`, or an error that shows what the file should hold.
const nlohmann::json& section(const nlohmann::json& file, const std::string& path, const char* key,
                              const char* shape) {
    if (!file.is_object() || !file.contains(key) || !file[key].is_object())
        throw std::runtime_error(path + ": expected {\"" + key + "\": " + shape + "}");
    return file[key];
}

std::uint32_t as_vertex(const nlohmann::json& value, const std::string& path,
                        const std::string& name) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xFFFFFFFFu)
        throw std::runtime_error(path + ": '" + name + "' holds " + value.dump() +
                                 ", which is not a vertex number");
    return value.get<std::uint32_t>();
}

/// Called through C: must not throw.
void MIEN_CALL print_warning(void* told, std::int32_t level, const char* message) {
    if (level > MIEN_LOG_WARNING) return;
    std::fprintf(stderr, "mien: %s\n", message);
    try {
        auto& warnings = *static_cast<SessionWarnings*>(told);
        const std::lock_guard<std::mutex> lock(warnings.guard);
        warnings.texts.emplace_back(message);
    } catch (...) {  // no memory for a copy: it was printed
    }
}

}  // namespace

Session::Session(int num_threads) : Session(std::make_shared<SessionWarnings>(), num_threads) {}

Session::Session(std::shared_ptr<SessionWarnings> told, int num_threads)
    : mien::Session(num_threads, 0, &print_warning, told.get()), told_(std::move(told)) {}

std::vector<std::string> Session::warnings() const {
    const std::lock_guard<std::mutex> lock(told_->guard);
    return told_->texts;
}

void add_common_options(CLI::App& command, Common& common, bool with_seed) {
    command
        .add_option("--threads", common.num_threads, "threads to use; results do not depend on it")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command.add_option("--json", common.json_path, "write a machine-readable report to this file");
    // Read by main(), which sees the files before and after the run.
    command.add_option("--run-record", common.run_record,
                       "keep the hashes of all files, the options and the software in this file, "
                       "for mien replay");
    if (with_seed)
        command.add_option("--seed", common.seed, "seed of all chance")->capture_default_str();
}

void write_report(const Common& common, const nlohmann::json& report) {
    if (!common.json_path.empty()) write_json(common.json_path, report);
}

bool is_mesh_name(const std::string& path) {
    const std::size_t dot = path.find_last_of("./\\");
    if (dot == std::string::npos || path[dot] != '.') return false;
    std::string extension = path.substr(dot + 1);
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    for (std::uint32_t k = 0; k < mien_mesh_format_count(); ++k)
        if (extension == mien_mesh_format_extension(k)) return true;
    return false;
}

nlohmann::json read_json(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path + ": cannot be opened for reading");
    try {
        // Of two values under one name the parser would keep the last, without a word.
        std::vector<std::set<std::string>> names;
        return nlohmann::json::parse(
            in, [&](int, nlohmann::json::parse_event_t event, nlohmann::json& value) {
                if (event == nlohmann::json::parse_event_t::object_start) names.emplace_back();
                if (event == nlohmann::json::parse_event_t::object_end) names.pop_back();
                if (event == nlohmann::json::parse_event_t::key &&
                    !names.back().insert(value.get<std::string>()).second)
                    throw std::runtime_error(path + ": the name " + value.dump() +
                                             " stands there twice in one object; keep one");
                return true;
            });
    } catch (const nlohmann::json::exception& failure) {
        throw std::runtime_error(path + ": is not JSON (" + failure.what() + ")");
    }
}

void write_file(const std::string& path, const std::string& content) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) throw std::runtime_error(path + ": cannot be written");
}

void write_png(const std::string& path, const Image& image) {
    write_file(path, encode_png(image));
}

void write_json(const std::string& path, const nlohmann::json& value) {
    write_file(path, value.dump(2) + "\n");
}

std::vector<double> read_weights(const std::string& path, const char* key) {
    const nlohmann::json file = read_json(path);
    const nlohmann::json& list = file.is_object() && file.contains(key) ? file[key] : file;
    if (!list.is_array())
        throw std::runtime_error(path + ": expected [w, ...] or {\"" + key + "\": [w, ...]}");
    std::vector<double> weights;
    for (const nlohmann::json& value : list) {
        if (!value.is_number())
            throw std::runtime_error(path + ": " + value.dump() + " is not a weight");
        weights.push_back(value.get<double>());
    }
    return weights;
}

std::vector<std::pair<std::string, std::vector<std::uint32_t>>> read_zones(
    const std::string& path, const std::vector<std::string>& beside) {
    const nlohmann::json file = read_json(path);
    std::vector<std::pair<std::string, std::vector<std::uint32_t>>> zones;
    const auto add = [&](const std::string& name, const nlohmann::json& list) {
        if (!list.is_array())
            throw std::runtime_error(path + ": zone '" + name + "' is not a list");
        std::vector<std::uint32_t> vertices;
        for (const nlohmann::json& value : list) vertices.push_back(as_vertex(value, path, name));
        zones.emplace_back(name, std::move(vertices));
    };
    const nlohmann::json& listed = section(file, path, "zones", "{name: [vertex, ...]}");
    for (const auto& [name, list] : listed.items()) add(name, list);
    for (const std::string& name : beside)
        if (file.contains(name) && !listed.contains(name)) add(name, file[name]);
    return zones;
}

Progress progress_bar() {
    if (!stderr_is_terminal()) return {};
    return [](int stage, double fraction) {
        std::fprintf(stderr, "\r%-14s %3.0f%%", stage_name(stage), 100 * fraction);
        if (fraction >= 1) std::fputs("\r                    \r", stderr);
        std::fflush(stderr);
        return true;
    };
}

std::vector<std::uint32_t> zone_vertices(const std::string& path, const std::string& names) {
    std::vector<std::uint32_t> vertices;
    if (names.empty()) return vertices;
    if (path.empty()) throw std::runtime_error("zone names need a zone file: give --zones");
    const auto zones = read_zones(path, {"lips"});
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        const std::string name = names.substr(begin, end - begin);
        const auto zone = std::find_if(zones.begin(), zones.end(),
                                       [&](const auto& entry) { return entry.first == name; });
        if (zone == zones.end()) throw std::runtime_error(path + ": has no zone '" + name + "'");
        vertices.insert(vertices.end(), zone->second.begin(), zone->second.end());
        begin = end + 1;
    }
    return vertices;
}

void keep_below(std::vector<std::uint32_t>& vertices, std::uint64_t count) {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                                  [count](std::uint32_t vertex) { return vertex >= count; }),
                   vertices.end());
}

}  // namespace mien::cli
