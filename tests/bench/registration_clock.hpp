// Wall seconds of a registration by stage, told by its calls of progress.
#pragma once

#include <chrono>

#include "base/context.hpp"

namespace mien {

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
    double seconds[kStages] = {}, begin = wall_seconds(), last = begin;
    int now = 0;

    void listen_to(Context& context) {
        context.progress_function = listen;
        context.progress_user = this;
    }
    /// Seconds of all stages.
    double finish() {
        enter(kStages - 1);
        return last - begin;
    }

  private:
    void enter(int stage) {
        const double time = wall_seconds();
        seconds[now] += time - last;
        last = time;
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
