// Numbers and words from a text in memory: no locale, no streams, no copy.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <system_error>

#include "base/error.hpp"

namespace mien {

class TextCursor {
  public:
    TextCursor(const char* begin, const char* end) : at_(begin), end_(end) {}

    const char* at() const { return at_; }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    std::int64_t line() const { return line_; }

    /// Blanks within the line; a backslash before a line's end joins the next line.
    void skip_blanks() {
        for (; at_ != end_; ++at_) {
            if (*at_ == ' ' || *at_ == '\t' || *at_ == '\r' || *at_ == '\v' || *at_ == '\f')
                continue;
            if (*at_ != '\\') return;
            const char* next = at_ + 1;
            if (next != end_ && *next == '\r') ++next;
            if (next == end_ || *next != '\n') return;
            at_ = next;
            ++line_;
        }
    }
    /// Blanks and line ends; '#' comments too when `comment` is '#'.
    void skip_space(char comment = '\0') {
        for (;;) {
            skip_blanks();
            if (at_ == end_) return;
            if (*at_ == '\n') {
                ++at_;
                ++line_;
            } else if (comment != '\0' && *at_ == comment) {
                skip_line();
            } else {
                return;
            }
        }
    }
    /// To the beginning of the next line.
    void skip_line() {
        const void* newline = std::memchr(at_, '\n', remaining());
        if (newline == nullptr) {
            at_ = end_;
            return;
        }
        at_ = static_cast<const char*>(newline) + 1;
        ++line_;
    }
    /// After skip_blanks(): nothing left on this line.
    bool at_line_end() const { return at_ == end_ || *at_ == '\n'; }
    bool at_end() const { return at_ == end_; }
    char peek() const { return at_ == end_ ? '\0' : *at_; }
    void advance() { ++at_; }

    /// The word at the cursor, up to the next blank.
    void word(const char*& begin, std::size_t& size) {
        begin = at_;
        while (at_ != end_ && static_cast<unsigned char>(*at_) > ' ') ++at_;
        size = static_cast<std::size_t>(at_ - begin);
    }

    /// False, with the cursor where it was, when no number stands here. Too large a number reads
    /// as infinity (and is refused as a coordinate later), too small a one as zero.
    bool number(double& value) {
        const char* begin = at_;
        if (begin != end_ && *begin == '+') ++begin;
        const std::from_chars_result result = std::from_chars(begin, end_, value);
        if (result.ec == std::errc::invalid_argument) return false;
        if (result.ec == std::errc::result_out_of_range) {
            bool small = false;
            for (const char* p = begin; p + 1 < result.ptr; ++p)
                small = small || ((*p == 'e' || *p == 'E') && p[1] == '-');
            value = small ? 0.0 : std::numeric_limits<double>::infinity();
        }
        at_ = result.ptr;
        return true;
    }
    bool integer(std::int64_t& value) {
        const char* begin = at_;
        if (begin != end_ && *begin == '+') ++begin;
        const std::from_chars_result result = std::from_chars(begin, end_, value);
        if (result.ec != std::errc()) return false;
        at_ = result.ptr;
        return true;
    }

  private:
    const char* at_;
    const char* end_;
    std::int64_t line_ = 1;
};

}  // namespace mien
