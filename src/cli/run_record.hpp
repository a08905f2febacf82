// What a run of the command was made from: the files that it read and wrote with their hashes, all
// options, the software. `mien replay` makes the run again and says whether the bits are the same.
#pragma once

#include <functional>

#include "commands.hpp"

namespace mien::cli {

/// Runs the command line `arguments` (without the program's name); returns the exit status.
using RunCommand = std::function<int(const std::vector<std::string>& arguments)>;

/// A run that may be recorded: made before it, finished after it.
class RunRecord {
  public:
    /// Looks for --run-record FILE among the arguments; with it, the files that they name are
    /// hashed. Throws std::runtime_error when one cannot be read.
    explicit RunRecord(std::vector<std::string> arguments);
    /// Writes the record, if one was asked for; throws std::runtime_error when it cannot.
    void finish(const CLI::App& app) const;

  private:
    std::vector<std::string> arguments_;  ///< without --run-record
    std::string path_;                    ///< empty: nothing is recorded
    nlohmann::json before_;               ///< files that were there: path, bytes, sha256, time
};

/// `mien replay RECORD`.
void add_replay_command(CLI::App& app, RunCommand run);

}  // namespace mien::cli
