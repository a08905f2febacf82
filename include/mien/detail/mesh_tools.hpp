// Inspecting and mending meshes, in the C++ face.
#ifndef MIEN_DETAIL_MESH_TOOLS_HPP
#define MIEN_DETAIL_MESH_TOOLS_HPP

#include "core.hpp"

namespace mien {

/// What a mesh is and what is wrong with it, as JSON text.
inline std::string inspect_mesh(const Session& session, const Mesh& mesh) {
    return detail::read_text(
        [&session](const mien_mesh* m, char* dst, std::uint64_t capacity, std::uint64_t* count,
                   mien_error* error) {
            return mien_mesh_inspect(session.get(), m, dst, capacity, count, error);
        },
        mesh.get());
}

/// Without doubled, degenerate and unused parts and small pieces, wound alike.
inline Mesh clean_mesh(const Session& session, const Mesh& mesh, std::uint64_t min_triangles = 0) {
    mien_mesh* out = nullptr;
    detail::call(mien_mesh_clean, session.get(), mesh.get(), min_triangles, &out);
    return Mesh(out);
}

/// Moved by a row-major 4 x 4 matrix.
inline Mesh transform_mesh(const Session& session, const Mesh& mesh,
                           const std::array<double, 16>& matrix) {
    mien_mesh* out = nullptr;
    detail::call(mien_mesh_transform, session.get(), mesh.get(), matrix.data(), &out);
    return Mesh(out);
}

/// Inside becomes outside.
inline Mesh turn_mesh_over(const Session& session, const Mesh& mesh) {
    mien_mesh* out = nullptr;
    detail::call(mien_mesh_turn_over, session.get(), mesh.get(), &out);
    return Mesh(out);
}

/// With about so many vertices.
inline Mesh decimate_mesh(const Session& session, const Mesh& mesh, std::uint64_t vertex_count) {
    mien_mesh* out = nullptr;
    detail::call(mien_mesh_decimate, session.get(), mesh.get(), vertex_count, &out);
    return Mesh(out);
}

/// Throws when two meshes of one face cannot be in one unit.
inline void check_same_unit(const Mesh& first, const Mesh& second) {
    detail::call(mien_mesh_check_same_unit, first.get(), second.get());
}

}  // namespace mien

#endif
