#include "suggest.hpp"

#include <algorithm>
#include <utility>

namespace mien::cli {

namespace {

const CLI::App* child_of(const CLI::App& app, const std::string& name) {
    for (const CLI::App* child : app.get_subcommands(nullptr))
        if (child->get_name() == name) return child;
    return nullptr;
}

std::vector<std::string> children_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* child : app.get_subcommands(nullptr)) names.push_back(child->get_name());
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + ("'" + names[k] + "'");
    return text;
}

/// "mien measure" for the command that stands behind `measure`.
std::string path_of(const CLI::App& app) {
    const CLI::App* parent = app.get_parent();
    return parent == nullptr ? std::string("mien") : path_of(*parent) + " " + app.get_name();
}

/// The command that the leading words name, and the first word after it.
std::pair<const CLI::App*, std::size_t> reached(const CLI::App& app,
                                                const std::vector<std::string>& words) {
    const CLI::App* at = &app;
    std::size_t k = 0;
    for (; k < words.size(); ++k) {
        const CLI::App* child = child_of(*at, words[k]);
        if (child == nullptr) break;
        at = child;
    }
    return {at, k};
}

}  // namespace

int edit_distance(const std::string& from, const std::string& to) {
    const std::size_t rows = from.size() + 1, cols = to.size() + 1;
    std::vector<std::vector<int>> cost(rows, std::vector<int>(cols));
    for (std::size_t i = 0; i < rows; ++i) cost[i][0] = static_cast<int>(i);
    for (std::size_t j = 0; j < cols; ++j) cost[0][j] = static_cast<int>(j);
    for (std::size_t i = 1; i < rows; ++i)
        for (std::size_t j = 1; j < cols; ++j) {
            const int other = from[i - 1] == to[j - 1] ? 0 : 1;
            cost[i][j] =
                std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + other});
            const bool swapped =
                i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
            if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
        }
    return cost[rows - 1][cols - 1];
}

std::vector<std::string> nearest_names(const std::string& word,
                                       const std::vector<std::string>& names) {
    const int limit = std::max(2, static_cast<int>(word.size()) / 3);
    std::vector<std::pair<int, std::string>> near;
    for (const std::string& name : names) {
        const bool begins = word.size() > 2 && name.compare(0, word.size(), word) == 0;
        const int distance = begins ? 0 : edit_distance(word, name);
        if (distance <= limit && distance < static_cast<int>(name.size()))
            near.emplace_back(distance, name);
    }
    std::sort(near.begin(), near.end());
    std::vector<std::string> found;
    for (std::size_t k = 0; k < std::min<std::size_t>(near.size(), 3); ++k)
        found.push_back(near[k].second);
    return found;
}

std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
    const auto [at, next] = reached(app, words);
    const std::vector<std::string> known = children_of(*at);
    const std::string path = path_of(*at);
    if (known.empty()) return {};
    if (next == words.size() || words[next].empty() || words[next][0] == '-')
        return path + " needs one of its commands: " + joined(known);
    const std::string& word = words[next];
    std::vector<std::string> likely = nearest_names(word, known);
    // A name that stands elsewhere: 'mien volume' for 'mien measure volume'.
    if (likely.empty())
        for (const CLI::App* group : app.get_subcommands(nullptr))
            if (child_of(*group, word) != nullptr) likely.push_back(group->get_name() + " " + word);
    return path + " has no command '" + word + "'" +
           (likely.empty() ? std::string(".") : "; did you mean " + joined(likely) + "?") + " '" +
           path + " --help' lists them";
}

std::string unknown_option(const CLI::App& app, const std::vector<std::string>& words) {
    const auto [at, next] = reached(app, words);
    std::vector<std::string> known;
    for (const CLI::Option* option : at->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (std::size_t k = next; k < words.size(); ++k) {
        const std::string word = words[k].substr(0, words[k].find('='));
        if (word.size() < 3 || word.compare(0, 2, "--") != 0) continue;
        if (std::find(known.begin(), known.end(), word) != known.end()) continue;
        const std::vector<std::string> likely = nearest_names(word, known);
        if (!likely.empty())
            return path_of(*at) + " has no option '" + word + "'; did you mean " + joined(likely) +
                   "?";
    }
    return {};
}

}  // namespace mien::cli
