// Studies: the visits of one person, from registrations to numbers with their errors.
#include "study/study.hpp"
#include <cmath>
#include "arrays.hpp"
#include "expression.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"
#include "study/study_json.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_study : Object {
    static constexpr Tag kTag = Tag::study;
    static constexpr const char* kName = "study";
    explicit mien_study(std::unique_ptr<const Study> made)
        : Object(kTag), data(std::move(made)), json(study_json(*data)) {}
    const std::unique_ptr<const Study> data;
    const std::string json;
};

namespace {

constexpr std::uint32_t kMostFaces = 200;

mien_study_options default_study_options() {
    const StudySettings core;
    mien_study_options options{};
    options.margin_mm = core.zones.margin_mm;
    options.measure_unseen = core.zones.unseen ? 1 : 0;
    options.level = core.reporting.level;
    options.noise_mm = core.surface.noise_mm;
    options.correlation_length_mm = core.surface.correlation_length_mm;
    options.common_bias_mm = core.surface.common_bias_mm;
    options.untrained_share = core.expression.untrained_share;
    options.min_seen_share = core.reporting.min_seen_share;
    return options;
}

mien_study_options read_study_options(const mien_study_options* given) {
    const mien_study_options options = read_options(
        given, default_study_options(), MIEN_FIRST_SIZE(mien_study_options, cancel), "options");
    if (options.reserved != 0 || options.reserved_end != 0)
        fail(Status::unsupported_option, "options.reserved or reserved_end is not zero");
    if (options.measure_unseen != 0 && options.measure_unseen != 1)
        fail(Status::invalid_argument, "options.measure_unseen is %d; give 0 or 1",
             options.measure_unseen);
    check_numbers({{"margin_mm", options.margin_mm},
                   {"level", options.level},
                   {"noise_mm", options.noise_mm},
                   {"correlation_length_mm", options.correlation_length_mm},
                   {"common_bias_mm", options.common_bias_mm},
                   {"untrained_share", options.untrained_share},
                   {"min_seen_share", options.min_seen_share}});
    return options;
}

std::vector<std::string> read_names(const char* const* names, std::uint64_t count,
                                    const char* what) {
    check_array(names, count, alignof(const char*), kMostNames, what);
    std::vector<std::string> list;
    for (std::uint64_t k = 0; k < count; ++k) list.emplace_back(checked_text(names[k], what));
    return list;
}

StudySettings settings_of(const mien_study_options& given, Index num_vertices,
                          const std::vector<Zone>& model_zones) {
    StudySettings settings;
    settings.zones.zones =
        given.zones == nullptr && given.zone_count == 0
            ? model_zones
            : read_zones(given.zones, given.zone_count, num_vertices, "options.zones");
    settings.zones.treated =
        read_names(given.treated_zones, given.treated_count, "options.treated_zones");
    settings.zones.stable =
        read_names(given.stable_zones, given.stable_count, "options.stable_zones");
    settings.zones.margin_mm = given.margin_mm;
    settings.zones.unseen = given.measure_unseen != 0;
    settings.reporting.level = given.level;
    settings.reporting.min_seen_share = given.min_seen_share;
    settings.surface.noise_mm = given.noise_mm;
    settings.surface.correlation_length_mm = given.correlation_length_mm;
    settings.surface.common_bias_mm = given.common_bias_mm;
    settings.expression.untrained_share = given.untrained_share;
    return settings;
}

void number_visits(std::vector<StudyFace>& faces, const mien_study_options& given) {
    if (given.visits == nullptr && given.visit_number_count == 0) {
        for (std::size_t k = 0; k < faces.size(); ++k) faces[k].visit = static_cast<int>(k);
        return;
    }
    if (given.visit_number_count != faces.size())
        fail(Status::invalid_argument, "options.visits numbers %llu faces, %zu were given",
             static_cast<unsigned long long>(given.visit_number_count), faces.size());
    check_array(given.visits, given.visit_number_count, alignof(std::int32_t), kMostFaces,
                "options.visits");
    for (std::size_t k = 0; k < faces.size(); ++k) faces[k].visit = given.visits[k];
}

template <typename Handle>
void check_faces(const Handle* const* faces, std::uint32_t count, const char* name) {
    if (count == 0) fail(Status::invalid_argument, "no face is given in %s", name);
    check_array(faces, count, alignof(const Handle*), kMostFaces, name);
}

mien_study* make_study(const Call& call, const mien_expression_model* expressions,
                       const mien_study_options& given, std::vector<StudyFace> faces,
                       const std::vector<Zone>& model_zones) {
    std::shared_ptr<const ExpressionModel> model;
    if (expressions != nullptr) model = checked(expressions, "expressions").model;
    number_visits(faces, given);
    StudySettings settings = settings_of(given, faces.front().mesh->vertices.rows(), model_zones);
    return new mien_study(std::make_unique<const Study>(call.context(), std::move(model),
                                                        std::move(faces), std::move(settings)));
}

/// One value per vertex of each face, face by face; null: none.
Vector read_all(const mien_array_view* view, std::size_t num_faces, Index num_vertices,
                const char* name) {
    if (view == nullptr) return {};
    const mien_array_view& given = checked_view(view, name);
    if (given.count != num_faces * static_cast<std::uint64_t>(num_vertices))
        fail(Status::mismatch,
             "%s holds %llu numbers, not one per vertex of %zu faces of %lld vertices", name,
             static_cast<unsigned long long>(given.count), num_faces,
             static_cast<long long>(num_vertices));
    return read_values(given, name);
}

const Study& study_of(const mien_study* study) {
    return *checked(study, "study").data;
}

std::size_t visit_of(const Study& study, std::int32_t visit) {
    if (visit < 0 || static_cast<std::size_t>(visit) >= study.num_visits())
        fail(Status::not_found, "visit %d, but the study has %zu", visit, study.num_visits());
    return static_cast<std::size_t>(visit);
}

std::size_t zone_of(const Study& study, std::int32_t zone) {
    if (zone < 0 || static_cast<std::size_t>(zone) >= study.zones().size())
        fail(Status::not_found, "zone %d, but the study has %zu", zone, study.zones().size());
    return static_cast<std::size_t>(zone);
}

const PairChange& pair_of(const Study& study, std::int32_t first, std::int32_t second) {
    const std::size_t a = visit_of(study, first), b = visit_of(study, second);
    return study.change(a, b);
}

mien_study_value value_of(const StudyValue& v) {
    return {v.value, v.sd, v.low, v.high, v.limit_of_detection};
}

mien_study_change change_of(const ZoneChange& change) {
    mien_study_change value{};
    value.unknown = static_cast<std::int32_t>(change.reason);
    value.signed_ml = value_of(change.signed_ml);
    value.gained_ml = value_of(change.gained_ml);
    value.lost_ml = value_of(change.lost_ml);
    value.absolute_ml = value_of(change.absolute_ml);
    value.area_change_mm2 = value_of(change.area_mm2);
    value.mean_distance_mm = value_of(change.mean_distance_mm);
    value.surface_sd_ml = change.surface_sd_ml;
    value.alignment_sd_ml = change.alignment_sd_ml;
    value.bias_sd_ml = change.bias_sd_ml;
    value.expression_sd_ml = change.expression_sd_ml;
    value.expression_removed_ml = change.expression_removed_ml;
    value.seen_share = change.seen_share;
    value.area_before_mm2 = change.area_before_mm2;
    value.area_after_mm2 = change.area_after_mm2;
    value.detected = change.detected;
    return value;
}

mien_zone_alignment alignment_of(const RigidZoneResult& result) {
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
    return value;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_study_options_init(mien_study_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_study_options());
}

mien_status MIEN_CALL mien_study_create(mien_session* session,
                                        const mien_registration* const* registrations,
                                        uint32_t registration_count,
                                        const mien_expression_model* expressions,
                                        const mien_study_options* options, mien_study** out,
                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_study_options given = read_study_options(options);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_faces(registrations, registration_count, "registrations");
        std::vector<StudyFace> faces;
        for (uint32_t k = 0; k < registration_count; ++k) {
            const mien_registration& fit = checked(registrations[k], "a registration");
            faces.push_back(study_face_of(fit.mesh->mesh, fit.data, given.noise_mm));
        }
        return make_study(call, expressions, given, std::move(faces), registrations[0]->zones);
    });
}

mien_status MIEN_CALL mien_study_create_from_meshes(
    mien_session* session, const mien_mesh* const* faces, uint32_t face_count,
    const mien_array_view* normal_sd, const mien_array_view* weights,
    const mien_expression_model* expressions, const mien_study_options* options, mien_study** out,
    mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_study_options given = read_study_options(options);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        check_faces(faces, face_count, "faces");
        std::vector<StudyFace> list(face_count);
        for (uint32_t k = 0; k < face_count; ++k) list[k].mesh = checked(faces[k], "a face").mesh;
        const Index n = list.front().mesh->vertices.rows();
        const Vector deviations = read_all(normal_sd, face_count, n, "normal_sd"),
                     seen = read_all(weights, face_count, n, "weights");
        for (uint32_t k = 0; k < face_count; ++k) {
            const Index at = static_cast<Index>(k) * n;
            if (deviations.size() != 0) list[k].normal_sd_mm = deviations.segment(at, n);
            if (seen.size() != 0) list[k].weights = seen.segment(at, n);
        }
        return make_study(call, expressions, given, std::move(list), {});
    });
}

mien_status MIEN_CALL mien_study_get_counts(const mien_study* study, uint32_t* visit_count,
                                            uint32_t* zone_count, mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        store(visit_count, data.num_visits());
        store(zone_count, data.zones().size());
    });
}

mien_status MIEN_CALL mien_study_get_zone_name(const mien_study* study, int32_t zone, char* dst,
                                               uint64_t capacity, uint64_t* count,
                                               mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        const std::string& name = data.zones()[zone_of(data, zone)].name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_study_get_expression(const mien_study* study, int32_t visit, char* dst,
                                                uint64_t capacity, uint64_t* count,
                                                mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        const std::string& name =
            data.data().neutral.expressions[data.face_of(visit_of(data, visit))];
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_study_get_mesh(const mien_study* study, int32_t visit, int32_t frame,
                                          mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Study& data = study_of(study);
        const std::size_t of = visit_of(data, visit), in = visit_of(data, frame);
        return new mien_mesh(std::make_shared<const TriMesh>(data.neutral(of, in)));
    });
}

mien_status MIEN_CALL mien_study_get_field(const mien_study* study, int32_t visit, int32_t field,
                                           double* dst, uint64_t capacity, uint64_t* count,
                                           mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        const std::size_t face = data.face_of(visit_of(data, visit));
        const Vector* values = nullptr;
        if (field == MIEN_STUDY_FIELD_NORMAL_SD_MM) values = &data.data().faces[face].normal_sd_mm;
        if (field == MIEN_STUDY_FIELD_WEIGHT) values = &data.data().faces[face].weights;
        if (field == MIEN_STUDY_FIELD_EXPRESSION_SD_MM)
            values = &data.data().neutral.expression_sd_mm[face];
        if (values == nullptr) fail(Status::not_found, "a study has no field %d", field);
        if (values->size() == 0)
            fail(Status::not_found, "nothing is known of field %d at visit %d", field, visit);
        copy_rows(values->data(), static_cast<uint64_t>(values->size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_study_get_distances(const mien_study* study, int32_t first,
                                               int32_t second, double* dst, uint64_t capacity,
                                               uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        pair_of(data, first, second);
        const Vector values =
            data.distances_mm(static_cast<std::size_t>(first), static_cast<std::size_t>(second));
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_study_get_alignment(const mien_study* study, int32_t first,
                                               int32_t second, mien_zone_alignment* out,
                                               mien_error* error) {
    return guarded(error, [&] {
        const PairChange& pair = pair_of(study_of(study), first, second);
        write_struct(out, alignment_of(pair.alignment),
                     MIEN_FIRST_SIZE(mien_zone_alignment, matrix));
    });
}

mien_status MIEN_CALL mien_study_get_change(const mien_study* study, int32_t first, int32_t second,
                                            int32_t zone, mien_study_change* out,
                                            mien_error* error) {
    return guarded(error, [&] {
        const Study& data = study_of(study);
        const std::size_t of = zone_of(data, zone);
        write_struct(out, change_of(pair_of(data, first, second).zones[of]),
                     MIEN_FIRST_SIZE(mien_study_change, reserved));
    });
}

mien_status MIEN_CALL mien_study_get_json(const mien_study* study, char* dst, uint64_t capacity,
                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(study, "study").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_study_retain(mien_study* study) {
    retain(study);
}
void MIEN_CALL mien_study_release(mien_study* study) {
    release(study);
}

}  // extern "C"
