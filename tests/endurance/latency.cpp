// How long after a cancel a call goes on. Long calls on inputs of real size are cancelled at many
// moments; what counts is computing time, because a busy machine is none of the library's.
#include <atomic>
#include <chrono>
#include <ctime>
#include <string>
#include <thread>

#include "endurance.hpp"
#include "long_calls.hpp"

namespace endurance {
namespace {

constexpr double kBarMs = 50;

double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Milliseconds of computing between a cancel after `share` of the call's time and its end; below 0
/// when the call was over before.
double late_ms(const LongCall& call, const Inputs& in, double whole_s, double share) {
    mien_cancel* cancel = nullptr;
    mien_cancel_create(&cancel, nullptr);
    std::atomic<bool> over{false};
    double asked_s = -1;
    const double begin_s = seconds();
    std::thread watcher([&] {
        while (!over && seconds() - begin_s < share * whole_s)
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        if (over) return;
        asked_s = seconds();
        mien_cancel_request(cancel);
    });
    mien_error error = {};
    error.struct_size = sizeof error;
    const mien_status status = call.run(in.session(), cancel, &error);
    const double end_s = seconds();
    over = true;
    watcher.join();
    mien_cancel_release(cancel);
    if (status != MIEN_OK && status != MIEN_E_CANCELLED)
        fault(std::string(call.name) + " ends as " + mien_status_name(status) + ": " +
              error.message);
    return status == MIEN_E_CANCELLED && asked_s >= 0 ? 1e3 * (end_s - asked_s) : -1;
}

}  // namespace

void run_latency(long count) {
    const Inputs inputs;
    for (const LongCall& call : long_calls(inputs)) {
        if (!call.cancels) continue;
        const double begin_s = seconds();
        mien_error error = {};
        error.struct_size = sizeof error;
        if (call.run(inputs.session(), nullptr, &error) != MIEN_OK)
            fault(std::string(call.name) + " fails: " + error.message);
        const double whole_s = seconds() - begin_s;
        double latest_ms = -1, at = 0;
        long cancelled = 0;
        for (long k = 0; k < count; ++k) {
            const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
            const double late = late_ms(call, inputs, whole_s, share);
            cancelled += late >= 0;
            if (late <= latest_ms) continue;
            latest_ms = late;
            at = share;
        }
        std::printf("%-46s %7.2f s, %3ld cancels, at most %6.1f ms late (after %.0f %%)\n",
                    call.name, whole_s, cancelled, latest_ms, 100 * at);
        std::fflush(stdout);
        if (latest_ms > kBarMs)
            fault(std::string(call.name) + " goes on for " + std::to_string(latest_ms) + " ms");
    }
}

}  // namespace endurance
