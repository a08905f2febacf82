// What a long computation gets from its caller: threads, progress, cancellation, limits of memory
// and time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "base/thread_pool.hpp"

namespace mien {

/// Sticky and single-use; request() may be called from any thread or a signal handler.
class CancelToken {
  public:
    void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
    bool requested() const noexcept { return requested_.load(std::memory_order_relaxed); }

  private:
    std::atomic<bool> requested_{false};
};

/// Stages that a host sees in its progress callback. Numbers are the C ABI's numbers.
enum class Stage : std::int32_t {
    reading = 1,
    geodesics = 2,
    basis = 3,
    alignment = 4,
    fitting = 5,
    refining = 6,
    training = 7,
    neutralizing = 8,
    measuring = 9,
    writing = 10,
};

enum class LogLevel : std::int32_t { error = 1, warning = 2, info = 3, debug = 4 };

/// Passed down by const reference; never stored beyond a call. A default one runs on the calling
/// thread alone, reports to nobody and has no budget.
class Context {
  public:
    using ProgressFunction = std::int32_t (*)(void* user, std::int32_t stage, double fraction);
    using LogFunction = void (*)(void* user, std::int32_t level, const char* message);

    ThreadPool* pool = nullptr;  ///< null: everything on the calling thread
    const CancelToken* cancel = nullptr;
    ProgressFunction progress_function = nullptr;
    void* progress_user = nullptr;
    LogFunction log_function = nullptr;
    void* log_user = nullptr;
    std::size_t max_bytes = 0;  ///< 0: no budget
    using Clock = std::chrono::steady_clock;
    Clock::time_point deadline = Clock::time_point::max();  ///< when a call has taken too long
    bool copy_files = false;  ///< model files are read into memory rather than mapped

    /// Calling thread only, at fixed points of an algorithm, monotone within a stage.
    /// Throws Status::cancelled when the host or the token says so.
    void progress(Stage stage, double fraction) const;
    /// Any thread. Throws Status::cancelled when the token says so, Status::time_limit after the
    /// deadline. Costs some 30 ns with a deadline: call it per chunk of work, not per element.
    void check_cancelled() const;
    /// Throws Status::memory_budget when `bytes` more for `what` would exceed the budget, counting
    /// what the call holds already (base/memory_budget.hpp).
    void require_memory(std::size_t bytes, const char* what) const;
    void log(LogLevel level, const char* format, ...) const
#if defined(__GNUC__)
        __attribute__((format(printf, 3, 4)))
#endif
        ;
};

}  // namespace mien
