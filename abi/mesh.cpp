#include "mesh.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh_file.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_mesh* make_mesh(TriMesh&& mesh) {
    return new mien_mesh(std::make_shared<const TriMesh>(std::move(mesh)));
}

constexpr std::uint64_t kMostMaterials = 65536;

std::string optional_text(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

std::shared_ptr<const TextureImage> read_image(const mien_image& given, std::size_t number) {
    auto image = std::make_shared<TextureImage>();
    image->name = optional_text(given.name);
    if ((given.file != nullptr) == (given.pixels != nullptr))
        fail_at(Status::invalid_argument, static_cast<std::int64_t>(number),
                "images[%zu] needs either pixels or the bytes of a file", number);
    if (given.file != nullptr) {
        if (given.file_size == 0 || given.file_size > (std::uint64_t(1) << 32))
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(number),
                    "images[%zu].file_size is %llu", number,
                    static_cast<unsigned long long>(given.file_size));
        image->encoded.assign(reinterpret_cast<const char*>(given.file),
                              static_cast<std::size_t>(given.file_size));
        return image;
    }
    const std::uint64_t row = 3 * std::uint64_t(given.width);
    const std::uint64_t stride = given.row_stride_bytes == 0 ? row : given.row_stride_bytes;
    if (row == 0 || given.height == 0 || stride < row ||
        given.width > static_cast<std::uint64_t>(kMostPixels) / given.height)
        fail_at(Status::invalid_argument, static_cast<std::int64_t>(number),
                "images[%zu] of %lu x %lu pixels in rows of %llu bytes is no image", number,
                static_cast<unsigned long>(given.width), static_cast<unsigned long>(given.height),
                static_cast<unsigned long long>(stride));
    image->width = given.width;
    image->height = given.height;
    image->pixels.reserve(static_cast<std::size_t>(row * given.height));
    for (std::uint64_t y = 0; y < given.height; ++y) {
        const std::uint8_t* from = given.pixels + y * stride;
        image->pixels.insert(image->pixels.end(), from, from + row);
    }
    return image;
}

/// Texture coordinates, materials and images; check_mesh() holds their numbers against each other.
void read_appearance(const mien_mesh_arrays& arrays, TriMesh& mesh) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
    check_array(arrays.texture, arrays.texture_count, alignof(float), kMost, "texture");
    check_array(arrays.materials, arrays.material_count, alignof(mien_material), kMostMaterials,
                "materials");
    check_array(arrays.images, arrays.image_count, alignof(mien_image), kMostMaterials, "images");
    check_output(arrays.texture_triangles, "texture_triangles");
    check_output(arrays.triangle_materials, "triangle_materials");
    const Index num_triangles = mesh.triangles.rows();
    if (arrays.texture_count != 0) {
        mesh.texture = Eigen::Map<const TextureCoordinates>(
            arrays.texture, static_cast<Index>(arrays.texture_count), 2);
        if (!mesh.texture.allFinite())
            fail(Status::invalid_mesh, "texture has a coordinate that is not finite");
        if (arrays.texture_triangles != nullptr)
            mesh.texture_triangles =
                Eigen::Map<const Triangles>(arrays.texture_triangles, num_triangles, 3);
        else if (mesh.texture.rows() == mesh.vertices.rows())
            mesh.texture_triangles = mesh.triangles;
        else
            fail(Status::invalid_argument,
                 "texture_triangles is null, and texture_count %llu is not the number of vertices",
                 static_cast<unsigned long long>(arrays.texture_count));
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(arrays.material_count); ++k) {
        const mien_material& given = arrays.materials[k];
        Material material;
        material.name = optional_text(given.name);
        material.image = given.image;
        const double color[3] = {given.red, given.green, given.blue};
        for (std::size_t c = 0; c < 3; ++c) {
            if (!(color[c] >= 0.0 && color[c] <= 1.0))
                fail_at(Status::invalid_argument, static_cast<std::int64_t>(k),
                        "materials[%zu] has a colour outside of 0 to 1", k);
            material.color[c] = static_cast<float>(color[c]);
        }
        mesh.materials.push_back(std::move(material));
    }
    if (arrays.triangle_materials != nullptr)
        mesh.triangle_materials.assign(arrays.triangle_materials,
                                       arrays.triangle_materials + num_triangles);
    for (std::size_t k = 0; k < static_cast<std::size_t>(arrays.image_count); ++k)
        mesh.images.push_back(read_image(arrays.images[k], k));
}

mien_mesh* mesh_from_arrays(mien_session* session, const mien_mesh_arrays* host_arrays) {
    const Call call(session);
    if (host_arrays == nullptr) fail(Status::invalid_argument, "arrays is null");
    const mien_mesh_arrays arrays = read_options(
        host_arrays, mien_mesh_arrays{}, MIEN_FIRST_SIZE(mien_mesh_arrays, colors), "arrays");
    if (arrays.reserved != 0) fail(Status::unsupported_option, "arrays.reserved is not zero");
    check_view(arrays.positions, 3, "positions");
    if (arrays.triangle_count > std::numeric_limits<std::int32_t>::max())
        fail(Status::invalid_argument, "triangle_count is %llu, more than 2^31 - 1",
             static_cast<unsigned long long>(arrays.triangle_count));
    if (arrays.triangle_count != 0 && arrays.triangles == nullptr)
        fail(Status::invalid_argument, "triangles is null, triangle_count is not 0");
    if (reinterpret_cast<std::uintptr_t>(arrays.triangles) % alignof(std::uint32_t) != 0)
        fail(Status::invalid_argument, "triangles is not aligned to its 4-byte values");
    call.context().require_memory(static_cast<std::size_t>(arrays.positions.count) * 27 +
                                      static_cast<std::size_t>(arrays.triangle_count) * 12,
                                  "a mesh");

    TriMesh mesh;
    mesh.vertices = read_points(arrays.positions, "positions");
    if (arrays.triangle_count != 0)
        mesh.triangles = Eigen::Map<const Triangles>(arrays.triangles,
                                                     static_cast<Index>(arrays.triangle_count), 3);
    if (arrays.colors != nullptr)
        mesh.colors = Eigen::Map<const Colors>(arrays.colors, mesh.vertices.rows(), 3);
    read_appearance(arrays, mesh);
    check_mesh(mesh, "the mesh");
    return make_mesh(std::move(mesh));
}

}  // namespace

extern "C" {

void MIEN_CALL mien_mesh_arrays_init(mien_mesh_arrays* arrays, size_t struct_size) {
    write_defaults(arrays, struct_size, mien_mesh_arrays{});
}

mien_status MIEN_CALL mien_mesh_create(mien_session* session, const mien_mesh_arrays* arrays,
                                       mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] { return mesh_from_arrays(session, arrays); });
}

mien_status MIEN_CALL mien_mesh_load(mien_session* session, const char* path, mien_mesh** out,
                                     mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return make_mesh(read_mesh_file(checked_text(path, "path"), call.context()));
    });
}

mien_status MIEN_CALL mien_mesh_save(mien_session* session, const mien_mesh* mesh, const char* path,
                                     mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        write_mesh_file(checked_text(path, "path"), *checked(mesh, "mesh").mesh, call.context());
    });
}

mien_status MIEN_CALL mien_mesh_get_counts(const mien_mesh* mesh, uint64_t* vertex_count,
                                           uint64_t* triangle_count, mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        store(vertex_count, data.vertices.rows());
        store(triangle_count, data.triangles.rows());
    });
}

mien_status MIEN_CALL mien_mesh_get_positions(const mien_mesh* mesh, mien_dtype dtype, void* dst,
                                              uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const Points& points = checked(mesh, "mesh").mesh->vertices;
        copy_doubles(points.data(), static_cast<uint64_t>(points.rows()), 3, dtype, dst, capacity,
                     count);
    });
}

mien_status MIEN_CALL mien_mesh_get_triangles(const mien_mesh* mesh, uint32_t* dst,
                                              uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const Triangles& triangles = checked(mesh, "mesh").mesh->triangles;
        copy_rows(triangles.data(), static_cast<uint64_t>(triangles.rows()), 3 * sizeof(uint32_t),
                  dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_get_colors(const mien_mesh* mesh, uint8_t* dst, uint64_t capacity,
                                           uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Colors& colors = checked(mesh, "mesh").mesh->colors;
        copy_rows(colors.data(), static_cast<uint64_t>(colors.rows()), 3, dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_mesh_positions_view(const mien_mesh* mesh, const double** data,
                                               uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Points& points = checked(mesh, "mesh").mesh->vertices;
        if (data == nullptr) fail(Status::invalid_argument, "data is null");
        store(data, points.data());
        store(count, points.rows());
    });
}

mien_mesh* MIEN_CALL mien_mesh_retain(const mien_mesh* mesh) {
    // A mesh is never changed; only its count of references is, which is the library's own.
    auto* const own = const_cast<mien_mesh*>(mesh);
    if (!is_live(own)) return nullptr;
    retain(own);
    return own;
}

void MIEN_CALL mien_mesh_release(mien_mesh* mesh) {
    release(mesh);
}

}  // extern "C"
