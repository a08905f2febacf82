#include "mesh.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh/mesh_file.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_mesh* make_mesh(TriMesh&& mesh) {
    return new mien_mesh(std::make_shared<const TriMesh>(std::move(mesh)));
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

void MIEN_CALL mien_mesh_retain(mien_mesh* mesh) {
    retain(mesh);
}

void MIEN_CALL mien_mesh_release(mien_mesh* mesh) {
    release(mesh);
}

}  // extern "C"
