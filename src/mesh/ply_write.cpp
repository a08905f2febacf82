// PLY, binary little-endian, with colours; texture coordinates as the per-face list "texcoord", the
// images as "comment TextureFile" and, where there are several, the face's "texnumber": what
// MeshLab and Blender read. Coordinates are float32, or double where that is too coarse.
#include <algorithm>
#include <cstring>
#include <string>

#include "base/json.hpp"
#include "mesh/companions.hpp"
#include "mesh/formats.hpp"

namespace mien::formats {
namespace {

template <typename T>
void put(std::string& out, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof raw);
}

/// The number of the image of each material, -1 without.
std::int32_t image_of_triangle(const TriMesh& mesh, Index t) {
    const std::size_t material =
        mesh.triangle_materials.empty() ? 0 : mesh.triangle_materials[static_cast<std::size_t>(t)];
    return material < mesh.materials.size() ? mesh.materials[material].image : -1;
}

std::string ply_header(const TriMesh& mesh, const std::vector<std::string>& images, bool doubles,
                       bool texture, bool numbers) {
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment millimetres\n";
    for (const std::string& name : images) out += "comment TextureFile " + name + "\n";
    out += "element vertex " + std::to_string(mesh.vertices.rows());
    for (const char* axis : {"x", "y", "z"})
        out += std::string(doubles ? "\nproperty double " : "\nproperty float ") + axis;
    out += '\n';
    if (mesh.colors.rows() != 0)
        out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    out += "element face " + std::to_string(mesh.triangles.rows()) +
           "\nproperty list uchar int vertex_indices\n";
    if (texture) out += "property list uchar float texcoord\n";
    if (numbers) out += "property int texnumber\n";
    return out + "end_header\n";
}

}  // namespace

void write_ply(Target& target, const TriMesh& mesh, const Context& context) {
    const bool doubles = needs_double(mesh), colors = mesh.colors.rows() != 0;
    const bool texture = mesh.texture_triangles.rows() != 0;
    std::vector<std::string> images;
    if (texture) images = write_companion_images(target, mesh, context);
    bool numbers = false;
    for (Index t = 0; !images.empty() && t < mesh.triangles.rows(); ++t)
        numbers = numbers || image_of_triangle(mesh, t) != 0;
    std::string out = ply_header(mesh, images, doubles, texture, numbers);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        for (int k = 0; k < 3; ++k)
            if (doubles)
                put(out, mesh.vertices(v, k));
            else
                put(out, static_cast<float>(mesh.vertices(v, k)));
        if (colors) out.append(reinterpret_cast<const char*>(mesh.colors.data() + 3 * v), 3);
        write_when_long(target.file, out, context);
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
        if (numbers) put(out, image_of_triangle(mesh, t));
        write_when_long(target.file, out, context);
    }
    target.file.write(out);
}

}  // namespace mien::formats
