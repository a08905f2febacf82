#include "mesh/ply_header.hpp"

#include "base/json.hpp"

namespace mien::formats {
namespace {

constexpr std::size_t kMostElements = 64, kMostProperties = 1024;

/// One header line cut into words.
std::vector<std::string> split_line(TextCursor& text) {
    std::vector<std::string> words;
    for (;;) {
        while (text.peek() == ' ' || text.peek() == '\t' || text.peek() == '\r') text.advance();
        if (text.at_line_end()) break;
        const char* begin = nullptr;
        std::size_t size = 0;
        text.word(begin, size);
        // A control character: this is no text.
        if (size == 0)
            fail(Status::bad_format, "not a PLY file: line %lld of its header is no text",
                 static_cast<long long>(text.line()));
        words.emplace_back(begin, size);
        // Only comments are longer than this, and nobody reads them.
        if (words.size() > 8) break;
    }
    return words;
}

bool parse_type(const std::string& word, PlyType& type) {
    static const struct {
        const char *name, *other;
        PlyType type;
    } kNames[] = {{"char", "int8", PlyType::i8},      {"uchar", "uint8", PlyType::u8},
                  {"short", "int16", PlyType::i16},   {"ushort", "uint16", PlyType::u16},
                  {"int", "int32", PlyType::i32},     {"uint", "uint32", PlyType::u32},
                  {"float", "float32", PlyType::f32}, {"double", "float64", PlyType::f64}};
    for (const auto& entry : kNames)
        if (word == entry.name || word == entry.other) {
            type = entry.type;
            return true;
        }
    return false;
}

[[noreturn]] void fail_line(const TextCursor& text, const char* what, const std::string& word) {
    fail(Status::bad_format, "PLY header, line %lld: %s '%s'", static_cast<long long>(text.line()),
         what, shown_name(word).c_str());
}

}  // namespace

PlyHeader parse_ply_header(TextCursor& text) {
    PlyHeader header;
    std::vector<std::string> words = split_line(text);
    if (words.size() != 1 || words[0] != "ply")
        fail(Status::bad_format, "not a PLY file: it does not begin with 'ply'");
    bool has_format = false;
    std::size_t num_properties = 0;
    for (;;) {
        text.skip_line();
        if (text.at_end()) fail(Status::bad_format, "the PLY header has no 'end_header'");
        words = split_line(text);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        const std::string& keyword = words[0];
        if (keyword == "end_header") break;
        if (keyword == "format" && words.size() >= 3) {
            if (words[1] == "ascii")
                header.encoding = PlyEncoding::ascii;
            else if (words[1] == "binary_little_endian")
                header.encoding = PlyEncoding::little_endian;
            else if (words[1] == "binary_big_endian")
                header.encoding = PlyEncoding::big_endian;
            else
                fail_line(text, "unknown format", words[1]);
            if (words[2] != "1.0") fail_line(text, "unknown version", words[2]);
            has_format = true;
        } else if (keyword == "element" && words.size() >= 3) {
            PlyElement element;
            element.name = words[1];
            const char* end = words[2].data() + words[2].size();
            const auto result = std::from_chars(words[2].data(), end, element.count);
            if (result.ec != std::errc() || result.ptr != end)
                fail_line(text, "not a count:", words[2]);
            if (header.elements.size() == kMostElements)
                fail_line(text, "too many elements at", words[1]);
            header.elements.push_back(std::move(element));
        } else if (keyword == "property" && words.size() >= 3 && !header.elements.empty()) {
            PlyProperty property;
            property.is_list = words[1] == "list";
            if (property.is_list && words.size() < 5) fail_line(text, "incomplete", words[1]);
            const std::size_t first = property.is_list ? 3 : 1;
            if (!parse_type(words[first], property.type))
                fail_line(text, "unknown type", words[first]);
            if (property.is_list &&
                (!parse_type(words[2], property.count_type) ||
                 property.count_type == PlyType::f32 || property.count_type == PlyType::f64))
                fail_line(text, "a list's length cannot be", words[2]);
            property.name = words[first + 1];
            if (++num_properties > kMostProperties)
                fail_line(text, "too many properties at", property.name);
            header.elements.back().properties.push_back(std::move(property));
        } else {
            fail_line(text, "unknown or incomplete line", keyword);
        }
    }
    if (!has_format) fail(Status::bad_format, "the PLY header has no 'format' line");
    text.skip_line();
    return header;
}

}  // namespace mien::formats
