#include "commands.hpp"

namespace mien::cli {

void add_measure_commands(CLI::App&) {}

}  // namespace mien::cli
