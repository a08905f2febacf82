#include <algorithm>
#include <cmath>

#include "arrays.hpp"
#include "geometry/rigid_zone.hpp"
#include "guard.hpp"
#include "measure.hpp"
#include "measure/area.hpp"
#include "measure/lengths.hpp"
#include "measure/measurement.hpp"
#include "measure/pair_check.hpp"
#include "measure/scan_volume.hpp"
#include "mesh.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_measure_options default_measure_options() {
    mien_measure_options options{};
    options.skip_borders = 1;
    options.correlation_length_mm = VolumeErrorModel().correlation_length_mm;
    return options;
}

mien_measure_options read_measure_options(const mien_measure_options* given) {
    const mien_measure_options options = read_options(
        given, default_measure_options(), MIEN_FIRST_SIZE(mien_measure_options, cancel), "options");
    (void)read_switch(options.skip_borders, "options.skip_borders");
    check_numbers({{"correlation_length_mm", options.correlation_length_mm},
                   {"alignment_rotation_sd_rad", options.alignment_rotation_sd_rad},
                   {"alignment_translation_sd_mm", options.alignment_translation_sd_mm},
                   {"alignment_centre[0]", options.alignment_centre[0]},
                   {"alignment_centre[1]", options.alignment_centre[1]},
                   {"alignment_centre[2]", options.alignment_centre[2]},
                   {"common_bias_mm", options.common_bias_mm},
                   {"limit_of_detection_ml", options.limit_of_detection_ml},
                   {"max_distance_mm", options.max_distance_mm}});
    if (options.before_sd.count != 0) check_view(options.before_sd, 1, "options.before_sd");
    if (options.after_sd.count != 0) check_view(options.after_sd, 1, "options.after_sd");
    return options;
}

std::vector<Zone> zones_of(const mien_measure_options& options, const TriMesh& before) {
    return read_zones(options.zones, options.zone_count, before.vertices.rows(), "options.zones");
}

Zone checked_zone(const mien_zone* zone, const TriMesh& mesh) {
    check_array(zone, 1, alignof(mien_zone), 1, "the zone");
    return read_zone(*zone, mesh.vertices.rows());
}

std::optional<VolumeErrorModel> read_errors(const mien_measure_options& options) {
    VolumeErrorModel errors;
    if (options.before_sd.count != 0)
        errors.sd_before_mm = read_values(options.before_sd, "options.before_sd");
    if (options.after_sd.count != 0)
        errors.sd_after_mm = read_values(options.after_sd, "options.after_sd");
    const double rotation = options.alignment_rotation_sd_rad,
                 shift = options.alignment_translation_sd_mm;
    if (!(rotation >= 0) || !(shift >= 0))
        fail(Status::invalid_argument,
             "the alignment's deviations are %g rad and %g mm; give zero or more", rotation, shift);
    errors.alignment_covariance.diagonal().head<3>().setConstant(rotation * rotation);
    errors.alignment_covariance.diagonal().tail<3>().setConstant(shift * shift);
    errors.alignment_centre = Vector3(options.alignment_centre[0], options.alignment_centre[1],
                                      options.alignment_centre[2]);
    errors.correlation_length_mm = options.correlation_length_mm;
    errors.common_bias_mm = options.common_bias_mm;
    // An interval of the alignment or the bias alone would promise too much.
    const bool known = options.before_sd.count != 0 || options.after_sd.count != 0;
    return known ? std::optional<VolumeErrorModel>(errors) : std::nullopt;
}

mien_measurement* finish_distance(DistanceReport&& report, const std::vector<Zone>& zones) {
    Measurement result;
    for (const Zone& zone : zones) result.zone_names.push_back(zone.name);
    result.distance = std::move(report);
    return new mien_measurement(std::move(result));
}

}  // namespace

extern "C" {

void MIEN_CALL mien_measure_options_init(mien_measure_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_measure_options());
}

mien_status MIEN_CALL mien_measure_volume(mien_session* session, const mien_mesh* before,
                                          const mien_mesh* after,
                                          const mien_measure_options* options,
                                          mien_measurement** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_measure_options given = read_measure_options(options);
        const TriMesh& first = *checked(before, "before").mesh;
        const TriMesh& second = *checked(after, "after").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        MeasureOptions settings;
        settings.zones = zones_of(given, first);
        settings.errors = read_errors(given);
        settings.limit_of_detection_ml = given.limit_of_detection_ml;
        return new mien_measurement(measure_volume_fully(
            first.vertices, second.vertices, first.triangles, settings, call.context()));
    });
}

mien_status MIEN_CALL mien_measure_distance(mien_session* session, const mien_mesh* before,
                                            const mien_mesh* after,
                                            const mien_measure_options* options,
                                            mien_measurement** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_measure_options given = read_measure_options(options);
        const TriMesh& first = *checked(before, "before").mesh;
        const TriMesh& second = *checked(after, "after").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const std::vector<Zone> zones = zones_of(given, first);
        return finish_distance(measure_distance(first.vertices, second.vertices, first.triangles,
                                                zones, call.context()),
                               zones);
    });
}

mien_status MIEN_CALL mien_measure_surface_distance(mien_session* session, const mien_mesh* before,
                                                    const mien_mesh* after,
                                                    const mien_measure_options* options,
                                                    mien_measurement** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_measure_options given = read_measure_options(options);
        const TriMesh& first = *checked(before, "before").mesh;
        const TriMesh& second = *checked(after, "after").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const std::vector<Zone> zones = zones_of(given, first);
        return finish_distance(measure_surface_distance(first, second, zones, given.max_distance_mm,
                                                        given.skip_borders != 0, call.context()),
                               zones);
    });
}

mien_status MIEN_CALL mien_measure_closed_volume(mien_session* session, const mien_mesh* mesh,
                                                 int32_t close_rims, double* volume_ml,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        if (volume_ml == nullptr) fail(Status::invalid_argument, "volume_ml is null");
        const bool close = read_switch(close_rims, "close_rims");
        const double volume =
            closed_volume_ml(data.vertices, data.triangles,
                             close ? OpenRims::fan_to_centroid : OpenRims::refuse, call.context());
        store(volume_ml, volume);
    });
}

mien_status MIEN_CALL mien_measure_area(mien_session* session, const mien_mesh* mesh,
                                        const mien_zone* zone, double* area_mm2,
                                        mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        if (area_mm2 == nullptr) fail(Status::invalid_argument, "area_mm2 is null");
        store(area_mm2, zone == nullptr
                            ? surface_area_mm2(data.vertices, data.triangles)
                            : zone_areas(data.vertices, data.triangles, {checked_zone(zone, data)})
                                  .front()
                                  .area_mm2);
    });
}

mien_status MIEN_CALL mien_measure_curvature(mien_session* session, const mien_mesh* mesh,
                                             double radius_mm, int32_t robust,
                                             const mien_measure_options* options,
                                             mien_measurement** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_measure_options given = read_measure_options(options);
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_numbers({{"radius_mm", radius_mm}});
        const bool fit_robustly = read_switch(robust, "robust");
        const std::vector<Zone> zones = zones_of(given, data);
        Measurement result;
        for (const Zone& zone : zones) result.zone_names.push_back(zone.name);
        result.curvature = measure_curvature(data.vertices, data.triangles, zones,
                                             {radius_mm, fit_robustly}, call.context());
        return new mien_measurement(std::move(result));
    });
}

mien_status MIEN_CALL mien_measure_lengths(mien_session* session, const mien_mesh* mesh,
                                           const uint32_t* pairs, uint64_t pair_count,
                                           double* straight_mm, double* geodesic_mm,
                                           mien_error* error) {
    return guarded(error, [&] {
        const TriMesh& data = *checked(mesh, "mesh").mesh;
        const Call call(session);
        if (pair_count == 0) fail(Status::invalid_argument, "pair_count is 0");
        check_array(pairs, pair_count, alignof(uint32_t),
                    static_cast<std::uint64_t>(data.vertices.rows()), "pairs");
        check_output(straight_mm, "straight_mm");
        check_output(geodesic_mm, "geodesic_mm");
        std::vector<std::array<std::uint32_t, 2>> ends(static_cast<std::size_t>(pair_count));
        for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = {pairs[2 * k], pairs[2 * k + 1]};
        const std::vector<PlaceLength> lengths =
            measure_lengths(data.vertices, data.triangles, ends, call.context());
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            if (straight_mm != nullptr) straight_mm[k] = lengths[k].straight_mm;
            if (geodesic_mm != nullptr) geodesic_mm[k] = lengths[k].geodesic_mm;
        }
    });
}

mien_status MIEN_CALL mien_measure_scan_volume(mien_session* session, const mien_mesh* before,
                                               const mien_mesh* after, int32_t carry,
                                               const double* direction,
                                               const mien_measure_options* options,
                                               double* coverage, mien_measurement** out,
                                               mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_measure_options given = read_measure_options(options);
        const TriMesh& first = *checked(before, "before").mesh;
        const TriMesh& second = *checked(after, "after").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_choice(carry, MIEN_CARRY_CLOSEST_POINT, MIEN_CARRY_VERTEX_NORMAL, "carry");
        check_output(direction, "direction");
        if (carry == MIEN_CARRY_DIRECTION && direction == nullptr)
            fail(Status::invalid_argument, "direction is null");
        ScanVolumeOptions settings;
        settings.carry = static_cast<Carry>(carry);
        if (direction != nullptr)
            settings.direction = Vector3(direction[0], direction[1], direction[2]);
        if (given.max_distance_mm != 0) settings.max_distance_mm = given.max_distance_mm;
        settings.zones = zones_of(given, first);
        ScanVolumeReport report = measure_scan_volume(first, second, settings, call.context());
        Measurement result = measurement_of(report, given.limit_of_detection_ml);
        auto made = std::make_unique<mien_measurement>(std::move(result));
        store(coverage, report.whole_coverage);
        return made.release();
    });
}

mien_status MIEN_CALL mien_measure_align(mien_session* session, const mien_mesh* moving,
                                         const mien_mesh* target, const mien_zone* stable,
                                         mien_zone_alignment* info, mien_mesh** out,
                                         mien_error* error) {
    return guarded_create(out, error, [&] {
        const TriMesh& source = *checked(moving, "moving").mesh;
        const TriMesh& fixed = *checked(target, "target").mesh;
        const Call call(session);
        const Zone zone = stable != nullptr ? checked_zone(stable, fixed) : Zone();
        const bool in_correspondence =
            source.vertices.rows() == fixed.vertices.rows() &&
            (source.triangles.rows() == 0 || (source.triangles.rows() == fixed.triangles.rows() &&
                                              source.triangles == fixed.triangles));
        RigidZoneResult result;
        if (in_correspondence) {
            check_faces_in_correspondence(fixed.vertices, source.vertices, fixed.triangles);
            result = align_fits_on_zone(source.vertices, fixed, zone.vertices, call.context());
        } else {
            check_surface(source.vertices, source.triangles, "moving");
            check_surface(fixed.vertices, fixed.triangles, "target");
            result =
                align_scans_on_zone(source, fixed, zone.vertices, Similarity(), {}, call.context());
        }
        TriMesh moved = source;
        moved.vertices = result.motion.apply(PointsRef(source.vertices));
        auto made = std::make_unique<mien_mesh>(std::make_shared<const TriMesh>(std::move(moved)));
        if (info != nullptr) {
            mien_zone_alignment value{};
            value.pairs = static_cast<uint64_t>(result.pairs);
            value.rms_mm = result.rms_mm;
            value.rotation_sd_rad = std::sqrt(result.covariance.diagonal().head<3>().mean());
            value.translation_sd_mm = std::sqrt(result.covariance.diagonal().tail<3>().mean());
            for (int r = 0; r < 3; ++r) {
                value.centre[r] = result.centre[r];
                for (int c = 0; c < 3; ++c) value.matrix[4 * r + c] = result.motion.rotation(r, c);
                value.matrix[4 * r + 3] = result.motion.translation[r];
            }
            value.matrix[15] = 1;
            write_struct(info, value, MIEN_FIRST_SIZE(mien_zone_alignment, matrix));
        }
        return made.release();
    });
}

mien_status MIEN_CALL mien_measurement_get_zones(const mien_measurement* measurement,
                                                 uint32_t* zone_count, int32_t* zones_disjoint,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const Measurement& data = checked(measurement, "measurement").data;
        store(zone_count, data.zone_names.size());
        store(zones_disjoint, !data.volume || data.volume->zones_disjoint ? 1 : 0);
    });
}

mien_status MIEN_CALL mien_measurement_get_volume(const mien_measurement* measurement, int32_t zone,
                                                  mien_zone_volume* out, mien_error* error) {
    return guarded(error, [&] {
        const Measurement& data = checked(measurement, "measurement").data;
        if (!data.volume) fail(Status::not_found, "this measurement holds no volume");
        const ZoneVolume* volume = &data.volume->whole;
        const SignedVolumeVerdict* verdict = &data.whole_verdict;
        if (zone == MIEN_ZONE_REST) {
            volume = &data.volume->rest;
            verdict = &data.rest_verdict;
        } else if (zone != MIEN_ZONE_WHOLE) {
            if (zone < 0 || static_cast<std::size_t>(zone) >= data.volume->zones.size())
                fail(Status::not_found, "zone %d, but %zu zones were measured", zone,
                     data.volume->zones.size());
            volume = &data.volume->zones[static_cast<std::size_t>(zone)];
            verdict = &data.zone_verdicts[static_cast<std::size_t>(zone)];
        }
        mien_zone_volume value{};
        value.detected = verdict->detected;
        value.signed_ml = volume->volume.signed_ml;
        value.positive_ml = volume->volume.positive_ml;
        value.negative_ml = volume->volume.negative_ml;
        value.absolute_ml = volume->volume.absolute_ml;
        value.sd_ml = verdict->uncertainty.sd_ml;
        value.low95_ml = verdict->low95_ml;
        value.high95_ml = verdict->high95_ml;
        value.area_before_mm2 = volume->area_before_mm2;
        value.area_after_mm2 = volume->area_after_mm2;
        write_struct(out, value, MIEN_FIRST_SIZE(mien_zone_volume, area_after_mm2));
    });
}

mien_status MIEN_CALL mien_measurement_get_distance(const mien_measurement* measurement,
                                                    int32_t zone, mien_zone_distance* out,
                                                    mien_error* error) {
    return guarded(error, [&] {
        const Measurement& data = checked(measurement, "measurement").data;
        if (!data.distance) fail(Status::not_found, "this measurement holds no distance");
        const DistanceSummary* summary = &data.distance->whole;
        if (zone != MIEN_ZONE_WHOLE) {
            if (zone < 0 || static_cast<std::size_t>(zone) >= data.distance->zones.size())
                fail(Status::not_found, "zone %d, but %zu zones were measured", zone,
                     data.distance->zones.size());
            summary = &data.distance->zones[static_cast<std::size_t>(zone)];
        }
        mien_zone_distance value{};
        value.mean_signed_mm = summary->mean_signed_mm;
        value.sd_signed_mm = summary->sd_signed_mm;
        value.mean_absolute_mm = summary->mean_absolute_mm;
        value.rms_mm = summary->rms_mm;
        value.mean_length_mm = summary->mean_length_mm;
        value.median_length_mm = summary->median_length_mm;
        value.p95_length_mm = summary->p95_length_mm;
        value.max_length_mm = summary->max_length_mm;
        value.vertex_count = static_cast<uint64_t>(summary->num_vertices);
        write_struct(out, value, MIEN_FIRST_SIZE(mien_zone_distance, vertex_count));
    });
}

mien_status MIEN_CALL mien_measurement_get_field(const mien_measurement* measurement, int32_t field,
                                                 double* dst, uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const Measurement& data = checked(measurement, "measurement").data;
        const Vector* values = nullptr;
        if (field == MIEN_FIELD_SIGNED_DISTANCE_MM && data.distance)
            values = &data.distance->signed_mm;
        if (field == MIEN_FIELD_DISTANCE_MM && data.distance) values = &data.distance->length_mm;
        if (field == MIEN_FIELD_POSITIVE_VOLUME_MM3 && data.shares.positive_mm3.size() > 0)
            values = &data.shares.positive_mm3;
        if (field == MIEN_FIELD_NEGATIVE_VOLUME_MM3 && data.shares.negative_mm3.size() > 0)
            values = &data.shares.negative_mm3;
        if (data.curvature) {
            const CurvatureField& bent = data.curvature->field;
            if (field == MIEN_FIELD_CURVATURE_MAXIMAL) values = &bent.maximal;
            if (field == MIEN_FIELD_CURVATURE_MINIMAL) values = &bent.minimal;
            if (field == MIEN_FIELD_CURVATURE_MEAN) values = &bent.mean;
            if (field == MIEN_FIELD_CURVATURE_GAUSSIAN) values = &bent.gaussian;
        }
        if (values == nullptr) fail(Status::not_found, "this measurement has no field %d", field);
        copy_rows(values->data(), static_cast<uint64_t>(values->size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_measurement_get_json(const mien_measurement* measurement, char* dst,
                                                uint64_t capacity, uint64_t* count,
                                                mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(measurement, "measurement").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_measurement_release(mien_measurement* measurement) {
    release(measurement);
}

}  // extern "C"
