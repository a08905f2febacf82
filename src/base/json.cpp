#include "base/json.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace mien {

void StrictJson::refuse(const char* found) const {
    fail(Status::bad_format, "%s: found %s where it has no place", what_, found);
}

bool StrictJson::parse_error(std::size_t position, const std::string&,
                             const nlohmann::detail::exception&) {
    fail_at(Status::bad_format, static_cast<std::int64_t>(position),
            "%s: not valid JSON at byte %zu", what_, position);
}

void parse_json(const char* text, std::size_t size, StrictJson& receiver) {
    nlohmann::json::sax_parse(text, text + size, &receiver);
}

namespace {

class StringList : public StrictJson {
  public:
    using StrictJson::StrictJson;
    std::vector<std::string> list;

    bool start_array(std::size_t) override {
        if (open_) refuse("a list");
        return open_ = true;
    }
    bool end_array() override { return true; }
    bool string(string_t& text) override {
        if (!open_) refuse("a string");
        list.push_back(text);
        return true;
    }

  private:
    bool open_ = false;
};

}  // namespace

std::vector<std::string> parse_json_string_list(const std::string& text, const char* what) {
    StringList receiver(what);
    parse_json(text.data(), text.size(), receiver);
    return receiver.list;
}

void append_json_string(std::string& json, const std::string& text) {
    if (!is_utf8(text))
        fail(Status::invalid_argument, "'%s' is not UTF-8 text; convert it first",
             shown_name(text).c_str());
    json += '"';
    for (char c : text) {
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            json += "\\u00";
            json += "0123456789abcdef"[(c >> 4) & 15];
            json += "0123456789abcdef"[c & 15];
        } else {
            json += c;
        }
    }
    json += '"';
}

std::string json_string_list(const std::vector<std::string>& texts) {
    std::string json = "[";
    for (const std::string& text : texts) {
        if (json.size() > 1) json += ", ";
        append_json_string(json, text);
    }
    return json + "]";
}

bool is_utf8(const std::string& text) {
    const std::size_t size = text.size();
    for (std::size_t i = 0; i < size;) {
        const unsigned char lead = static_cast<unsigned char>(text[i]);
        const int more = lead < 0x80                   ? 0
                         : lead >= 0xc2 && lead < 0xe0 ? 1
                         : lead >= 0xe0 && lead < 0xf0 ? 2
                         : lead >= 0xf0 && lead < 0xf5 ? 3
                                                       : -1;
        if (more < 0 || i + static_cast<std::size_t>(more) >= size) return false;
        for (int k = 1; k <= more; ++k) {
            const unsigned char c =
                static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
            // The second byte alone tells overlong forms, surrogates and numbers past U+10FFFF.
            const unsigned char low = k > 1          ? 0x80
                                      : lead == 0xe0 ? 0xa0
                                      : lead == 0xf0 ? 0x90
                                                     : 0x80;
            const unsigned char high = k > 1          ? 0xbf
                                       : lead == 0xed ? 0x9f
                                       : lead == 0xf4 ? 0x8f
                                                      : 0xbf;
            if (c < low || c > high) return false;
        }
        i += static_cast<std::size_t>(more) + 1;
    }
    return true;
}

std::string shown_name(const std::string& name) {
    constexpr std::size_t kLongest = 60;
    std::string shown = name;
    if (shown.size() > kLongest) {
        std::size_t cut = kLongest;
        while (cut > 0 && (static_cast<unsigned char>(shown[cut]) & 0xc0) == 0x80) --cut;
        shown.resize(cut);
        shown += "...";
    }
    const bool readable = is_utf8(shown);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f ||
            (!readable && static_cast<unsigned char>(c) >= 0x80))
            c = '?';
    return shown;
}

}  // namespace mien
