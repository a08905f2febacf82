#include "arrays.hpp"
#include "guard.hpp"
#include "landmarks.hpp"
#include "measure/norms.hpp"
#include "mesh.hpp"
#include "model/profile_landmarks.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_norms : Object {
    static constexpr Tag kTag = Tag::norms;
    static constexpr const char* kName = "set of norms";
    explicit mien_norms(NormSet&& set)
        : Object(kTag), norms(std::move(set)), json(norms_json(norms)) {}
    const NormSet norms;
    const std::string json;
};

struct mien_anthropometry : Object {
    static constexpr Tag kTag = Tag::anthropometry;
    static constexpr const char* kName = "list of measurements";
    mien_anthropometry(std::vector<AnthropometricValue>&& list,
                       const std::vector<FacePlace>& places, const NormSet* norms)
        : Object(kTag), values(std::move(list)), json(anthropometry_json(values, places, norms)) {
        for (const AnthropometricValue& value : values)
            scores.push_back(score_against(norms, value));
    }
    std::size_t at(std::uint64_t index) const {
        if (index >= values.size())
            fail(Status::not_found, "index is %llu, there are %zu measurements",
                 static_cast<unsigned long long>(index), values.size());
        return static_cast<std::size_t>(index);
    }
    const std::vector<AnthropometricValue> values;
    std::vector<NormScore> scores;
    const std::string json;
};

namespace {

mien_anthropometry_options default_anthropometry_options() {
    mien_anthropometry_options options{};
    options.slide_correlation_mm = AnthropometryErrors().slide_correlation_mm;
    options.normal_correlation_mm = AnthropometryErrors().normal_correlation_mm;
    return options;
}

mien_anthropometry_options read_anthropometry_options(const mien_anthropometry_options* given) {
    const mien_anthropometry_options options =
        read_options(given, default_anthropometry_options(),
                     MIEN_FIRST_SIZE(mien_anthropometry_options, cancel), "options");
    if (options.reserved != 0)
        fail(Status::unsupported_option, "options.reserved is %u, allowed is 0", options.reserved);
    check_numbers({{"slide_correlation_mm", options.slide_correlation_mm},
                   {"normal_correlation_mm", options.normal_correlation_mm}});
    if (options.place_sd.count != 0) check_view(options.place_sd, 1, "options.place_sd");
    if (options.normal_sd.count != 0) check_view(options.normal_sd, 1, "options.normal_sd");
    return options;
}

/// What was picked.
std::vector<FacePlace> places_of(const mien_landmarks* landmarks) {
    std::vector<FacePlace> places;
    for (const Mark& mark : checked(landmarks, "landmarks").file.marks) {
        if (mark.where == Mark::Where::vertex)
            places.push_back({mark.name, static_cast<std::int64_t>(mark.vertex), {}});
        else if (mark.where == Mark::Where::place)
            places.push_back({mark.name, -1, mark.point});
    }
    return places;
}

}  // namespace

extern "C" {

void MIEN_CALL mien_anthropometry_options_init(mien_anthropometry_options* options,
                                               size_t struct_size) {
    write_defaults(options, struct_size, default_anthropometry_options());
}

mien_status MIEN_CALL mien_landmarks_add_profile(const mien_landmarks* landmarks,
                                                 const mien_mesh* template_mesh,
                                                 mien_landmarks** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        LandmarkFile list = checked(landmarks, "landmarks").file;
        const TriMesh& mesh = *checked(template_mesh, "template_mesh").mesh;
        std::vector<Landmark> known;
        for (const Mark& mark : list.marks)
            if (mark.where == Mark::Where::vertex) known.push_back({mark.name, mark.vertex});
        for (const Landmark& one : profile_landmarks(mesh, known)) {
            Mark mark;
            mark.name = one.name;
            mark.where = Mark::Where::vertex;
            mark.vertex = one.vertex;
            list.marks.push_back(std::move(mark));
        }
        return new mien_landmarks(std::move(list));
    });
}

mien_status MIEN_CALL mien_measure_anthropometry(mien_session* session, const mien_mesh* face,
                                                 const mien_landmarks* landmarks,
                                                 const mien_anthropometry_options* options,
                                                 mien_anthropometry** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_anthropometry_options given = read_anthropometry_options(options);
        const TriMesh& mesh = *checked(face, "face").mesh;
        const std::vector<FacePlace> places = places_of(landmarks);
        const NormSet* norms =
            given.norms != nullptr ? &checked(given.norms, "options.norms").norms : nullptr;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        AnthropometryErrors errors;
        if (given.place_sd.count != 0)
            errors.place_sd_mm = read_values(given.place_sd, "options.place_sd");
        if (given.normal_sd.count != 0)
            errors.normal_sd_mm = read_values(given.normal_sd, "options.normal_sd");
        errors.slide_correlation_mm = given.slide_correlation_mm;
        errors.normal_correlation_mm = given.normal_correlation_mm;
        return new mien_anthropometry(measure_anthropometry(mesh, places, errors, call.context()),
                                      places, norms);
    });
}

mien_status MIEN_CALL mien_anthropometry_get_counts(const mien_anthropometry* anthropometry,
                                                    uint64_t* count, uint64_t* known_count,
                                                    mien_error* error) {
    return guarded(error, [&] {
        const auto& values = checked(anthropometry, "anthropometry").values;
        std::uint64_t known = 0;
        for (const AnthropometricValue& value : values) known += value.reason.empty() ? 1 : 0;
        store(count, values.size());
        store(known_count, known);
    });
}

mien_status MIEN_CALL mien_anthropometry_get_name(const mien_anthropometry* anthropometry,
                                                  uint64_t index, char* dst, uint64_t capacity,
                                                  uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const mien_anthropometry& list = checked(anthropometry, "anthropometry");
        const std::string name = list.values[list.at(index)].definition->name;
        copy_text(name.data(), name.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_anthropometry_get_value(const mien_anthropometry* anthropometry,
                                                   uint64_t index, mien_anthropometric_value* out,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const mien_anthropometry& list = checked(anthropometry, "anthropometry");
        const AnthropometricValue& one = list.values[list.at(index)];
        const NormScore& score = list.scores[list.at(index)];
        mien_anthropometric_value value{};
        value.kind = static_cast<int32_t>(one.definition->kind);
        value.value = one.value;
        value.sd = one.sd;
        value.z = score.z;
        value.z_sd = score.sd;
        value.norm_mean = score.mean;
        value.norm_sd = score.population_sd;
        value.norm_people = static_cast<uint64_t>(score.people);
        write_struct(out, value, MIEN_FIRST_SIZE(mien_anthropometric_value, norm_people));
    });
}

mien_status MIEN_CALL mien_anthropometry_get_reason(const mien_anthropometry* anthropometry,
                                                    uint64_t index, char* dst, uint64_t capacity,
                                                    uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const mien_anthropometry& list = checked(anthropometry, "anthropometry");
        const std::string& reason = list.values[list.at(index)].reason;
        copy_text(reason.data(), reason.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_anthropometry_get_json(const mien_anthropometry* anthropometry,
                                                  char* dst, uint64_t capacity, uint64_t* count,
                                                  mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(anthropometry, "anthropometry").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_anthropometry_release(mien_anthropometry* anthropometry) {
    release(anthropometry);
}

mien_status MIEN_CALL mien_norms_create(mien_session* session, const char* dataset_path,
                                        const mien_landmarks* landmarks,
                                        const mien_anthropometry_options* options, mien_norms** out,
                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_anthropometry_options given = read_anthropometry_options(options);
        const std::string path = checked_text(dataset_path, "dataset_path");
        const std::vector<FacePlace> places = places_of(landmarks);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const FaceDataset dataset = FaceDataset::open(path, {}, call.context());
        return new mien_norms(norms_of_dataset(dataset, places, call.context()));
    });
}

mien_status MIEN_CALL mien_norms_load(mien_session* session, const char* path, mien_norms** out,
                                      mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_norms(read_norms(checked_text(path, "path"), call.context()));
    });
}

mien_status MIEN_CALL mien_norms_save(mien_session* session, const mien_norms* norms,
                                      const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        const NormSet& set = checked(norms, "norms").norms;
        write_norms(checked_text(path, "path"), set);
    });
}

mien_status MIEN_CALL mien_norms_get_json(const mien_norms* norms, char* dst, uint64_t capacity,
                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(norms, "norms").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_norms_release(mien_norms* norms) {
    release(norms);
}

}  // extern "C"
