// Levels of a template.
#include "learning/hierarchy.hpp"
#include "arrays.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "session.hpp"
#include "spectral.hpp"
#include "spectral/deformation_representation.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_hierarchy : Object {
    static constexpr Tag kTag = Tag::hierarchy;
    static constexpr const char* kName = "hierarchy";
    explicit mien_hierarchy(std::shared_ptr<const MeshHierarchy> hierarchy)
        : Object(kTag), data(std::move(hierarchy)) {}
    const std::shared_ptr<const MeshHierarchy> data;
};

namespace {

const MeshLevel& level_of(const MeshHierarchy& hierarchy, std::uint32_t level) {
    if (level >= hierarchy.levels.size())
        fail(Status::invalid_argument, "level %u of a hierarchy with %zu", level,
             hierarchy.levels.size());
    return hierarchy.levels[level];
}

const RowSparse& map_of(const MeshHierarchy& hierarchy, std::uint32_t level,
                        std::int32_t direction) {
    const MeshLevel& data = level_of(hierarchy, level);
    if (level == 0)
        fail(Status::invalid_argument, "level 0 has no maps; level names the coarser one");
    check_choice(direction, MIEN_MAP_DOWN, MIEN_MAP_UP, "direction");
    return direction == MIEN_MAP_DOWN ? data.down : data.up;
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_hierarchy_build_quadric(mien_session* session, const mien_mesh* mesh,
                                                   uint32_t level_count, double factor,
                                                   mien_hierarchy** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        return new mien_hierarchy(quadric_hierarchy(data, level_count, factor, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_build_connectivity(mien_session* session,
                                                        const mien_mesh* mesh, uint32_t level_count,
                                                        uint32_t stride, uint32_t radius,
                                                        mien_hierarchy** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        return new mien_hierarchy(
            connectivity_hierarchy(data, level_count, stride, radius, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_load(mien_session* session, const char* path,
                                          mien_hierarchy** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_hierarchy(
            load_mesh_hierarchy(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_hierarchy_save(mien_session* session, const mien_hierarchy* hierarchy,
                                          const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_mesh_hierarchy(checked_text(path, "path"), *checked(hierarchy, "hierarchy").data,
                            call.context());
    });
}

mien_status MIEN_CALL mien_hierarchy_get_level_count(const mien_hierarchy* hierarchy,
                                                     uint32_t* level_count, mien_error* error) {
    return guarded(error, [&] {
        const MeshHierarchy& data = *checked(hierarchy, "hierarchy").data;
        if (level_count == nullptr) fail(Status::invalid_argument, "level_count is null");
        store(level_count, data.levels.size());
    });
}

mien_status MIEN_CALL mien_hierarchy_get_level(const mien_hierarchy* hierarchy, uint32_t level,
                                               mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const MeshLevel& data = level_of(*checked(hierarchy, "hierarchy").data, level);
        return make_mesh(Points(data.mesh.vertices), data.mesh.triangles);
    });
}

mien_status MIEN_CALL mien_hierarchy_apply(const mien_hierarchy* hierarchy, uint32_t level,
                                           int32_t direction, const double* values,
                                           uint64_t row_count, uint64_t channel_count, double* dst,
                                           uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const RowSparse& map = map_of(*checked(hierarchy, "hierarchy").data, level, direction);
        if (channel_count < 1 || channel_count > 4096)
            fail(Status::invalid_argument, "channel_count is %llu, allowed are 1 to 4096",
                 static_cast<unsigned long long>(channel_count));
        const auto rows = static_cast<uint64_t>(map.rows());
        const std::size_t row_bytes = static_cast<std::size_t>(channel_count) * sizeof(double);
        if (dst == nullptr || capacity < rows) {
            wants_copy(rows, dst, capacity, count);
            return;
        }
        if (row_count != static_cast<uint64_t>(map.cols()))
            fail(Status::mismatch, "row_count is %llu, the map takes %lld",
                 static_cast<unsigned long long>(row_count), static_cast<long long>(map.cols()));
        if (values == nullptr || reinterpret_cast<std::uintptr_t>(values) % alignof(double) != 0)
            fail(Status::invalid_argument, "values is null or misaligned");
        const Eigen::Map<const Features> from(values, map.cols(),
                                              static_cast<Index>(channel_count));
        const Features to = map * from;
        copy_rows(to.data(), rows, row_bytes, dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_hierarchy_get_map(const mien_hierarchy* hierarchy, uint32_t level,
                                             int32_t direction, uint32_t* rows, uint32_t* columns,
                                             double* values, uint64_t capacity, uint64_t* count,
                                             uint64_t* row_count, uint64_t* column_count,
                                             mien_error* error) {
    return guarded(error, [&] {
        const RowSparse& map = map_of(*checked(hierarchy, "hierarchy").data, level, direction);
        const auto entries = static_cast<uint64_t>(map.nonZeros());
        store(count, entries);
        store(row_count, map.rows());
        store(column_count, map.cols());
        if (rows == nullptr && columns == nullptr && values == nullptr && capacity == 0) return;
        if (capacity < entries)
            fail(Status::buffer_too_small, "capacity is %llu, %llu entries are needed",
                 static_cast<unsigned long long>(capacity),
                 static_cast<unsigned long long>(entries));
        check_output(rows, "rows");
        check_output(columns, "columns");
        check_output(values, "values");
        std::size_t at = 0;
        for (Index row = 0; row < map.outerSize(); ++row)
            for (RowSparse::InnerIterator it(map, row); it; ++it, ++at) {
                if (rows != nullptr) rows[at] = static_cast<uint32_t>(row);
                if (columns != nullptr) columns[at] = static_cast<uint32_t>(it.col());
                if (values != nullptr) values[at] = it.value();
            }
    });
}

void MIEN_CALL mien_hierarchy_retain(mien_hierarchy* hierarchy) {
    retain(hierarchy);
}
void MIEN_CALL mien_hierarchy_release(mien_hierarchy* hierarchy) {
    release(hierarchy);
}

}  // extern "C"
