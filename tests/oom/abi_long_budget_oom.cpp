// Long calls on inputs of real size, each under budgets below and above what it needs: refused
// before the heap has grown beyond the budget by more than a tenth, or done.
//   oom_abi_long_budget short|all|NAME_PART     short: calls of less than a second
#include <cstring>
#include <ctime>

#include "endurance/long_calls.hpp"
#include "fail_nth.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace endurance;

constexpr double kTolerance = 0.1;            ///< of the budget
constexpr long long kSlackBytes = 256 << 10;  ///< names, records, the C library's and threads' own

long faults = 0;

void fault(const char* name, const std::string& what) {
    if (++faults <= 40) std::printf("FAULT %s: %s\n", name, what.c_str());
}

struct Outcome {
    mien_status status;
    long long peak;  ///< growth of the heap over the call, bytes
    std::string message;
};

Outcome run(const LongCall& call, std::uint64_t max_bytes, int num_threads) {
    mien_session_options options;
    mien_session_options_init(&options, sizeof options);
    options.max_bytes = max_bytes;
    options.num_threads = num_threads;
    mien_session* session = nullptr;
    if (mien_session_create_with_options(MIEN_ABI_VERSION, &options, &session, nullptr) != MIEN_OK)
        return {MIEN_E_INTERNAL, 0, "no session"};
    mien_error error = {};
    error.struct_size = sizeof error;
    const long long before = oom::control.bytes.load();
    oom::control.peak = before;
    const mien_status status = call.run(session, nullptr, &error);
    const long long peak = oom::control.peak.load() - before;
    mien_session_release(session);
    return {status, peak, error.message};
}

/// False when the call is left to the long form.
bool check(const LongCall& call, bool only_short) {
    const std::clock_t begin = std::clock();
    const Outcome whole = run(call, 0, 2);
    if (only_short && std::clock() - begin > CLOCKS_PER_SEC) return false;
    if (whole.status != MIEN_OK) {
        fault(call.name, "fails: " + whole.message);
        return true;
    }
    std::printf("%-46s %8.1f MB;", call.name, 1e-6 * static_cast<double>(whole.peak));
    for (const double share : {0.0, 0.1, 0.3, 0.6, 0.85, 1.15}) {
        const auto budget =
            static_cast<std::uint64_t>(1024 + share * static_cast<double>(whole.peak));
        const Outcome limited = run(call, budget, 2);
        const auto peak = static_cast<double>(limited.peak), room = static_cast<double>(budget);
        std::printf(" %s %.2f", limited.status == MIEN_OK ? "done" : "refused",
                    peak / static_cast<double>(whole.peak));
        std::fflush(stdout);
        const std::string where = "with a budget of " + std::to_string(budget) + " of " +
                                  std::to_string(whole.peak) + " bytes ";
        if (limited.status != MIEN_OK && limited.status != MIEN_E_MEMORY_BUDGET)
            fault(call.name,
                  where + "ends as " + mien_status_name(limited.status) + ": " + limited.message);
        if (peak > (1 + kTolerance) * room + kSlackBytes)
            fault(call.name, where + "takes " + std::to_string(limited.peak));
        if (share > 1 && limited.status != MIEN_OK)
            fault(call.name, where + "is refused: " + limited.message);
    }
    std::puts("");
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (!oom::available()) {
        std::puts("the malloc family cannot be replaced in this build: skipped");
        return 0;
    }
    const std::string which = argc > 1 ? argv[1] : "short";
    const bool whole = which == "all", only_short = which == "short";
    const mien::testing::ScratchFolder folder;
    std::filesystem::current_path(folder / "");
    int count = 0;
    {
        const Inputs inputs;
        std::puts(
            "the heap's growth without a budget; then under 0.0, 0.1, 0.3, 0.6, 0.85 and 1.15 of "
            "it");
        for (const LongCall& call : long_calls(inputs))
            if (whole || only_short || std::strstr(call.name, which.c_str()) != nullptr)
                count += check(call, only_short) ? 1 : 0;
    }
    std::filesystem::current_path(std::filesystem::temp_directory_path());
    std::printf("%d long calls kept to their budgets, %ld faults\n", count, faults);
    return faults == 0 && count > 0 ? 0 : 1;
}
