#include "run_record.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "report_words.hpp"

namespace mien::cli {
namespace {

namespace fs = std::filesystem;
constexpr int kRunFormat = 1;
constexpr const char* kOption = "--run-record";

/// The paths that an argument may name: itself, what stands behind its "=", the parts of a list.
std::vector<std::string> paths_of(const std::string& argument) {
    std::vector<std::string> paths{argument};
    std::string value = argument;
    if (argument.rfind("--", 0) == 0 && argument.find('=') != std::string::npos) {
        value = argument.substr(argument.find('=') + 1);
        paths.push_back(value);
    }
    if (value.find(',') != std::string::npos)
        for (std::size_t begin = 0; begin <= value.size();) {
            const std::size_t end = std::min(value.find(',', begin), value.size());
            paths.push_back(value.substr(begin, end - begin));
            begin = end + 1;
        }
    return paths;
}

/// Regular files that the arguments name, and all in the folders that they name.
std::set<std::string> files_named(const std::vector<std::string>& arguments) {
    std::set<std::string> files;
    std::error_code none;
    for (const std::string& argument : arguments)
        for (const std::string& path : paths_of(argument)) {
            if (path.empty()) continue;
            const fs::path given = fs::u8path(path);
            if (fs::is_regular_file(given, none)) files.insert(path);
            if (fs::is_directory(given, none))
                for (const auto& entry : fs::recursive_directory_iterator(given))
                    if (entry.is_regular_file()) files.insert(entry.path().u8string());
        }
    return files;
}

std::int64_t time_of(const std::string& path) {
    return static_cast<std::int64_t>(
        fs::last_write_time(fs::u8path(path)).time_since_epoch().count());
}

nlohmann::json described(const Session& session, const std::string& path) {
    return {{"path", path},
            {"bytes", fs::file_size(fs::u8path(path))},
            {"sha256", session.hash_file(path)}};
}

/// The command that was run, and all of its options with their values or defaults.
void describe_command(const CLI::App& app, nlohmann::json& record) {
    const CLI::App* command = &app;
    std::string name;
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        name += (name.empty() ? "" : " ") + command->get_name();
    }
    record["command"] = name;
    for (const CLI::Option* option : command->get_options()) {
        const std::string key = option->get_name(false, true);
        if (key == "--help" || key.find(kOption) != std::string::npos) continue;
        if (option->count() == 0)
            record["options"][key] = option->get_default_str();
        else if (option->results().size() == 1)
            record["options"][key] = valid_utf8(option->results().front());
        else
            for (const std::string& value : option->results())
                record["options"][key].push_back(valid_utf8(value));
    }
}

std::string read_bytes(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path.u8string() + ": cannot be opened for reading");
    return std::string(std::istreambuf_iterator<char>(in), {});
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// A folder of its own for what is written again, removed at the end.
class Scratch {
  public:
    Scratch() {
        std::random_device chance;
        for (int attempt = 0; attempt < 100; ++attempt) {
            path_ = fs::temp_directory_path() / ("mien-replay-" + std::to_string(chance()));
            if (fs::create_directory(path_)) return;
        }
        throw std::runtime_error(path_.u8string() + ": no folder for the files to compare");
    }
    ~Scratch() {
        std::error_code none;
        fs::remove_all(path_, none);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The recorded run, made again beside what it wrote then.
class Replay {
  public:
    Replay(std::string path, const nlohmann::json& record)
        : path_(std::move(path)), record_(record) {
        if (!record.is_object() || record.value("mien_run", 0) != kRunFormat)
            throw std::runtime_error(path_ + ": is no record of a run (" + kOption +
                                     " of any command writes one)");
        for (const nlohmann::json& output : record["outputs"])
            outputs_.push_back(output["path"].get<std::string>());
    }

    /// Why the run cannot be made again: files that are gone or others now.
    std::vector<std::string> changed_inputs() const {
        std::vector<std::string> changed;
        for (const nlohmann::json& input : record_["inputs"]) {
            const auto path = input["path"].get<std::string>();
            std::error_code none;
            if (!fs::is_regular_file(fs::u8path(path), none))
                changed.push_back(path + " is not there");
            else if (session_.hash_file(path) != input["sha256"])
                changed.push_back(path + " is another file now" +
                                  (written(path) ? ": the run itself has changed it" : ""));
        }
        return changed;
    }

    /// The arguments, with everything that was written going to the scratch folder.
    std::vector<std::string> arguments() {
        std::vector<std::string> changed;
        for (const auto& entry : record_["arguments"]) {
            auto argument = entry.get<std::string>();
            const std::size_t value = argument.rfind("--", 0) == 0 ? argument.find('=') : 0;
            const std::size_t begin = value == 0 || value == std::string::npos ? 0 : value + 1;
            argument.replace(begin, std::string::npos, moved(argument.substr(begin)));
            changed.push_back(argument);
        }
        return changed;
    }

    /// What is not as it was, one line per file.
    std::vector<std::string> differences() const {
        std::vector<std::string> found;
        for (const nlohmann::json& output : record_["outputs"]) {
            const auto path = output["path"].get<std::string>();
            const fs::path again = there(path);
            std::error_code none;
            if (again.empty() || !fs::is_regular_file(again, none)) {
                found.push_back(path + " was not written");
                continue;
            }
            std::string bytes = read_bytes(again);
            // A report may name the files beside it.
            for (const auto& [from, to] : moved_) replace_all(bytes, to, from);
            const fs::path restored = scratch_.path() / "compared";
            write_file(restored.u8string(), bytes);
            if (session_.hash_file(restored.u8string()) != output["sha256"])
                found.push_back(path + " differs (" + std::to_string(bytes.size()) + " bytes, " +
                                std::to_string(output["bytes"].get<std::uint64_t>()) + " then)");
        }
        return found;
    }

    std::size_t count() const { return outputs_.size(); }
    std::string software() const { return record_.value("software", ""); }

  private:
    bool written(const std::string& path) const {
        return std::find(outputs_.begin(), outputs_.end(), path) != outputs_.end();
    }
    /// Where an argument's path goes: a file that was written, or a folder with such files.
    std::string moved(const std::string& path) {
        const bool above =
            !path.empty() && std::any_of(outputs_.begin(), outputs_.end(), [&](const auto& file) {
                return file.rfind(path + "/", 0) == 0;
            });
        if (path.empty() || (!written(path) && !above)) return path;
        const fs::path folder = scratch_.path() / std::to_string(moved_.size());
        fs::create_directory(folder);
        const std::string name = fs::u8path(path).filename().u8string();
        std::string to = (folder / fs::u8path(name.empty() ? "out" : name)).u8string();
        moved_[path] = to;
        return to;
    }
    fs::path there(const std::string& output) const {
        for (const auto& [from, to] : moved_) {
            if (output == from) return fs::u8path(to);
            if (output.rfind(from + "/", 0) == 0)
                return fs::u8path(to + output.substr(from.size()));
        }
        return {};
    }

    std::string path_;
    const nlohmann::json& record_;
    Session session_;
    Scratch scratch_;
    std::vector<std::string> outputs_;
    std::map<std::string, std::string> moved_;
};

void print_lines(const char* what, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::printf("%s: %s\n", what, line.c_str());
}

void run_replay(const std::string& path, const Common& common, const RunCommand& run) {
    const nlohmann::json record = read_json(path);
    Replay replay(path, record);
    const std::string software = mien_build_id();
    const bool same_software = software == replay.software();
    if (!same_software)
        std::printf("software: %s, recorded with %s\n", software.c_str(),
                    replay.software().c_str());
    const std::vector<std::string> inputs = replay.changed_inputs();
    nlohmann::json report{{"record", path},
                          {"software", software},
                          {"recorded_with", replay.software()},
                          {"inputs_changed", inputs}};
    print_lines("input", inputs);
    if (!inputs.empty()) {
        write_report(common, report);
        throw std::runtime_error(path +
                                 ": cannot be made again, its inputs have changed (see above)");
    }
    if (const int status = run(replay.arguments()); status != 0)
        throw std::runtime_error(path + ": the command ended with exit status " +
                                 std::to_string(status) +
                                 ", which it did not when it was recorded");
    const std::vector<std::string> differences = replay.differences();
    report["differences"] = differences;
    write_report(common, report);
    print_lines("output", differences);
    if (!differences.empty())
        throw std::runtime_error(path + ": " + std::to_string(differences.size()) + " of " +
                                 std::to_string(replay.count()) + " files differ" +
                                 (same_software ? " although the software is the same"
                                                : "; the software is another one"));
    std::printf("%s: the same bits, %zu files\n", path.c_str(), replay.count());
}

}  // namespace

RunRecord::RunRecord(std::vector<std::string> arguments) {
    const std::string with_value = std::string(kOption) + "=";
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        if (arguments[k] == kOption && k + 1 < arguments.size())
            path_ = arguments[++k];
        else if (arguments[k].rfind(with_value, 0) == 0)
            path_ = arguments[k].substr(with_value.size());
        else
            arguments_.push_back(arguments[k]);
    }
    if (path_.empty()) return;
    const Session session;
    before_ = nlohmann::json::array();
    for (const std::string& file : files_named(arguments_)) {
        nlohmann::json entry = described(session, file);
        entry["time"] = time_of(file);
        before_.push_back(std::move(entry));
    }
}

void RunRecord::finish(const CLI::App& app) const {
    if (path_.empty()) return;
    const Session session;
    nlohmann::json record{{"mien_run", kRunFormat},
                          {"arguments", arguments_},
                          {"software", mien_build_id()},
                          {"version", mien_version_string()},
                          {"inputs", nlohmann::json::array()},
                          {"outputs", nlohmann::json::array()}};
    describe_command(app, record);
    std::map<std::string, nlohmann::json> before;
    for (const nlohmann::json& entry : before_) before[entry["path"].get<std::string>()] = entry;
    for (const std::string& file : files_named(arguments_)) {
        const auto known = before.find(file);
        // A file that was written has a time of its own, even when its bytes are as before.
        const bool was_written = known == before.end() || known->second["time"] != time_of(file);
        if (was_written) record["outputs"].push_back(described(session, file));
    }
    for (auto& [file, entry] : before) {
        std::error_code none;
        // What stood at the place of an output is none of the run's business.
        const bool replaced = std::any_of(
            record["outputs"].begin(), record["outputs"].end(),
            [&name = file](const nlohmann::json& output) { return output["path"] == name; });
        if (replaced) continue;
        entry.erase("time");
        record["inputs"].push_back(entry);
    }
    write_json(path_, record);
}

void add_replay_command(CLI::App& app, RunCommand run) {
    struct Arguments {
        std::string record;
        Common common;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("replay", "make a recorded run again: the same bits, or what differs");
    command->add_option("record", arguments->record, "what --run-record of a command wrote")
        ->required()
        ->check(CLI::ExistingFile);
    command->add_option("--json", arguments->common.json_path,
                        "write a machine-readable report to this file");
    command->footer(
        "Example: mien register --model face.safetensors --scan scan.ply --out fitted.ply "
        "--run-record run.json\n"
        "         mien replay run.json\n"
        "Run it in the folder where the run was recorded. Its files are written to a folder of "
        "their own and compared; nothing is overwritten.");
    command->callback([arguments, run] { run_replay(arguments->record, arguments->common, run); });
}

}  // namespace mien::cli
