// What a person meant who typed a command's or an option's name wrongly.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace mien::cli {

/// Letters to insert, drop, exchange or swap with the neighbour that make one word of the other.
int edit_distance(const std::string& from, const std::string& to);

/// Names within a third of the word's length (at least two edits), nearest first, at most three.
std::vector<std::string> nearest_names(const std::string& word,
                                       const std::vector<std::string>& names);

/// What is wrong with the words of a command line, as one line that says what to type; empty where
/// every command is known. Options are left to the parser.
std::string unknown_command(const CLI::App& app, const std::vector<std::string>& words);

/// The same for options that the parser did not know, from the command that was reached.
std::string unknown_option(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace mien::cli
