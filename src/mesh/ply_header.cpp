#include "mesh/ply_header.hpp"

#include "base/json.hpp"

namespace mien::formats {
namespace {

constexpr std::size_t kMostElements = 64, kMostProperties = 1024;

/// One header line cut into words.
std::vector<std::string> split_line(TextCursor& text) {
    std::vector<std::string> words;
    for (;;) {
        while (text.peek() == ' ' || text.peek() == '\t') text.advance();
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

/// "comment TextureFile NAME", as MeshLab writes it; the name may hold blanks.
void take_comment(TextCursor line, PlyHeader& header) {
    const char* word = nullptr;
    std::size_t size = 0;
    line.skip_blanks();
    line.word(word, size);
    line.skip_blanks();
    line.word(word, size);
    if (ply_lower_case(std::string(word, size)) != "texturefile") return;
    line.rest_of_line(word, size);
    if (size != 0 && header.texture_files.size() < kMostElements)
        header.texture_files.emplace_back(word, size);
}

/// Over the end of the header's last line. Data may begin with any byte, so only what ends the
/// other lines too is taken: a line feed after a carriage return only when the first line has both.
void skip_last_line(TextCursor& text, bool lone_returns) {
    while (!text.at_line_end()) text.advance();
    if (text.at_end()) return;
    const bool carriage_return = text.peek() == '\r';
    text.advance();
    if (carriage_return && !lone_returns && text.peek() == '\n') text.advance();
}

PlyProperty parse_property(const std::vector<std::string>& words, const TextCursor& text) {
    PlyProperty property;
    property.is_list = words[1] == "list";
    if (property.is_list && words.size() < 5) fail_line(text, "incomplete", words[1]);
    const std::size_t first = property.is_list ? 3 : 1;
    if (!parse_type(words[first], property.type)) fail_line(text, "unknown type", words[first]);
    if (property.is_list &&
        (!parse_type(words[2], property.count_type) || property.count_type == PlyType::f32 ||
         property.count_type == PlyType::f64))
        fail_line(text, "a list's length cannot be", words[2]);
    property.name = ply_lower_case(words[first + 1]);
    return property;
}

}  // namespace

std::string ply_lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

PlyHeader parse_ply_header(TextCursor& text) {
    PlyHeader header;
    text.skip_space();
    std::vector<std::string> words = split_line(text);
    if (words.size() != 1 || ply_lower_case(words[0]) != "ply")
        fail(Status::bad_format, "not a PLY file: it does not begin with 'ply'");
    const bool lone_returns = text.remaining() >= 2 && text.at()[0] == '\r' && text.at()[1] != '\n';
    bool has_format = false;
    std::size_t num_properties = 0;
    for (;;) {
        text.skip_line();
        if (text.at_end()) fail(Status::bad_format, "the PLY header has no 'end_header'");
        const TextCursor line = text;
        words = split_line(text);
        if (!words.empty() && words[0] == "comment") take_comment(line, header);
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
            PlyProperty property = parse_property(words, text);
            if (++num_properties > kMostProperties)
                fail_line(text, "too many properties at", property.name);
            header.elements.back().properties.push_back(std::move(property));
        } else {
            fail_line(text, "unknown or incomplete line", keyword);
        }
    }
    if (!has_format) fail(Status::bad_format, "the PLY header has no 'format' line");
    skip_last_line(text, lone_returns);
    return header;
}

}  // namespace mien::formats
