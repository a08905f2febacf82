#include "commands.hpp"

namespace mien::cli {

void add_render_commands(CLI::App&) {}

}  // namespace mien::cli
