#include "base/context.hpp"

#include <cstdarg>
#include <cstdio>

#include "base/error.hpp"
#include "base/memory_budget.hpp"

namespace mien {

void Context::progress(Stage stage, double fraction) const {
    check_cancelled();
    if (progress_function != nullptr &&
        progress_function(progress_user, static_cast<std::int32_t>(stage), fraction) != 0)
        fail(Status::cancelled, "cancelled by the progress callback");
}

void Context::check_cancelled() const {
    if (cancel != nullptr && cancel->requested()) fail(Status::cancelled, "cancelled by its token");
    if (deadline != Clock::time_point::max() && Clock::now() > deadline)
        fail(Status::time_limit,
             "the session's time limit has passed; raise max_seconds or use a smaller input");
}

void Context::require_memory(std::size_t bytes, const char* what) const {
    if (max_bytes == 0) return;
    const MemoryBudget* const budget = current_budget();
    const std::int64_t counted = budget == nullptr ? 0 : budget->live.load();
    const auto live = static_cast<std::size_t>(counted < 0 ? 0 : counted);
    if (bytes > max_bytes || live > max_bytes - bytes)
        fail(Status::memory_budget,
             "%s needs about %zu MB beside %zu MB in use, the session's budget is %zu MB; raise "
             "max_bytes or use a smaller input",
             what, bytes / 1000000 + 1, live / 1000000, max_bytes / 1000000);
}

void Context::log(LogLevel level, const char* format, ...) const {
    if (log_function == nullptr) return;
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    log_function(log_user, static_cast<std::int32_t>(level), text);
}

}  // namespace mien
