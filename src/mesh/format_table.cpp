#include "mesh/format_table.hpp"

#include <algorithm>
#include <cstring>

#include "mesh/text_cursor.hpp"

namespace mien::formats {
namespace {

constexpr std::size_t kLookedAt = 4096;  ///< bytes of a text in which its kind shows

/// The first bytes, without a byte order mark and leading blanks, as lower-case text.
std::string beginning(const char* data, std::size_t size) {
    std::size_t from = size >= 3 && std::memcmp(data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (from < size && (data[from] == ' ' || (data[from] >= '\t' && data[from] <= '\r'))) ++from;
    std::string text(data + from, std::min(kLookedAt, size - from));
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool begins_with(const std::string& text, const char* word) {
    return text.compare(0, std::strlen(word), word) == 0;
}

bool is_ply(const char* data, std::size_t size) {
    const std::string text = beginning(data, size);
    return begins_with(text, "ply") && text.size() > 3 && static_cast<unsigned char>(text[3]) <= 32;
}

bool is_stl(const char* data, std::size_t size) {
    return is_exact_binary_stl(data, size) || is_ascii_stl(data, size);
}

/// A keyword among comments: [ST][C][N][4][n]OFF.
bool is_off(const char* data, std::size_t size) {
    TextCursor text(data, data + std::min(kLookedAt, size));
    text.skip_space('#');
    const char* word = nullptr;
    std::size_t length = 0;
    text.word(word, length);
    std::size_t at = 0;
    if (length >= 2 && std::memcmp(word, "ST", 2) == 0) at = 2;
    for (char letter : {'C', 'N', '4', 'n'})
        if (at < length && word[at] == letter) ++at;
    return length >= at + 3 && std::memcmp(word + at, "OFF", 3) == 0;
}

bool is_glb(const char* data, std::size_t size) {
    return size >= 4 && std::memcmp(data, "glTF", 4) == 0;
}

/// A JSON object that says "asset" or another of glTF's lists soon.
bool is_gltf(const char* data, std::size_t size) {
    const std::string text = beginning(data, size);
    if (text.empty() || text[0] != '{') return false;
    for (const char* word : {"\"asset\"", "\"accessors\"", "\"bufferviews\""})
        if (text.find(word) != std::string::npos) return true;
    return false;
}

bool is_vtk(const char* data, std::size_t size) {
    return begins_with(beginning(data, size), "# vtk datafile");
}

bool is_vtp(const char* data, std::size_t size) {
    const std::string text = beginning(data, size);
    return !text.empty() && text[0] == '<' && text.find("<vtkfile") != std::string::npos;
}

/// A line that is a vertex or a face; a text without it may still be an OBJ, by its name.
bool looks_like_obj(const char* data, std::size_t size) {
    TextCursor text(data, data + std::min(kLookedAt, size));
    for (; !text.at_end(); text.skip_line()) {
        text.skip_blanks();
        const char* word = nullptr;
        std::size_t length = 0;
        text.word(word, length);
        if (length != 1 || *word != 'v') continue;
        text.skip_blanks();
        double value = 0.0;
        if (text.number(value)) return true;
    }
    return false;
}

constexpr Format kFormats[] = {
    {"ply", "Stanford PLY", is_ply, read_ply, write_ply},
    {"obj", "Wavefront OBJ", nullptr, read_obj, write_obj},
    {"stl", "STL", is_stl, read_stl, write_stl},
    {"off", "Geomview OFF", is_off, read_off, write_off},
    {"coff", "Geomview OFF", nullptr, read_off, write_off},
    {"glb", "glTF 2.0, binary", is_glb, read_gltf, write_glb},
    {"gltf", "glTF 2.0", is_gltf, read_gltf, nullptr},
    {"vtp", "VTK PolyData, XML", is_vtp, read_vtp, nullptr},
    {"vtk", "VTK PolyData, legacy", is_vtk, read_vtk, nullptr},
    {"xyz", "points as text", nullptr, read_xyz, nullptr},
};

}  // namespace

const Format* format_at(std::size_t index) {
    return index < sizeof kFormats / sizeof kFormats[0] ? &kFormats[index] : nullptr;
}

const Format* find_format(std::string extension) {
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Format& format : kFormats)
        if (extension == format.extension) return &format;
    return nullptr;
}

std::string extension_of(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || path.find_first_of("/\\", dot) != std::string::npos)
        return std::string();
    return path.substr(dot + 1);
}

const Format* format_of_bytes(const char* data, std::size_t size, const std::string& extension) {
    if (size == 0) return find_format(extension);
    for (const Format& format : kFormats)
        if (format.recognizes != nullptr && format.recognizes(data, size)) return &format;
    const Format* named = find_format(extension);
    // Formats with a mark of their own lack it here.
    if ((named == nullptr || named->recognizes != nullptr) && looks_like_obj(data, size))
        return find_format("obj");
    return named;
}

std::string list_of_extensions(bool written_only) {
    std::string list;
    for (const Format& format : kFormats) {
        if (written_only && format.write == nullptr) continue;
        if (!list.empty()) list += ", ";
        list += std::string(".") + format.extension;
    }
    return list;
}

}  // namespace mien::formats
