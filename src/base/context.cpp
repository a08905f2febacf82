#include "base/context.hpp"

#include <cstdarg>
#include <cstdio>

#include "base/error.hpp"

namespace mien {

void Context::progress(Stage stage, double fraction) const {
    check_cancelled();
    if (progress_function != nullptr &&
        progress_function(progress_user, static_cast<std::int32_t>(stage), fraction) != 0)
        fail(Status::cancelled, "cancelled by the progress callback");
}

void Context::check_cancelled() const {
    if (cancel != nullptr && cancel->requested()) fail(Status::cancelled, "cancelled by its token");
}

void Context::require_memory(std::size_t bytes, const char* what) const {
    if (max_bytes != 0 && bytes > max_bytes)
        fail(Status::memory_budget,
             "%s needs about %zu MB, the session's budget is %zu MB; raise max_bytes or use a "
             "smaller input",
             what, bytes / 1000000 + 1, max_bytes / 1000000);
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
