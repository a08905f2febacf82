#include "commands.hpp"

namespace mien::cli {

void add_registration_commands(CLI::App&) {}

}  // namespace mien::cli
