#include "registration.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "model.hpp"
#include "options.hpp"
#include "register_options.hpp"
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
      tie(std::move(record.tie)),
      json(tie != nullptr ? registration_json(data, tie_json(*tie, zones))
                          : registration_json(data)),
      mesh(new mien_mesh(std::make_shared<const TriMesh>(std::move(record.mesh)))) {}

mien_registration::mien_registration(TiedVisit&& tied, const mien_registration& kept)
    : Object(kTag),
      data(std::move(tied.fit)),
      zones(kept.zones),
      tie(std::make_shared<const TextureTie>(std::move(tied.tie))),
      json(registration_json(data, tie_json(*tie, zones))) {
    if (tie->tied) data.fitted.vertices = data.fitted.vertices.cast<float>().cast<double>();
    TriMesh face = std::move(data.fitted);
    face.colors = kept.mesh->mesh->colors;
    face.take_appearance_of(*kept.mesh->mesh);
    mesh = new mien_mesh(std::make_shared<const TriMesh>(std::move(face)));
}

mien_registration::~mien_registration() {
    release(mesh);
}

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
        return new mien_registration(register_scan(face, data, read_landmarks(given, face),
                                                   register_settings(given), call.context()),
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
        const TextureTie* tie = checked(registration, "registration").tie.get();
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
            case MIEN_REGISTRATION_SLIDE_MM:
                values = tie != nullptr ? &tie->slide_mm : &scaled;
                break;
            case MIEN_REGISTRATION_TIE_AGREEMENT:
                values = tie != nullptr ? &tie->agreement : &scaled;
                break;
            case MIEN_REGISTRATION_TIE_SHARE:
                values = tie != nullptr ? &tie->share : &scaled;
                break;
            case MIEN_REGISTRATION_TIE_DEVIATION_MM:
                values = tie != nullptr ? &tie->sd_mm : &scaled;
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
