#include "measure/asymmetry.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "landmarks.hpp"
#include "measure.hpp"
#include "mesh.hpp"
#include "model/mirror.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_asymmetry_options default_asymmetry_options() {
    mien_asymmetry_options options{};
    options.correlation_length_mm = AsymmetryOptions().correlation_length_mm;
    return options;
}

/// The vertices of a template's landmarks.
std::vector<std::uint32_t> landmark_vertices(const mien_landmarks* landmarks) {
    std::vector<std::uint32_t> vertices;
    if (landmarks == nullptr) return vertices;
    for (const Mark& mark : checked(landmarks, "options.landmarks").file.marks)
        if (mark.where == Mark::Where::vertex) vertices.push_back(mark.vertex);
    if (vertices.empty())
        fail(Status::invalid_argument,
             "options.landmarks holds no vertex of the template; give a template's landmarks");
    return vertices;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_asymmetry_options_init(mien_asymmetry_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_asymmetry_options());
}

mien_status MIEN_CALL mien_measure_asymmetry(mien_session* session, const mien_mesh* face,
                                             const mien_mesh* template_mesh,
                                             const mien_asymmetry_options* options,
                                             mien_measurement** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_asymmetry_options given =
            read_options(options, default_asymmetry_options(),
                         MIEN_FIRST_SIZE(mien_asymmetry_options, cancel), "options");
        const TriMesh& mesh = *checked(face, "face").mesh;
        const TriMesh& symmetric = *checked(template_mesh, "template_mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_choice(given.plane, MIEN_MIRROR_BY_SURFACE, MIEN_MIRROR_BY_LANDMARKS,
                     "options.plane");
        check_numbers({{"correlation_length_mm", given.correlation_length_mm}});
        AsymmetryOptions settings;
        settings.by = static_cast<MirrorBy>(given.plane);
        settings.zones =
            read_zones(given.zones, given.zone_count, mesh.vertices.rows(), "options.zones");
        settings.landmarks = landmark_vertices(given.landmarks);
        settings.correlation_length_mm = given.correlation_length_mm;
        if (given.normal_sd.count != 0)
            settings.normal_sd_mm = read_values(given.normal_sd, "options.normal_sd");
        const MirrorMap map =
            mirror_sides(mirror_map(symmetric, call.context()), symmetric.vertices);
        Asymmetry result = measure_asymmetry(mesh, map, settings, call.context());
        std::string json = asymmetry_json(result);
        return new mien_measurement(std::move(result), std::move(json));
    });
}

mien_status MIEN_CALL mien_measurement_get_mirror_plane(const mien_measurement* measurement,
                                                        mien_mirror_plane* out, mien_error* error) {
    return guarded(error, [&] {
        const auto& planes = checked(measurement, "measurement").planes;
        if (!planes) fail(Status::not_found, "this measurement compares no left with a right");
        const MirrorPlane& plane = planes->used;
        mien_mirror_plane value{};
        value.by = static_cast<int32_t>(planes->by);
        value.pairs = static_cast<uint64_t>(plane.pairs);
        for (int axis = 0; axis < 3; ++axis) {
            value.normal[axis] = plane.normal[axis];
            value.centre[axis] = plane.centre[axis];
        }
        value.rms_mm = plane.rms_mm;
        value.tilt_sd_rad = plane.tilt_sd_rad();
        value.offset_sd_mm = plane.offset_sd_mm();
        value.between_rad = planes->between_rad;
        value.apart_mm = planes->apart_mm;
        write_struct(out, value, MIEN_FIRST_SIZE(mien_mirror_plane, apart_mm));
    });
}

}  // extern "C"
