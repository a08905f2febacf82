// The JSON header of a safetensors file as its entries, checked for form only.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mien {

struct SafetensorsEntry {
    std::string name, dtype;
    std::vector<std::uint64_t> shape;
    std::uint64_t begin = 0, end = 0;  ///< bytes within the data
};

struct SafetensorsHeader {
    std::map<std::string, std::string> metadata;
    std::vector<SafetensorsEntry> entries;  ///< in file order
};

/// Throws Status::bad_format for anything but one object of tensors with exactly dtype, shape and
/// data_offsets, and __metadata__ of strings; duplicate names and keys are refused.
SafetensorsHeader parse_safetensors_header(const char* text, std::size_t size);

}  // namespace mien
