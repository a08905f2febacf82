// Processor and wall seconds of a registration by stage, told by its calls of progress.
#pragma once

#include <sys/resource.h>

#include <chrono>

#include "base/context.hpp"

namespace mien {

inline double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

inline double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Listens to one call; `finish()` ends its last stage.
struct StageClock {
    static constexpr int kStages = 5;
    static constexpr const char* kNames[kStages] = {"scan: cleaning, tree, normals", "start", "fit",
                                                    "closing the gap",
                                                    "repair, confidence, verdict"};
    double seconds[kStages] = {}, begin = cpu_seconds(), last = begin;
    double wall[kStages] = {}, wall_begin = wall_seconds(), wall_last = wall_begin;
    int now = 0;

    void listen_to(Context& context) {
        context.progress_function = listen;
        context.progress_user = this;
    }
    /// Processor seconds of all stages.
    double finish() {
        enter(kStages - 1);
        return last - begin;
    }
    double finished_wall() const { return wall_last - wall_begin; }

  private:
    void enter(int stage) {
        const double time = cpu_seconds(), wall_time = wall_seconds();
        seconds[now] += time - last;
        wall[now] += wall_time - wall_last;
        last = time;
        wall_last = wall_time;
        now = stage;
    }
    static std::int32_t listen(void* clock, std::int32_t stage, double fraction) {
        const bool done = fraction >= 1;
        int now = 4;
        if (stage == static_cast<std::int32_t>(Stage::alignment))
            now = fraction < 0.1 ? 0 : done ? 2 : 1;
        if (stage == static_cast<std::int32_t>(Stage::fitting)) now = done ? 3 : 2;
        if (stage == static_cast<std::int32_t>(Stage::refining)) now = done ? 4 : 3;
        static_cast<StageClock*>(clock)->enter(now);
        return 0;
    }
};

}  // namespace mien
