// The one list of mesh formats: their extensions, what their bytes begin with, who reads and writes
// them. What a file holds decides; its name decides only where the bytes leave it open.
#pragma once

#include <cstddef>
#include <string>

#include "mesh/formats.hpp"

namespace mien::formats {

struct Format {
    const char* extension;    ///< lower case, without its dot
    const char* description;  ///< for people
    /// True when the bytes can be of this format and of no other one; null: nothing tells it.
    bool (*recognizes)(const char* data, std::size_t size);
    TriMesh (*read)(const Source&, const Context&);
    void (*write)(Target&, const TriMesh&, const Context&);  ///< null: read only
};

/// In the order in which they are asked whether they recognize a file; null past the end.
const Format* format_at(std::size_t index);

/// By extension without its dot, any case; null when there is none.
const Format* find_format(std::string extension);

/// What a path ends with after its last dot, or nothing.
std::string extension_of(const std::string& path);

/// The format of a file's bytes: the one that recognizes them, else the one of the extension, else
/// null. A text OBJ is taken for one under another name only when nothing else is possible.
const Format* format_of_bytes(const char* data, std::size_t size, const std::string& extension);

/// ".ply, .obj, ..." of the formats that are read, or only of those that are written.
std::string list_of_extensions(bool written_only);

}  // namespace mien::formats
