#include "mesh/tri_mesh.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace mien {

void check_mesh(const TriMesh& mesh, const char* what) {
    const Index num_vertices = mesh.vertices.rows(), num_triangles = mesh.triangles.rows();
    if (num_vertices == 0) fail(Status::invalid_mesh, "%s has no vertices", what);
    if (num_vertices > std::numeric_limits<std::int32_t>::max())
        fail(Status::invalid_mesh, "%s has %lld vertices, more than 2^31 - 1", what,
             static_cast<long long>(num_vertices));
    for (Index v = 0; v < num_vertices; ++v)
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(mesh.vertices(v, k)))
                fail_at(Status::invalid_mesh, v,
                        "%s: vertex %lld has a coordinate that is not finite; drop or repair it",
                        what, static_cast<long long>(v));
    for (Index t = 0; t < num_triangles; ++t)
        for (int k = 0; k < 3; ++k)
            if (mesh.triangles(t, k) >= static_cast<std::uint64_t>(num_vertices))
                fail_at(Status::invalid_mesh, t,
                        "%s: triangle %lld names vertex %lld, the mesh has %lld vertices", what,
                        static_cast<long long>(t), static_cast<long long>(mesh.triangles(t, k)),
                        static_cast<long long>(num_vertices));
    if (mesh.colors.rows() != 0 && mesh.colors.rows() != num_vertices)
        fail(Status::invalid_mesh, "%s has %lld colours for %lld vertices", what,
             static_cast<long long>(mesh.colors.rows()), static_cast<long long>(num_vertices));
    if (mesh.texture_triangles.rows() != 0 && mesh.texture_triangles.rows() != num_triangles)
        fail(Status::invalid_mesh, "%s has texture coordinates for %lld of %lld triangles", what,
             static_cast<long long>(mesh.texture_triangles.rows()),
             static_cast<long long>(num_triangles));
    for (Index t = 0; t < mesh.texture_triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            if (mesh.texture_triangles(t, k) >= static_cast<std::uint64_t>(mesh.texture.rows()))
                fail_at(Status::invalid_mesh, t,
                        "%s: triangle %lld names texture coordinate %lld of %lld", what,
                        static_cast<long long>(t),
                        static_cast<long long>(mesh.texture_triangles(t, k)),
                        static_cast<long long>(mesh.texture.rows()));
}

}  // namespace mien
