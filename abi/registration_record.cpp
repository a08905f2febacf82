// Registrations as files and as arrays of the host's: what a study needs of a fit, kept.
#include "arrays.hpp"
#include "guard.hpp"
#include "registration.hpp"
#include "registration/fit_record.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

/// One value per vertex, or none for null; the count is checked before anything is read.
Vector read_per_vertex(const mien_array_view* view, Index num_vertices, const char* name) {
    if (view == nullptr) return {};
    const mien_array_view& given = checked_view(view, name);
    if (given.count != static_cast<std::uint64_t>(num_vertices))
        fail(Status::mismatch, "%s holds %llu numbers for %lld vertices", name,
             static_cast<unsigned long long>(given.count), static_cast<long long>(num_vertices));
    return read_values(given, name);
}

}  // namespace

extern "C" {

mien_status MIEN_CALL mien_registration_save(mien_session* session,
                                             const mien_registration* registration,
                                             const char* path, mien_error* error) {
    return guarded(error, [&] {
        const mien_registration& fit = checked(registration, "registration");
        const char* where = checked_text(path, "path");
        const Call call(session);
        save_fit_record(where, *fit.mesh->mesh, fit.data, fit.zones, fit.tie.get(), call.context());
    });
}

mien_status MIEN_CALL mien_registration_load(mien_session* session, const char* path,
                                             mien_registration** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const char* where = checked_text(path, "path");
        const Call call(session);
        return new mien_registration(load_fit_record(where, call.context()));
    });
}

mien_status MIEN_CALL mien_registration_create(mien_session* session, const mien_mesh* mesh,
                                               const mien_array_view* weight,
                                               const mien_array_view* residual,
                                               const mien_array_view* standard_deviation,
                                               int32_t quality, mien_registration** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& face = *checked(mesh, "mesh").mesh;
        const Call call(session);
        const Index n = face.vertices.rows();
        if (quality < MIEN_QUALITY_GOOD || quality > MIEN_QUALITY_FAILED)
            fail(Status::unsupported_option, "quality is %d, which is unknown", quality);
        return new mien_registration(fit_record_of(
            face, read_per_vertex(weight, n, "weight"), read_per_vertex(residual, n, "residual"),
            read_per_vertex(standard_deviation, n, "standard_deviation"),
            static_cast<FitQuality>(quality), {}));
    });
}

}  // extern "C"
