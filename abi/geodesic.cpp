// Distances along a surface.
#include "arrays.hpp"
#include "geometry/distance_field.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_geodesic_options default_geodesic_options() {
    const HeatOptions heat;
    mien_geodesic_options options{};
    options.heat_boundary = static_cast<std::int32_t>(heat.boundary);
    options.heat_time_factor = heat.time_factor;
    return options;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_geodesic_options_init(mien_geodesic_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_geodesic_options());
}

mien_status MIEN_CALL mien_measure_geodesic(mien_session* session, const mien_mesh* mesh,
                                            const uint32_t* sources, uint64_t source_count,
                                            const mien_geodesic_options* options, double* dst,
                                            uint64_t capacity, uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const mien_geodesic_options given =
            read_options(options, default_geodesic_options(),
                         MIEN_FIRST_SIZE(mien_geodesic_options, cancel), "options");
        const TriMesh& surface = *checked(mesh, "mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_numbers({{"heat_time_factor", given.heat_time_factor}});
        check_choice(given.heat_boundary, MIEN_HEAT_NEUMANN, MIEN_HEAT_AVERAGE,
                     "options.heat_boundary");
        HeatOptions heat;
        heat.boundary = static_cast<HeatBoundary>(given.heat_boundary);
        heat.time_factor = given.heat_time_factor;
        const std::vector<std::uint32_t> from =
            read_vertices(sources, source_count, surface.vertices.rows(), "sources");
        const auto rows = static_cast<std::uint64_t>(surface.vertices.rows());
        if (!wants_copy(rows, dst, capacity, count)) return;
        const Vector field =
            distance_field(surface.vertices, surface.triangles, from, heat, call.context());
        copy_rows(field.data(), rows, sizeof(double), dst, capacity, count);
    });
}

}  // extern "C"
