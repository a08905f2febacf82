// A small JSON document: for files of a few kilobytes that may come in many shapes, where one
// receiver per shape would be longer than the shapes. Nothing in it allocates while it is
// destroyed (base/json.hpp says why nlohmann's own values are not used).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mien {

/// One value with everything under it. Objects keep the order of the file; a key may come twice.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    double number = 0;              ///< 0 or 1 for a boolean
    std::string text;               ///< of a string
    std::vector<std::string> keys;  ///< of an object, one per item
    std::vector<JsonValue> items;   ///< of an array or object

    bool is(Kind other) const { return kind == other; }
    /// The first value under a key, or null when this is no object or has none.
    const JsonValue* find(const char* key) const;
};

/// Parses the whole text. NaN and Infinity, which Python writes though JSON has none, read as null.
/// Throws Status::bad_format, with `what` in front, for what is not one JSON value or is nested
/// more than 64 deep. O(size).
JsonValue parse_json_value(const char* text, std::size_t size, const char* what);

}  // namespace mien
