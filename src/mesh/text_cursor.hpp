// Numbers and words from a text in memory: no locale, no streams, no copy. A line ends with a line
// feed, a carriage return, or both.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>

#include "base/error.hpp"

namespace mien {

inline bool ends_with(const std::string& text, const char* end) {
    const std::size_t length = std::strlen(end);
    return text.size() >= length && text.compare(text.size() - length, length, end) == 0;
}

class TextCursor {
  public:
    /// A UTF-8 byte order mark at the beginning is stepped over.
    TextCursor(const char* begin, const char* end) : at_(begin), end_(end) {
        if (end - begin >= 3 && std::memcmp(begin, "\xef\xbb\xbf", 3) == 0) at_ += 3;
    }

    const char* at() const { return at_; }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    std::int64_t line() const { return line_; }

    /// Blanks within the line; a backslash before a line's end joins the next line.
    void skip_blanks() {
        for (; at_ != end_; ++at_) {
            if (*at_ == ' ' || *at_ == '\t' || *at_ == '\v' || *at_ == '\f') continue;
            if (*at_ != '\\') return;
            const char* next = at_ + 1;
            if (next == end_ || (*next != '\n' && *next != '\r')) return;
            if (*next == '\r' && next + 1 != end_ && next[1] == '\n') ++next;
            at_ = next;
            ++line_;
        }
    }
    /// Blanks and line ends; '#' comments too when `comment` is '#'.
    void skip_space(char comment = '\0') {
        for (;;) {
            skip_blanks();
            if (at_ == end_) return;
            if (at_line_end()) {
                step_over_line_end();
            } else if (comment != '\0' && *at_ == comment) {
                skip_line();
            } else {
                return;
            }
        }
    }
    /// To the beginning of the next line.
    void skip_line() {
        while (!at_line_end()) ++at_;
        if (at_ != end_) step_over_line_end();
    }
    /// After skip_blanks(): nothing left on this line.
    bool at_line_end() const {
        return at_ == end_ || (*at_ <= '\r' && (*at_ == '\n' || *at_ == '\r'));
    }
    bool at_end() const { return at_ == end_; }
    char peek() const { return at_ == end_ ? '\0' : *at_; }
    void advance() { ++at_; }
    void advance(std::size_t count) { at_ += count; }

    /// The word at the cursor, up to the next blank.
    void word(const char*& begin, std::size_t& size) {
        begin = at_;
        while (at_ != end_ && static_cast<unsigned char>(*at_) > ' ') ++at_;
        size = static_cast<std::size_t>(at_ - begin);
    }

    /// The rest of the line without the blanks around it; the cursor stays at the line's end.
    void rest_of_line(const char*& begin, std::size_t& size) {
        while (peek() == ' ' || peek() == '\t') ++at_;
        begin = at_;
        while (!at_line_end()) ++at_;
        size = static_cast<std::size_t>(at_ - begin);
        while (size != 0 && static_cast<unsigned char>(begin[size - 1]) <= ' ') --size;
    }

    /// False, with the cursor where it was, when no number stands here. Too large a number reads
    /// as infinity (and is refused as a coordinate later), too small a one as zero. The undefined
    /// numbers of Windows programs (1.#INF, -1.#IND00, 1.#QNAN, nan(ind)) and the exponents of
    /// Fortran (1.5D+02) are understood.
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
        if (at_ != end_ && *at_ > ' ' && (*at_ == '#' || *at_ == '(' || (*at_ | 0x20) == 'd'))
            finish_odd(begin, value);
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
    void step_over_line_end() {
        if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
        ++at_;
        ++line_;
    }

    /// What may follow the part of a number that the standard knows. Out of line: rare, and the
    /// loops over numbers stay small.
    void finish_odd(const char* begin, double& value);

    const char* at_;
    const char* end_;
    std::int64_t line_ = 1;
};

}  // namespace mien
