// mien: everything the library does, without writing code. Exit status: 0 done, 1 failed (one line
// on stderr: what, where, what to do), 2 wrong usage.
#include <cstdio>

#include "commands.hpp"

int main(int argc, char** argv) {
    CLI::App app{"Registers 3D face scans, removes facial expressions, measures what changed."};
    app.set_version_flag("--version", mien_build_id());
    app.require_subcommand(1);
    try {
        mien::cli::add_model_commands(app);
        mien::cli::add_registration_commands(app);
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
        app.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& failure) {
        return app.exit(failure) == 0 ? 0 : 2;
    } catch (const mien::Exception& failure) {
        std::fprintf(stderr, "mien: %s (%s)\n", failure.what(), mien_status_name(failure.status()));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "mien: %s\n", failure.what());
    }
    return 1;
}
