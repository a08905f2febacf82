#include "mesh/tri_mesh.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace mien {

namespace {

void check_materials(const TriMesh& mesh, const char* what) {
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
        const std::int32_t image = mesh.materials[k].image;
        if (image < -1 || (image >= 0 && static_cast<std::size_t>(image) >= mesh.images.size()))
            fail_at(Status::invalid_mesh, static_cast<std::int64_t>(k),
                    "%s: material %zu names image %ld of %zu", what, k, static_cast<long>(image),
                    mesh.images.size());
    }
    for (std::size_t k = 0; k < mesh.images.size(); ++k) {
        const TextureImage* image = mesh.images[k].get();
        const bool sound = image != nullptr && image->width >= 0 && image->height >= 0 &&
                           image->encoded.empty() != image->pixels.empty() &&
                           image->pixels.size() == 3 * static_cast<std::size_t>(image->width) *
                                                       static_cast<std::size_t>(image->height);
        if (!sound)
            fail_at(Status::invalid_mesh, static_cast<std::int64_t>(k),
                    "%s: image %zu needs either a file's bytes or width x height x 3 pixels", what,
                    k);
    }
    const std::vector<std::uint32_t>& numbers = mesh.triangle_materials;
    if (!numbers.empty() && static_cast<Index>(numbers.size()) != mesh.triangles.rows())
        fail(Status::invalid_mesh, "%s has materials for %zu of %lld triangles", what,
             numbers.size(), static_cast<long long>(mesh.triangles.rows()));
    for (std::size_t t = 0; t < numbers.size(); ++t)
        if (numbers[t] >= mesh.materials.size())
            fail_at(Status::invalid_mesh, static_cast<std::int64_t>(t),
                    "%s: triangle %zu names material %lu of %zu", what, t,
                    static_cast<unsigned long>(numbers[t]), mesh.materials.size());
}

}  // namespace

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
    check_materials(mesh, what);
}

}  // namespace mien
