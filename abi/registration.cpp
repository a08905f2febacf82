#include "registration.hpp"

#include <cmath>

#include "arrays.hpp"
#include "guard.hpp"
#include "model.hpp"
#include "model/landmark_names.hpp"
#include "options.hpp"
#include "registration/radius.hpp"
#include "registration/report.hpp"
#include "session.hpp"
#include "study/study_face.hpp"

using namespace mien;
using namespace mien::abi;

mien_registration::mien_registration(RegistrationResult&& result,
                                     const std::vector<Zone>& model_zones)
    : Object(kTag), data(std::move(result)), zones(model_zones), json(registration_json(data)) {
    // Places that a file's float coordinates hold exactly: what comes after the fit gives the same
    // bits whether it reads the fitted face from here or from the file that it was saved to.
    data.fitted.vertices = data.fitted.vertices.cast<float>().cast<double>();
    mesh = new mien_mesh(std::make_shared<const TriMesh>(std::move(data.fitted)));
}

mien_registration::mien_registration(FitRecord&& record)
    : Object(kTag),
      data(std::move(record.fit)),
      zones(std::move(record.zones)),
      json(registration_json(data)),
      mesh(new mien_mesh(std::make_shared<const TriMesh>(std::move(record.mesh)))) {}

mien_registration::~mien_registration() {
    release(mesh);
}

namespace {

/// Allocates nothing: it runs in a function that can report nothing. The core's defaults hold no
/// memory of their own (tests/oom/abi_defaults_oom.cpp).
mien_register_options default_register_options() {
    const RegistrationSettings core;
    const LoopSettings& loop = core.fit.loop;
    mien_register_options options{};
    options.growth = static_cast<std::int32_t>(loop.growth);
    options.landmark_sigma_mm = core.start.landmark_sigma_mm;
    options.close_gap = core.gap.enabled ? 1 : 0;
    options.max_scalar_modes = -1;
    options.max_pca_modes = -1;
    options.reject_border = loop.match.reject_border ? 1 : 0;
    options.sigma_start_mm = loop.sigma_start_mm;
    options.sigma_end_mm = loop.sigma_end_mm;
    options.max_angle_deg = loop.match.max_angle_deg;
    options.start_rotation[0] = options.start_rotation[4] = options.start_rotation[8] = 1;
    options.start_scale = 1;
    options.color_features = core.colors.enabled ? 1 : 0;
    options.landmark_sides = static_cast<std::int32_t>(core.start.sides.rule);
    return options;
}

void check_options(const mien_register_options& given) {
    check_choice(given.growth, MIEN_GROWTH_CONSTANT, MIEN_GROWTH_CUBIC, "options.growth");
    check_choice(given.start, MIEN_START_AUTOMATIC, MIEN_START_SEARCH, "options.start");
    check_choice(given.units, MIEN_UNITS_DETECT, MIEN_UNITS_REFUSE, "options.units");
    check_choice(given.landmark_sides, MIEN_SIDES_REFUSE, MIEN_SIDES_IGNORE,
                 "options.landmark_sides");
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    check_numbers({{"landmark_sigma_mm", given.landmark_sigma_mm},
                   {"sigma_start_mm", given.sigma_start_mm},
                   {"sigma_end_mm", given.sigma_end_mm},
                   {"max_angle_deg", given.max_angle_deg},
                   {"start_scale", given.start_scale},
                   {"unit_to_mm", given.unit_to_mm}});
    for (const auto& [name, value] :
         {std::pair{"max_distance_mm", given.max_distance_mm},
          std::pair{"mutual_mm", given.mutual_mm}, std::pair{"soft_mm", given.soft_mm}})
        if (!(value >= 0) || !std::isfinite(value))
            fail(Status::invalid_argument, "options.%s is %g, it must be positive, or 0", name,
                 value);
    if (given.reserved2 != 0) fail(Status::unsupported_option, "options.reserved2 is not zero");
    if (given.unit_to_mm < 0 || !std::isfinite(given.unit_to_mm))
        fail(Status::invalid_argument, "options.unit_to_mm is %g, it must be positive, or 0",
             given.unit_to_mm);
    for (const double number : given.start_rotation) check_numbers({{"start_rotation", number}});
    for (const double number : given.start_translation)
        check_numbers({{"start_translation", number}});
}

RegistrationSettings convert(const mien_register_options& given) {
    check_options(given);
    RegistrationSettings settings;
    settings.intake.units = static_cast<UnitRule>(given.units);
    settings.intake.skin_weights = read_switch(given.skin_weights, "options.skin_weights");
    settings.intake.unit_to_mm = given.unit_to_mm;
    settings.start.sides.rule = static_cast<SideRule>(given.landmark_sides);
    if (given.scan_weights.count != 0)
        settings.intake.weight_per_vertex = read_values(given.scan_weights, "options.scan_weights");
    settings.prior.max_scalar_modes = given.max_scalar_modes;
    settings.prior.max_pca_modes = given.max_pca_modes;
    settings.colors.enabled = read_switch(given.color_features, "options.color_features");
    settings.start.kind = static_cast<StartKind>(given.start);
    settings.start.landmark_sigma_mm = given.landmark_sigma_mm;
    Similarity& pose = settings.start.pose;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) pose.rotation(i, j) = given.start_rotation[3 * i + j];
        pose.translation[i] = given.start_translation[i];
    }
    pose.scale = given.start_scale;
    LoopSettings& loop = settings.fit.loop;
    loop.growth = static_cast<ModeGrowth>(given.growth);
    if (given.iterations != 0) loop.rounds = given.iterations;
    loop.sigma_start_mm = given.sigma_start_mm;
    loop.sigma_end_mm = given.sigma_end_mm;
    loop.match.reject_border = read_switch(given.reject_border, "options.reject_border");
    loop.match.max_angle_deg = given.max_angle_deg;
    if (given.max_distance_mm > 0) loop.match.limit_mm = given.max_distance_mm;
    if (given.mutual_mm > 0) loop.match.mutual_mm = given.mutual_mm;
    loop.match.soft_mm = given.soft_mm;
    settings.gap.enabled = read_switch(given.close_gap, "options.close_gap");
    return settings;
}

std::vector<LandmarkPoint> read_landmarks(const mien_register_options& given) {
    check_array(given.landmarks, given.landmark_count, alignof(mien_scan_landmark), 1000000,
                "options.landmarks");
    std::vector<LandmarkPoint> landmarks;
    for (std::uint64_t k = 0; k < given.landmark_count; ++k) {
        const mien_scan_landmark& landmark = given.landmarks[k];
        landmarks.push_back(
            {checked_text(landmark.name, "a landmark's name"),
             Vector3(landmark.position[0], landmark.position[1], landmark.position[2])});
    }
    return landmarks;
}

/// The landmarks under the model's own names. Those it does not know keep theirs and are reported.
std::vector<LandmarkPoint> as_model_names(std::vector<LandmarkPoint> landmarks,
                                          const DeformationModel& model) {
    std::vector<Mark> marks;
    marks.reserve(landmarks.size());
    for (const LandmarkPoint& landmark : landmarks)
        marks.push_back({landmark.name, Mark::Where::place, landmark.point, 0});
    const NameMatch match = match_landmark_names(model, marks);
    require_known_landmark(model, match, marks);
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        if (match.landmark[i] >= 0)
            landmarks[i].name = model.landmarks[static_cast<std::size_t>(match.landmark[i])].name;
    return landmarks;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_register_options_init(mien_register_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_register_options());
}

mien_status MIEN_CALL mien_register(mien_session* session, const mien_model* model,
                                    const mien_mesh* scan, const mien_register_options* options,
                                    mien_registration** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_register_options given =
            read_options(options, default_register_options(),
                         MIEN_FIRST_SIZE(mien_register_options, cancel), "options");
        const DeformationModel& face = *checked(model, "model").model;
        const TriMesh& data = *checked(scan, "scan").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        return new mien_registration(
            register_scan(face, data, as_model_names(read_landmarks(given), face), convert(given),
                          call.context()),
            face.zones);
    });
}

const mien_mesh* MIEN_CALL mien_registration_mesh(const mien_registration* registration) {
    return is_live(registration) ? registration->mesh : nullptr;
}

mien_status MIEN_CALL mien_registration_get_verdict(const mien_registration* registration,
                                                    mien_fit_verdict* out, mien_error* error) {
    return guarded(error, [&] {
        const Verdict& verdict = checked(registration, "registration").data.verdict;
        mien_fit_verdict value{};
        value.quality = static_cast<std::int32_t>(verdict.quality);
        value.coverage = verdict.coverage;
        value.inlier_share = verdict.inlier_share;
        value.mean_residual_mm = verdict.mean_residual_mm;
        value.landmark_rms_mm = verdict.landmark_rms_mm;
        value.size_ratio = verdict.size_ratio;
        value.mean_deviation = verdict.mean_deviation;
        value.unit_to_mm = verdict.unit_to_mm;
        value.landmarks_used = verdict.landmarks_used;
        value.landmarks_rejected = static_cast<std::int32_t>(verdict.landmarks_rejected.size());
        value.flipped_triangles = verdict.flipped_triangles;
        value.self_intersections = verdict.self_intersections;
        write_struct(out, value, MIEN_FIRST_SIZE(mien_fit_verdict, self_intersections));
    });
}

mien_status MIEN_CALL mien_registration_get_expected_error(const mien_registration* registration,
                                                           const char* zone,
                                                           mien_expected_error* out,
                                                           mien_error* error) {
    return guarded(error, [&] {
        const Verdict& verdict = checked(registration, "registration").data.verdict;
        const std::string name = zone != nullptr ? checked_text(zone, "zone") : "";
        for (std::size_t k = 0; k < verdict.expected.size(); ++k) {
            const ExpectedError& expected = verdict.expected[k];
            if (zone != nullptr ? expected.zone != name : k > 0) continue;
            mien_expected_error value{};
            value.quality = static_cast<std::int32_t>(expected.quality);
            value.expected_mm = expected.expected_mm;
            value.low_mm = expected.low_mm;
            value.high_mm = expected.high_mm;
            value.unseen = verdict.zones[k].unseen;
            write_struct(out, value, MIEN_FIRST_SIZE(mien_expected_error, unseen));
            return;
        }
        if (verdict.expected.empty())
            fail(Status::not_found, "no error was stated with this registration");
        fail(Status::not_found, "the model of this registration has no zone '%.60s'", name.c_str());
    });
}

mien_status MIEN_CALL mien_registration_get_field(const mien_registration* registration,
                                                  int32_t field, double* dst, uint64_t capacity,
                                                  uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const RegistrationResult& data = checked(registration, "registration").data;
        Vector scaled;
        const Vector* values = nullptr;
        switch (field) {
            case MIEN_REGISTRATION_RESIDUAL_MM:
                values = &data.residual_mm;
                break;
            case MIEN_REGISTRATION_WEIGHT:
                values = &data.weight;
                break;
            case MIEN_REGISTRATION_STANDARD_DEVIATION_MM:
                values = &data.confidence_mm;
                break;
            case MIEN_REGISTRATION_RADIUS95_MM:
                scaled = radius95_mm(data.confidence_mm, data.verdict,
                                     checked(registration, "registration").zones);
                values = &scaled;
                break;
            case MIEN_REGISTRATION_NORMAL_DEVIATION_MM:
                scaled = normal_deviation_mm(data.confidence_mm, data.weight, data.residual_mm,
                                             SurfaceErrorSettings().noise_mm);
                values = &scaled;
                break;
            default:
                fail(Status::not_found, "a registration has no field %d", field);
        }
        if (values->size() == 0)
            fail(Status::not_found, "field %d of this registration is not known", field);
        copy_rows(values->data(), static_cast<std::uint64_t>(values->size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_registration_get_correspondence(const mien_registration* registration,
                                                           uint32_t* triangles, double* barycentric,
                                                           uint64_t capacity, uint64_t* count,
                                                           mien_error* error) {
    return guarded(error, [&] {
        const std::vector<SurfaceHit>& hits =
            checked(registration, "registration").data.correspondence;
        store(count, hits.size());
        if (triangles == nullptr && barycentric == nullptr && capacity == 0) return;
        if (capacity < hits.size())
            fail(Status::buffer_too_small, "capacity is %llu, %zu rows are needed",
                 static_cast<unsigned long long>(capacity), hits.size());
        check_output(triangles, "triangles");
        check_output(barycentric, "barycentric");
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (triangles != nullptr) triangles[i] = hits[i].triangle;
            if (barycentric != nullptr)
                for (int k = 0; k < 3; ++k)
                    barycentric[3 * i + static_cast<std::size_t>(k)] = hits[i].barycentric[k];
        }
    });
}

mien_status MIEN_CALL mien_registration_get_motion(const mien_registration* registration,
                                                   double* matrix, mien_error* error) {
    return guarded(error, [&] {
        const Similarity& motion = checked(registration, "registration").data.motion;
        if (matrix == nullptr) fail(Status::invalid_argument, "matrix is null");
        check_output(matrix, "matrix");
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) matrix[4 * i + j] = motion.scale * motion.rotation(i, j);
            matrix[4 * i + 3] = motion.translation[i];
        }
        for (int j = 0; j < 4; ++j) matrix[12 + j] = j == 3 ? 1 : 0;
    });
}

mien_status MIEN_CALL mien_registration_get_json(const mien_registration* registration, char* dst,
                                                 uint64_t capacity, uint64_t* count,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(registration, "registration").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_registration_retain(mien_registration* registration) {
    retain(registration);
}
void MIEN_CALL mien_registration_release(mien_registration* registration) {
    release(registration);
}

}  // extern "C"
