// Mesh files: PLY, OBJ, STL and OFF, ASCII and binary, by extension (any case).
#pragma once

#include <string>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Reads and checks a mesh. `path` is UTF-8. Polygons become fans; vertex colours and texture
/// coordinates are kept; STL corners with equal coordinates are welded. Hostile input ends in
/// Status::io, bad_format or invalid_mesh with the line or byte, never in a crash or a huge
/// allocation (counts are held against the file's size first).
TriMesh read_mesh_file(const std::string& path, const Context& context);

/// The same from memory; `extension` without its dot tells the format.
TriMesh read_mesh_memory(const void* data, std::size_t size, const std::string& extension,
                         const Context& context);

/// Writes atomically (temporary file beside the target, then renamed). PLY binary little endian
/// float32 with colours, OBJ with 9 significant digits (colours after the position, texture
/// coordinates), STL binary, OFF.
void write_mesh_file(const std::string& path, const TriMesh& mesh, const Context& context);

}  // namespace mien
