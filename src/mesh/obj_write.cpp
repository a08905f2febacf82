// Wavefront OBJ with 9 significant digits, or all where 9 are too coarse; colours after the
// position, texture coordinates, and the materials in a library beside it.
#include <string>

#include "mesh/companions.hpp"
#include "mesh/formats.hpp"
#include "mesh/material_library.hpp"

namespace mien::formats {
namespace {

void append_face(std::string& out, const TriMesh& mesh, Index t, bool texture) {
    out += 'f';
    for (int k = 0; k < 3; ++k) {
        append_number(out, std::uint64_t(mesh.triangles(t, k)) + 1);
        if (!texture) continue;
        const std::size_t blank = out.size();
        append_number(out, std::uint64_t(mesh.texture_triangles(t, k)) + 1);
        out[blank] = '/';
    }
    out += '\n';
}

}  // namespace

void write_obj(Target& target, const TriMesh& mesh, const Context& context) {
    std::string out = "# millimetres\n";
    const bool colors = mesh.colors.rows() != 0, texture = mesh.texture_triangles.rows() != 0;
    std::vector<std::string> names;
    if (!mesh.materials.empty() && mesh.triangles.rows() != 0)
        names = write_material_library(target, mesh, out, context);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        out += 'v';
        for (int k = 0; k < 3; ++k) append_coordinate(out, mesh.vertices(v, k));
        // Six digits bring every byte back.
        if (colors)
            for (int k = 0; k < 3; ++k) append_number(out, mesh.colors(v, k) / 255.0, 6);
        out += '\n';
        write_when_long(target.file, out, context);
    }
    for (Index t = 0; texture && t < mesh.texture.rows(); ++t) {
        out += "vt";
        for (int k = 0; k < 2; ++k) append_number(out, static_cast<double>(mesh.texture(t, k)));
        out += '\n';
        write_when_long(target.file, out, context);
    }
    std::size_t current = names.size();
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const std::size_t material = mesh.triangle_materials.empty()
                                         ? 0
                                         : mesh.triangle_materials[static_cast<std::size_t>(t)];
        if (material < names.size() && material != current) {
            out += "usemtl " + names[material] + "\n";
            current = material;
        }
        append_face(out, mesh, t, texture);
        write_when_long(target.file, out, context);
    }
    target.file.write(out);
}

}  // namespace mien::formats
