#include "commands.hpp"

namespace mien::cli {

void add_score_commands(CLI::App&) {}

}  // namespace mien::cli
