#include "report_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "report_sentences.hpp"

namespace mien::cli {
namespace {

/// Length of the valid UTF-8 character that begins at `at`; 0: there is none.
std::size_t character_at(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t k) {
        return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
    };
    const unsigned first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((byte(at + k) & 0xC0) != 0x80) return 0;
    const unsigned second = byte(at + 1);
    // Overlong forms, surrogates and what lies beyond Unicode.
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90))
        return 0;
    return length;
}

std::string filled(std::string text, const std::vector<std::string>& values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::string mark = "{" + std::to_string(k) + "}";
        for (std::size_t at = text.find(mark); at != std::string::npos;
             at = text.find(mark, at + values[k].size()))
            text.replace(at, mark.size(), values[k]);
    }
    return text;
}

/// The parts of `text` that stand where `pattern` has "*"; false when it does not fit.
bool matches(const std::string& text, const std::string& pattern, std::vector<std::string>& parts) {
    parts.clear();
    const std::size_t head = std::min(pattern.find('*'), pattern.size());
    if (text.compare(0, head, pattern, 0, head) != 0) return false;
    std::size_t at = head, star = head;
    while (star < pattern.size()) {
        const std::size_t next = std::min(pattern.find('*', star + 1), pattern.size());
        const std::string literal = pattern.substr(star + 1, next - star - 1);
        // The last part goes to the end, the others to where what follows them is found first.
        std::size_t found = literal.empty() ? text.size() : text.find(literal, at);
        if (next == pattern.size() && !literal.empty())
            found = text.size() < at + literal.size() ? std::string::npos
                                                      : text.size() - literal.size();
        if (found == std::string::npos || text.compare(found, literal.size(), literal) != 0)
            return false;
        parts.push_back(text.substr(at, found - at));
        at = found + literal.size();
        star = next;
    }
    return at == text.size();
}

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

template <std::size_t Count>
const ReportText* find(const ReportText (&table)[Count], const std::string& key) {
    for (const ReportText& text : table)
        if (key == text.key) return &text;
    return nullptr;
}

}  // namespace

const std::vector<std::string>& report_languages() {
    static const std::vector<std::string> kNames(std::begin(kReportLanguages),
                                                 std::end(kReportLanguages));
    return kNames;
}

Words::Words(const std::string& language) : language_(language) {
    const auto& known = report_languages();
    column_ =
        static_cast<std::size_t>(std::find(known.begin(), known.end(), language) - known.begin());
    if (column_ == known.size())
        throw std::invalid_argument("the report does not speak '" + language + "'");
}

std::string Words::operator()(const char* key, const std::vector<std::string>& values) const {
    const ReportText* text = find(kReportTexts, key);
    if (text == nullptr) throw std::logic_error(std::string("the report has no text ") + key);
    return filled(text->in[column_], values);
}

std::string Words::zone(const std::string& name) const {
    std::vector<std::string> parts;
    if (matches(name, "* and * mm around", parts))
        return (*this)("zone_and_around", {zone(parts[0]), parts[1]});
    const ReportText* text = find(kZoneNames, name);
    return text == nullptr ? spaced(name) : text->in[column_];
}

std::string Words::sentence(const std::string& english) const {
    std::vector<std::string> parts;
    for (const ReportText& text : kSentences)
        if (matches(english, text.key, parts)) {
            // A number, a zone, or a sentence inside the sentence.
            for (std::string& part : parts)
                part = part.find_first_not_of("-0123456789.") == std::string::npos ? number(part)
                       : find(kZoneNames, part) != nullptr                         ? zone(part)
                                                                                   : sentence(part);
            return filled(text.in[column_], parts);
        }
    return english;
}

std::string Words::number(double value, int digits) const {
    if (!std::isfinite(value)) return "\xE2\x80\x93";
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    // No minus before a zero that was rounded to it.
    const bool zero = std::strspn(text, "-0.") == std::strlen(text);
    return number(zero && text[0] == '-' ? text + 1 : text);
}

std::string Words::number(std::string text) const {
    const std::string sign = (*this)("decimal_sign");
    const std::size_t point = text.find('.');
    return point == std::string::npos ? text : text.replace(point, 1, sign);
}

std::string Words::field(const std::string& key) const {
    const ReportText* text = find(kFieldNames, key);
    return text == nullptr ? spaced(key) : text->in[column_];
}

std::string valid_utf8(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_at(text, at);
        if (length == 0) {
            out += "\xEF\xBF\xBD";
            ++at;
        } else {
            out.append(text, at, length);
            at += length;
        }
    }
    return out;
}

std::string shortened(const std::string& text, std::size_t count) {
    const std::string whole = valid_utf8(text);
    std::size_t at = 0;
    for (std::size_t k = 0; k < count && at < whole.size(); ++k) at += character_at(whole, at);
    return at >= whole.size() ? whole : whole.substr(0, at) + "\xE2\x80\xA6";
}

std::string html_text(const std::string& text) {
    std::string out;
    for (const char c : valid_utf8(text)) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

}  // namespace mien::cli
