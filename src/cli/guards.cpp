#include "guards.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace mien::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNumber = R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)";

/// Digits, a point, an exponent of ten; and a value that a double holds.
std::string refuse_number(const std::string& text, const char* grammar, const char* wanted) {
    if (!std::regex_match(text, std::regex(grammar)) ||
        !std::isfinite(std::strtod(text.c_str(), nullptr)))
        return "'" + text + "' is not " + wanted;
    return {};
}

CLI::Validator validator(const char* grammar, const char* wanted) {
    return CLI::Validator(
        [grammar, wanted](std::string& text) { return refuse_number(text, grammar, wanted); }, "");
}

bool begins_with(const std::string& text, const char* beginning) {
    return text.rfind(beginning, 0) == 0;
}

std::string name_of(const CLI::Option& option) {
    return option.get_lnames().empty() ? option.get_single_name() : option.get_lnames()[0];
}

/// Pictures are PNG files.
bool is_picture(const CLI::App& command, const CLI::Option& option) {
    static const std::vector<std::string> kPictures = {"heatmap", "picture", "check-picture",
                                                       "plot", "confusion"};
    const std::string name = name_of(option);
    return (command.get_name() == "render" && name == "out") ||
           std::find(kPictures.begin(), kPictures.end(), name) != kPictures.end();
}

bool is_png_name(const std::string& path) {
    std::string end = path.size() < 4 ? path : path.substr(path.size() - 4);
    for (char& c : end) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    std::error_code none;
    return end == ".png" || fs::is_other(fs::u8path(path), none);
}

/// What a command writes, by the option's name; CLI11 does not know which options these are.
bool is_output(const CLI::App& command, const CLI::Option& option) {
    static const std::vector<std::string> kWritten = {"json", "run-record", "record", "field"};
    const std::string name = name_of(option);
    if (is_picture(command, option)) return true;
    if (name == "out" || (name.size() > 4 && name.compare(name.size() - 4, 4, "-out") == 0))
        return true;
    if (command.get_name() == "split" && (name == "low" || name == "high")) return true;
    return std::find(kWritten.begin(), kWritten.end(), name) != kWritten.end();
}

struct NamedFile {
    std::string option, path;
};

/// One file under two names, through links and dots too. What is no file, such as a null device,
/// takes any number of results.
bool same_file(const std::string& first, const std::string& second) {
    std::error_code none;
    const fs::path a = fs::u8path(first), b = fs::u8path(second);
    const bool there = fs::exists(a, none), too = fs::exists(b, none);
    if (there && too) return fs::is_regular_file(a, none) && fs::equivalent(a, b, none);
    if (there != too) return false;
    const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, none), none);
    const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, none), none);
    return !whole_a.empty() && whole_a == whole_b;
}

}  // namespace

std::optional<double> plain_number(const std::string& word) {
    if (!refuse_number(word, kNumber, "").empty()) return std::nullopt;
    return std::strtod(word.c_str(), nullptr);
}

void guard_numbers(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        const std::string type = option->get_type_name();
        if (begins_with(type, "FLOAT"))
            option->check(validator(kNumber, "a finite number"));
        else if (begins_with(type, "INT"))
            option->check(validator(R"([+-]?\d+)", "a whole number"));
        else if (begins_with(type, "UINT"))
            option->check(validator(R"(\+?\d+)", "a whole number of zero or more"));
    }
    for (CLI::App* command : app.get_subcommands(nullptr)) guard_numbers(*command);
}

void guard_files(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands()) guard_files(*command);
    std::vector<NamedFile> inputs, outputs;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& value : option->results()) {
            if (value.empty()) continue;
            const std::string name = option->get_name();
            if (is_picture(app, *option) && !is_png_name(value))
                throw CLI::ValidationError(name, value + ": pictures are PNG; name it .png");
            (is_output(app, *option) ? outputs : inputs).push_back({name, value});
        }
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        for (const NamedFile& input : inputs)
            if (same_file(outputs[k].path, input.path))
                throw CLI::ValidationError(outputs[k].option,
                                           outputs[k].path + " is what " + input.option +
                                               " reads, and would be lost; name another file");
        for (std::size_t other = 0; other < k; ++other)
            if (same_file(outputs[k].path, outputs[other].path))
                throw CLI::ValidationError(outputs[k].option, outputs[k].path + " is what " +
                                                                  outputs[other].option +
                                                                  " writes too; name two files");
    }
}

void guard_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw std::runtime_error(
            "standard output takes no more: what was printed is not whole (a full disk, or a "
            "closed stream)");
}

}  // namespace mien::cli
