// Mesh files: PLY, OBJ, STL and OFF, ASCII and binary. What a file holds tells its format, its
// extension (any case) only where the bytes leave it open; text may carry a byte order mark, be in
// 16-bit units, and end its lines as any system does.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Reads and checks a mesh. `path` is UTF-8. Polygons become fans; vertex colours and texture
/// coordinates are kept; STL corners with equal coordinates are welded; points that are not finite
/// and part of no triangle are dropped, with a warning in the log. Hostile input ends in
/// Status::io, bad_format or invalid_mesh with the line or byte, never in a crash or a huge
/// allocation (counts are held against the file's size first).
TriMesh read_mesh_file(const std::string& path, const Context& context);

/// The same from memory; `extension` without its dot.
TriMesh read_mesh_memory(const void* data, std::size_t size, const std::string& extension,
                         const Context& context);

/// Writes by extension and atomically (temporary file beside the target, then renamed). PLY binary
/// little endian float32 with colours, OBJ with 9 significant digits (colours after the position,
/// texture coordinates), STL binary, OFF. Where float32 or 9 digits would step by more than
/// 0.001 mm, coordinates are written in double; STL, which has none, is refused then.
void write_mesh_file(const std::string& path, const TriMesh& mesh, const Context& context);

/// A kind of mesh file by its extension.
struct MeshFormat {
    const char* extension;    ///< lower case, without its dot
    const char* description;  ///< for people
    bool writes;              ///< false: read only
};

/// All formats, one entry an extension.
std::vector<MeshFormat> mesh_formats();

}  // namespace mien
