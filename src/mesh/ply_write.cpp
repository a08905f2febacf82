// PLY, binary little-endian float32, with colours; texture coordinates as the per-face list
// "texcoord" that MeshLab and Blender read.
#include <algorithm>
#include <cstring>
#include <string>

#include "mesh/formats.hpp"

namespace mien::formats {
namespace {

template <typename T>
void put(std::string& out, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof raw);
}

}  // namespace

void write_ply(AtomicFile& file, const TriMesh& mesh, const Context& context) {
    check_float_range(mesh);
    const bool colors = mesh.colors.rows() != 0, texture = mesh.texture_triangles.rows() != 0;
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement vertex " +
                      std::to_string(mesh.vertices.rows()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n";
    if (colors) out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    out += "element face " + std::to_string(mesh.triangles.rows()) +
           "\nproperty list uchar int vertex_indices\n";
    if (texture) out += "property list uchar float texcoord\n";
    out += "end_header\n";
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        for (int k = 0; k < 3; ++k) put(out, static_cast<float>(mesh.vertices(v, k)));
        if (colors) out.append(reinterpret_cast<const char*>(mesh.colors.data() + 3 * v), 3);
        write_when_long(file, out, context);
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        out += '\3';
        for (int k = 0; k < 3; ++k) put(out, mesh.triangles(t, k));
        if (texture) {
            out += '\6';
            for (int k = 0; k < 3; ++k)
                for (int axis = 0; axis < 2; ++axis)
                    put(out, mesh.texture(static_cast<Index>(mesh.texture_triangles(t, k)), axis));
        }
        write_when_long(file, out, context);
    }
    file.write(out);
}

}  // namespace mien::formats
