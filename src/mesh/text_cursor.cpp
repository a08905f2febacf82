#include "mesh/text_cursor.hpp"

namespace mien {
namespace {

bool is_letter(char c) {
    return (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The word at `p` in any case, as the C runtime of Windows writes after "1.#".
bool follows(const char* p, const char* end, const char* word) {
    for (; *word != '\0'; ++word, ++p)
        if (p == end || (*p | 0x20) != *word) return false;
    return true;
}

}  // namespace

void TextCursor::finish_odd(const char* begin, double& value) {
    const char* p = at_ + 1;
    if (*at_ == '#') {
        const bool infinite = follows(p, end_, "inf");
        if (at_[-1] != '.' || !(infinite || follows(p, end_, "ind") || follows(p, end_, "qnan") ||
                                follows(p, end_, "snan") || follows(p, end_, "nan")))
            return;
        while (p != end_ && (is_letter(*p) || is_digit(*p))) ++p;
        value = infinite ? value * std::numeric_limits<double>::infinity()
                         : std::numeric_limits<double>::quiet_NaN();
        at_ = p;
    } else if (*at_ == '(') {
        if (value == value) return;
        while (p != end_ && (is_letter(*p) || is_digit(*p) || *p == '_')) ++p;
        if (p != end_ && *p == ')') at_ = p + 1;
    } else if (is_digit(at_[-1]) || at_[-1] == '.') {
        // Read anew with the exponent's letter exchanged, so that the value is rounded once.
        char text[64];
        std::size_t size = 0;
        const std::size_t mark = static_cast<std::size_t>(at_ - begin);
        for (p = begin; p != end_ && size < sizeof text &&
                        (is_digit(*p) || *p == '.' || *p == '-' || *p == '+' || p == at_);
             ++p)
            if (size != mark + 1 || *p != '+')
                text[size++] = p == at_ ? 'e' : *p;
            else
                text[size++] = '0';
        if (size <= mark + 1 || size == sizeof text) return;
        const std::from_chars_result result = std::from_chars(text, text + size, value);
        if (result.ec == std::errc::result_out_of_range)
            value = text[mark + 1] == '-' ? 0.0 : std::numeric_limits<double>::infinity();
        at_ = begin + (result.ptr - text);
    }
}

}  // namespace mien
