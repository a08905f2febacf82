// The header of a PLY file: what elements follow, of which properties.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/text_cursor.hpp"

namespace mien::formats {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class PlyEncoding { ascii, little_endian, big_endian };

inline std::size_t ply_type_bytes(PlyType type) {
    constexpr std::size_t kBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kBytes[static_cast<int>(type)];
}

struct PlyProperty {
    std::string name;  ///< in lower case
    PlyType type = PlyType::f32;
    bool is_list = false;
    PlyType count_type = PlyType::u8;
};

struct PlyElement {
    std::string name;  ///< as written
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> texture_files;  ///< of the comments "TextureFile NAME", in order
};

std::string ply_lower_case(std::string text);

/// Leaves the cursor at the first byte of data. Throws Status::bad_format with the line.
PlyHeader parse_ply_header(TextCursor& text);

}  // namespace mien::formats
