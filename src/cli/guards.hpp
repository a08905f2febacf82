// What is asked of every command line, whichever command it names: numbers are plain and finite,
// and no file that the command reads, or has written itself, is overwritten.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace mien::cli {

/// Lets every option that takes numbers refuse what only a C library reads as one: nan, inf, 1e999,
/// 0x10, an empty word, a sign before a count. Call it when all commands are added; CLI11 then
/// throws CLI::ValidationError while it parses.
void guard_numbers(CLI::App& app);

/// The finite number that a whole word of digits, point and exponent of ten writes; none for
/// others.
std::optional<double> plain_number(const std::string& word);

/// Throws CLI::ValidationError when a result of the parsed command would go onto one of its inputs
/// or onto another of its results, or a picture into a file that is named as no PNG. Costs a look
/// at each file named.
void guard_files(const CLI::App& app);

/// Whether all that was printed has arrived; a full disk or a closed stream is told by the last
/// flush alone. Throws std::runtime_error.
void guard_output();

}  // namespace mien::cli
