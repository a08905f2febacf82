#include "base/error.hpp"

#include <cstdarg>
#include <cstdio>

namespace mien {

Error::Error(Status status, std::int64_t detail_index, const char* message) noexcept
    : status_(status), detail_index_(detail_index) {
    std::snprintf(message_, sizeof message_, "%s", message);
}

void fail(Status status, const char* format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    throw Error(status, -1, text);
}

void fail_at(Status status, std::int64_t detail_index, const char* format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    throw Error(status, detail_index, text);
}

}  // namespace mien
