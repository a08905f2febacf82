#include "base/error.hpp"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace mien {

Error::Error(Status status, std::int64_t detail_index, const char* message) noexcept
    : status_(status), detail_index_(detail_index) {
    std::snprintf(message_, sizeof message_, "%s", message);
    // A message that was cut may end within a character: a lead byte with too few bytes after it.
    std::size_t end = std::strlen(message_), tail = 0;
    if (end + 1 < sizeof message_) return;
    while (tail < 3 && (static_cast<unsigned char>(message_[end - 1 - tail]) & 0xc0) == 0x80)
        ++tail;
    const unsigned char lead = static_cast<unsigned char>(message_[end - 1 - tail]);
    const std::size_t needed = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
    if (tail < needed) message_[end - 1 - tail] = '\0';
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
