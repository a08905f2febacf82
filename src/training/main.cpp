// mien-train: trains the networks that libmien runs. Exit status: 0 done, 1 failed (one line on
// stderr: what, where, what to do), 2 wrong usage, 3 stopped by a signal with its state saved.
#include <atomic>
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/error.hpp"
#include "base/file.hpp"
#include "training/faces.hpp"
#include "training/picture.hpp"
#include "training/runner.hpp"

namespace {

using namespace mien;
using namespace mien::training;

std::atomic<bool> stop{false};

void on_signal(int) {
    stop = true;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    AtomicFile file(path.u8string());
    file.write(text);
    file.commit();
}

/// Every step frees and takes the same hundreds of megabytes. Given back to the system each time,
/// clearing their pages anew took half of a step's processor time.
void keep_freed_memory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 256 << 20);
#endif
}

/// 0, or 3 when it was stopped.
int run_plan(const std::string& path, const std::vector<std::string>& overrides) {
    const Plan plan = read_plan(path, overrides);
    const double speed = product_speed();
    if (speed < 5)
        std::fprintf(stderr,
                     "mien-train: matrix products run at %.1f GFLOP/s; training will be slow. On "
                     "Debian install libopenblas0-pthread\n",
                     speed);
    const std::vector<Configuration> all = with_rivals(plan.configurations);
    std::vector<nlohmann::json> rows;
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::fprintf(stderr, "%zu of %zu: %s\n", k + 1, all.size(), all[k].name.c_str());
        rows.push_back(run_configuration(all[k], plan.out, stop));
        if (rows.back().is_null()) {
            std::fprintf(stderr, "stopped; run the same command to go on\n");
            return 3;
        }
    }
    nlohmann::json table = finish_table(std::move(rows));
    if (const std::string oracle = oracle_text(all.front().data); !oracle.empty())
        table["findings"].push_back(oracle);
    const std::filesystem::path folder = std::filesystem::u8path(plan.out);
    write_text(folder / "table.txt", table_text(table));
    write_text(folder / "table.json", table.dump(1) + "\n");
    write_table_picture((folder / "table.png").u8string(), table);
    std::fputs(table_text(table).c_str(), stdout);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Trains networks on registered faces, for libmien to run."};
    std::string configuration, data, out;
    std::vector<std::string> overrides;
    std::uint64_t seed = 1;
    mien::Index vertices = 0;
    int status = 0;
    keep_freed_memory();
    app.add_option("configuration", configuration, "JSON: an experiment, or a table of them");
    app.add_option("--set", overrides, "section.key=value in the place of what the files say");
    CLI::App* split = app.add_subcommand("split", "people into training, validation and test");
    split->add_option("--data", data, "dataset of faces in correspondence")->required();
    split->add_option("--seed", seed)->capture_default_str();
    split->add_option("--out", out, "JSON with three lists of subjects")->required();
    split->callback([&] { write_split(out, make_split(FaceDataset::open(data, {}, {}), seed)); });
    CLI::App* decimate = app.add_subcommand("decimate", "a dataset on a coarser template");
    decimate->add_option("--data", data, "dataset of faces in correspondence")->required();
    decimate->add_option("--vertices", vertices, "about how many stay")->required();
    decimate->add_option("--out", out, "dataset")->required();
    decimate->callback(
        [&] { decimate_dataset(FaceDataset::open(data, {}, {}), vertices, out, {}); });
    app.footer(
        "Example: mien-train configs/table.json --set experiment.epochs=40 --set out=runs/table");
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) {
            if (configuration.empty()) {
                std::fprintf(stderr, "mien-train: name a configuration, or see --help\n");
                return 2;
            }
            std::signal(SIGINT, on_signal);
            std::signal(SIGTERM, on_signal);
            status = run_plan(configuration, overrides);
        }
        return status;
    } catch (const CLI::ParseError& failure) {
        return app.exit(failure) == 0 ? 0 : 2;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "mien-train: %s\n", failure.what());
    }
    return 1;
}
