#include "commands.hpp"

namespace mien::cli {

void add_expression_commands(CLI::App&) {}

}  // namespace mien::cli
