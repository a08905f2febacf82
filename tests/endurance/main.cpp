// What a library in a hospital lives through, through its shared library: damaged files, full
// disks, killed writers, cancelled calls, crafted and dirty meshes, thousands of rounds. Each mode
// has a short form, which runs with the tests, and a long one by its count (tests/README.md tells
// what was run).
//
//   endurance flips|truncations|disk|kills|cancels|crafted|soak [count] [seed]
//   endurance latency [cancels per call]   how late a cancel is heard
//   endurance corpus FOLDER     every mesh file below it, through the whole library
#include <cstdlib>

#include "endurance.hpp"

namespace endurance {
namespace {
long faults = 0;
}

void fault(const std::string& what) {
    if (++faults <= 20) std::printf("FAULT: %s\n", what.c_str());
    std::fflush(stdout);
}

long num_faults() {
    return faults;
}

mien_session* new_session(double max_seconds) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.max_seconds = max_seconds;
    mien_session* session = nullptr;
    mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr);
    return session;
}

}  // namespace endurance

int main(int argc, char** argv) {
    using namespace endurance;
    const std::string mode = argc > 1 ? argv[1] : "flips";
    const auto count = [&](long otherwise) { return argc > 2 ? std::atol(argv[2]) : otherwise; };
    const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    const std::string corpus =
        argc > 2 ? std::filesystem::absolute(argv[2]).string() : std::string();
    const OwnFolder folder;
    if (mode == "flips")
        run_flips(count(10000), seed);
    else if (mode == "truncations")
        run_truncations(count(2000), seed);
    else if (mode == "disk")
        run_full_disk(count(200), seed);
    else if (mode == "kills")
        run_kills(count(40), seed);
    else if (mode == "cancels")
        run_cancels(count(100), seed);
    else if (mode == "latency")
        run_latency(count(3));
    else if (mode == "crafted")
        run_crafted(count(0) != 0);
    else if (mode == "corpus")
        run_corpus(corpus);
    else if (mode == "soak")
        run_soak(count(4));
    else
        fault("unknown mode");
    std::printf("%s: %ld faults\n", mode.c_str(), num_faults());
    return num_faults() == 0 ? 0 : 1;
}
