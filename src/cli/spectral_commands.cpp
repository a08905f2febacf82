#include "commands.hpp"

namespace mien::cli {

void add_spectral_commands(CLI::App&) {}

}  // namespace mien::cli
