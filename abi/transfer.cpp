#include <cmath>
#include <limits>

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh.hpp"
#include "model.hpp"
#include "options.hpp"
#include "registration/transfer.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

double limit_of(double max_distance_mm) {
    if (std::isnan(max_distance_mm))
        fail(Status::invalid_argument, "max_distance_mm is not a number");
    if (max_distance_mm == 0) return kTransferDistanceMm;
    return max_distance_mm > 0 ? max_distance_mm : std::numeric_limits<double>::infinity();
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_surface_transfer_points(mien_session* session, const mien_mesh* surface,
                                                   const mien_array_view* points,
                                                   double max_distance_mm, uint32_t* triangles,
                                                   double* barycentric, double* positions,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& mesh = *checked(surface, "surface").mesh;
        const Call call(session);
        const Points places = read_points(checked_view(points, "points"), "points");
        const double limit = limit_of(max_distance_mm);
        for (Index i = 0; i < places.rows(); ++i)
            if (!places.row(i).allFinite())
                fail_at(Status::invalid_argument, i, "point %lld is not finite",
                        static_cast<long long>(i));
        const std::uint64_t rows = static_cast<std::uint64_t>(places.rows());
        store(count, rows);
        if (triangles == nullptr && barycentric == nullptr && positions == nullptr && capacity == 0)
            return;
        if (capacity < rows)
            fail(Status::buffer_too_small, "capacity is %llu, %llu rows are needed",
                 static_cast<unsigned long long>(capacity), static_cast<unsigned long long>(rows));
        check_output(triangles, "triangles");
        check_output(barycentric, "barycentric");
        check_output(positions, "positions");
        if (rows == 0) return;
        const TriangleTree tree(mesh.vertices, mesh.triangles, call.context());
        std::vector<SurfaceHit> hits;
        tree.closest(places, limit, hits, call.context());
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const Vector3 place =
                hits[i].valid() ? hits[i].point : Vector3(places.row(static_cast<Index>(i)));
            if (triangles != nullptr) triangles[i] = hits[i].triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                if (barycentric != nullptr)
                    barycentric[3 * i + k] = hits[i].barycentric[static_cast<Index>(k)];
                if (positions != nullptr) positions[3 * i + k] = place[static_cast<Index>(k)];
            }
        }
    });
}

mien_status MIEN_CALL mien_surface_transfer_zone(mien_session* session, const mien_mesh* from,
                                                 const uint32_t* vertices, uint64_t vertex_count,
                                                 const mien_mesh* to, double max_distance_mm,
                                                 uint32_t* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& source = *checked(from, "from").mesh;
        const TriMesh& target = *checked(to, "to").mesh;
        const Call call(session);
        const std::vector<std::uint32_t> zone =
            read_vertices(vertices, vertex_count, source.vertices.rows(), "vertices");
        const std::vector<std::uint32_t> inside =
            SurfaceTransfer(source, target, call.context())
                .zone(zone, TransferDirection::to_scan, limit_of(max_distance_mm), call.context());
        copy_rows(inside.data(), inside.size(), sizeof(std::uint32_t), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_surface_transfer_json(mien_session* session, const mien_model* model,
                                                 const mien_mesh* fitted, const mien_mesh* scan,
                                                 int32_t what, double max_distance_mm, char* dst,
                                                 uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const DeformationModel& face = *checked(model, "model").model;
        const TriMesh& source = *checked(fitted, "fitted").mesh;
        const TriMesh& target = *checked(scan, "scan").mesh;
        const Call call(session);
        check_choice(what, MIEN_TRANSFER_LANDMARKS, MIEN_TRANSFER_ZONES, "what");
        if (source.vertices.rows() != face.num_vertices())
            fail(Status::mismatch, "the fitted mesh has %lld vertices, the model's template %lld",
                 static_cast<long long>(source.vertices.rows()),
                 static_cast<long long>(face.num_vertices()));
        const double limit = limit_of(max_distance_mm);
        const SurfaceTransfer transfer(source, target, call.context());
        const std::string json =
            what == MIEN_TRANSFER_LANDMARKS
                ? transferred_landmarks_json(transfer, face.landmarks, limit, call.context())
                : transferred_zones_json(transfer, face.zones, limit, call.context());
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

}  // extern "C"
