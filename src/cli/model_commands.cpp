#include "commands.hpp"

namespace mien::cli {

void add_model_commands(CLI::App&) {}

}  // namespace mien::cli
