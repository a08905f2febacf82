#include "commands.hpp"

namespace mien::cli {

void add_report_commands(CLI::App&) {}

}  // namespace mien::cli
