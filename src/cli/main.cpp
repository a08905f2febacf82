// mien: everything the library does, without writing code. Exit status: 0 done, 1 failed (one line
// on stderr: what, where, what to do), 2 wrong usage.
#include <algorithm>
#include <cstdio>
#include <iostream>
#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if !defined(_WIN32)
#include <fcntl.h>
#include <unistd.h>
#endif

#include "commands.hpp"
#include "guards.hpp"
#include "run_record.hpp"
#include "suggest.hpp"

namespace {

/// The help lists commands by what they are for, in the order in which a study needs them.
void group_by_job(CLI::App& app) {
    static const struct {
        const char* job;
        std::vector<std::string> commands;
    } kJobs[] = {
        {"Prepare", {"mesh", "landmarks", "model", "train"}},
        {"Fit scans", {"register", "batch", "transfer"}},
        {"Take expressions off, put them on", {"neutralize", "expression", "transfer-expression"}},
        {"Measure and report", {"measure", "report", "score"}},
        {"Frequencies and networks", {"spectral", "network"}},
        {"Check and look", {"evaluate", "metric", "render", "replay"}}};
    for (const auto& [job, commands] : kJobs)
        for (CLI::App* command : app.get_subcommands(nullptr))
            if (std::find(commands.begin(), commands.end(), command->get_name()) != commands.end())
                command->group(job);
}

/// Wrong usage: what was typed, and what was probably meant.
int wrong_usage(const CLI::App& app, const CLI::ParseError& failure, int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    std::string advice = mien::cli::unknown_command(app, words);
    // A misspelled option is told before the required one that it was meant for is missed.
    const bool by_options = dynamic_cast<const CLI::ExtrasError*>(&failure) != nullptr ||
                            dynamic_cast<const CLI::RequiredError*>(&failure) != nullptr;
    if (advice.empty() && by_options) advice = mien::cli::unknown_option(app, words);
    if (advice.empty() || failure.get_exit_code() == 0) {
        if (app.exit(failure) != 0) return 2;
        std::cout.flush();  // the help
        mien::cli::guard_output();
        return std::cout ? 0 : 1;
    }
    std::fprintf(stderr, "%s\n", advice.c_str());
    return 2;
}

void add_commands(CLI::App& app) {
    mien::cli::add_model_commands(app);
    mien::cli::add_registration_commands(app);
    mien::cli::add_batch_commands(app);
    mien::cli::add_transfer_commands(app);
    mien::cli::add_landmark_commands(app);
    mien::cli::add_mesh_commands(app);
    mien::cli::add_training_commands(app);
    mien::cli::add_expression_commands(app);
    mien::cli::add_face_commands(app);
    mien::cli::add_measure_commands(app);
    mien::cli::add_score_commands(app);
    mien::cli::add_network_commands(app);
    mien::cli::add_report_commands(app);
    mien::cli::add_spectral_commands(app);
    mien::cli::add_render_commands(app);
}

/// One command line; `mien replay` runs another one inside.
int run_command_line(int argc, char** argv) {
    CLI::App app{"Registers 3D face scans, removes facial expressions, measures what changed."};
    app.set_version_flag("--version", mien_build_id());
    app.require_subcommand(1);
    try {
        add_commands(app);
        mien::cli::add_replay_command(
            app, [program = argv[0]](const std::vector<std::string>& arguments) {
                std::vector<std::string> words = arguments;
                std::vector<char*> pointers{program};
                for (std::string& word : words) pointers.push_back(&word[0]);
                return run_command_line(static_cast<int>(pointers.size()), pointers.data());
            });
        group_by_job(app);
        mien::cli::guard_numbers(app);
        app.parse_complete_callback([&app] { mien::cli::guard_files(app); });
        const mien::cli::RunRecord record({argv + 1, argv + argc});
        app.parse(argc, argv);
        record.finish(app);
        mien::cli::guard_output();
        return 0;
    } catch (const CLI::ParseError& failure) {
        try {
            return wrong_usage(app, failure, argc, argv);
        } catch (const std::exception& unprinted) {
            std::fprintf(stderr, "mien: %s\n", unprinted.what());
        }
    } catch (const mien::Exception& failure) {
        std::fprintf(stderr, "mien: %s (%s)\n", failure.what(), mien_status_name(failure.status()));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "mien: %s\n", failure.what());
    }
    return 1;
}

/// One command and the process ends: what is freed is used again, not handed back to the system and
/// asked for anew, page by page (4 to 6 % of a registration's processor seconds).
void keep_freed_memory() {
#if defined(__GLIBC__)
    constexpr int kMost = 512 << 20, kStep = 16 << 20;  // bytes
    constexpr int kLargest = 32 << 20;                  // more is refused
    mallopt(M_MMAP_THRESHOLD, kLargest);
    mallopt(M_TRIM_THRESHOLD, kMost);
    mallopt(M_TOP_PAD, kStep);
#endif
}

/// A file opened in place of a closed stream would take what is printed into its bytes: the places
/// of the three streams are held by one that neither gives nor takes.
void hold_closed_streams() {
#if !defined(_WIN32)
    for (int stream = 0; stream <= 2; ++stream)
        if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY) < 0)
            return;
#endif
}

}  // namespace

int main(int argc, char** argv) {
    hold_closed_streams();
    keep_freed_memory();
    return run_command_line(argc, argv);
}
