#include "arrays.hpp"
#include "guard.hpp"
#include "measure/statistics_json.hpp"
#include "mesh.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

struct mien_score_model : Object {
    static constexpr Tag kTag = Tag::score_model;
    static constexpr const char* kName = "score model";
    explicit mien_score_model(ScoreModel&& trained)
        : Object(kTag),
          data(std::make_shared<const ScoreModel>(std::move(trained))),
          json(score_model_json(*data)) {}
    const std::shared_ptr<const ScoreModel> data;
    const std::string json;
};

namespace {

mien_score_options default_score_options() {
    const ScoreOptions core;
    mien_score_options options{};
    options.method = MIEN_PLS_NIPALS;
    options.num_components = core.num_components;
    options.max_components = core.max_components;
    options.folds = core.folds;
    options.seed = core.seed;
    options.focus = core.focus ? 1 : 0;
    options.curvature_share = core.curvature_share;
    options.curvature_radius_mm = core.curvature_radius_mm;
    return options;
}

ScoreOptions read_score_options(const mien_score_options& given, Index num_vertices) {
    if (given.reserved != 0 || given.reserved2 != 0 || given.reserved3 != 0)
        fail(Status::unsupported_option, "options.reserved is not zero");
    check_choice(given.method, MIEN_PLS_NIPALS, MIEN_PLS_SIMPLS, "options.method");
    check_numbers({{"curvature_share", given.curvature_share},
                   {"curvature_radius_mm", given.curvature_radius_mm},
                   {"lowest", given.lowest},
                   {"highest", given.highest}});
    ScoreOptions options;
    options.method = given.method == MIEN_PLS_SIMPLS ? PlsMethod::simpls : PlsMethod::nipals;
    check_choice(given.features, MIEN_SCORE_FEATURES_DISPLACEMENT_AND_CURVATURE,
                 MIEN_SCORE_FEATURES_ALL, "options.features");
    options.features = static_cast<ScoreFeatures>(given.features);
    options.num_components = given.num_components;
    options.max_components = given.max_components;
    options.folds = given.folds;
    options.seed = given.seed;
    options.focus = read_switch(static_cast<std::int32_t>(given.focus), "options.focus");
    options.curvature_share = given.curvature_share;
    options.curvature_radius_mm = given.curvature_radius_mm;
    options.lowest = given.lowest;
    options.highest = given.highest;
    options.zone =
        read_vertices(given.zone_vertices, given.zone_count, num_vertices, "options.zone_vertices");
    options.stable_zone = read_vertices(given.stable_vertices, given.stable_count, num_vertices,
                                        "options.stable_vertices");
    return options;
}

constexpr std::uint64_t kMostValues = 100000000;

std::vector<double> read_list(const double* values, uint64_t count, const char* name) {
    return read_array(values, count, kMostValues, name);
}

}  // namespace

extern "C" {

void MIEN_CALL mien_score_options_init(mien_score_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_score_options());
}

mien_status MIEN_CALL mien_score_model_train(mien_session* session, const char* dataset_path,
                                             const double* grades, uint64_t grade_count,
                                             const mien_score_options* options,
                                             mien_score_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_score_options given =
            read_options(options, default_score_options(),
                         MIEN_FIRST_SIZE(mien_score_options, cancel), "options");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const FaceDataset faces =
            FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, call.context());
        const ScoreOptions settings = read_score_options(given, faces.num_vertices());
        if (grade_count != static_cast<std::uint64_t>(faces.num_faces()))
            fail(Status::mismatch, "grade_count is %llu, the dataset has %lld faces",
                 static_cast<unsigned long long>(grade_count),
                 static_cast<long long>(faces.num_faces()));
        const std::vector<double> list = read_array(grades, grade_count, grade_count, "grades");
        const Vector values =
            Eigen::Map<const Vector>(list.data(), static_cast<Index>(list.size()));
        return new mien_score_model(train_score(faces, values, settings, call.context()));
    });
}

mien_status MIEN_CALL mien_score_model_load(mien_session* session, const char* path,
                                            mien_score_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        return new mien_score_model(
            load_score_model(checked_text(path, "path"), {}, call.context()));
    });
}

mien_status MIEN_CALL mien_score_model_save(mien_session* session, const mien_score_model* model,
                                            const char* path, mien_error* error) {
    return guarded(error, [&] {
        const ScoreModel& data = *checked(model, "model").data;
        const Call call(session);
        save_score_model(checked_text(path, "path"), data, call.context());
    });
}

mien_status MIEN_CALL mien_score_model_predict(mien_session* session, const mien_score_model* model,
                                               const mien_mesh* face, mien_score_prediction* out,
                                               mien_error* error) {
    return guarded(error, [&] {
        const ScoreModel& data = *checked(model, "model").data;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Call call(session);
        const ScorePrediction prediction = predict_score(data, mesh.vertices, call.context());
        mien_score_prediction value{};
        value.extrapolates = prediction.extrapolates ? 1 : 0;
        value.score = prediction.score;
        value.low95 = prediction.low95;
        value.high95 = prediction.high95;
        value.leverage = prediction.leverage;
        write_struct(out, value, MIEN_FIRST_SIZE(mien_score_prediction, leverage));
    });
}

mien_status MIEN_CALL mien_score_model_simulate(mien_session* session,
                                                const mien_score_model* model,
                                                const mien_mesh* face, double target,
                                                mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const ScoreModel& data = *checked(model, "model").data;
        const Call call(session);
        TriMesh result;
        if (face != nullptr) {
            result = *checked(face, "face").mesh;
        } else {
            result.vertices = data.mean_face;
            result.triangles = data.triangles;
        }
        result.vertices = simulate_score(data, result.vertices, target, call.context());
        return new mien_mesh(std::make_shared<const TriMesh>(std::move(result)));
    });
}

mien_status MIEN_CALL mien_score_model_get_latent(const mien_score_model* model, int32_t component,
                                                  double* dst, uint64_t capacity, uint64_t* count,
                                                  mien_error* error) {
    return guarded(error, [&] {
        const ScoreModel& data = *checked(model, "model").data;
        if (component < -1 || component >= data.num_components())
            fail(Status::not_found, "component %d, but the model has %lld", component,
                 static_cast<long long>(data.num_components()));
        const Vector values = component == -1 ? Vector(data.unit_displacement.rowwise().norm())
                                              : Vector(data.latent_pictures.col(component));
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_score_model_get_json(const mien_score_model* model, char* dst,
                                                uint64_t capacity, uint64_t* count,
                                                mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(model, "model").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_score_model_retain(mien_score_model* model) {
    retain(model);
}

void MIEN_CALL mien_score_model_release(mien_score_model* model) {
    release(model);
}

mien_status MIEN_CALL mien_statistics_agreement(mien_session* session, const int32_t* ratings,
                                                uint64_t subject_count, uint32_t rater_count,
                                                int32_t grade_count, char* dst, uint64_t capacity,
                                                uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        if (ratings == nullptr) fail(Status::invalid_argument, "ratings is null");
        if (reinterpret_cast<std::uintptr_t>(ratings) % alignof(std::int32_t) != 0)
            fail(Status::invalid_argument, "ratings is not aligned to its 4-byte values");
        if (subject_count < 2 || subject_count > 10000000 || rater_count < 2 ||
            rater_count > 1000 || grade_count < 2 || grade_count > 1000)
            fail(Status::invalid_argument,
                 "%llu subjects (2 to 1e7), %u raters (2 to 1000), %d grades (2 to 1000)",
                 static_cast<unsigned long long>(subject_count), rater_count, grade_count);
        using RowMajor =
            Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Ratings table = Eigen::Map<const RowMajor>(ratings, static_cast<Index>(subject_count),
                                                         static_cast<Index>(rater_count));
        const std::string json = agreement_json(table, grade_count);
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_statistics_repeatability(mien_session* session, const double* values,
                                                    const int32_t* subjects, uint64_t value_count,
                                                    const double* blanks, uint64_t blank_count,
                                                    char* dst, uint64_t capacity, uint64_t* count,
                                                    mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        const std::vector<double> list = read_list(values, value_count, "values");
        const std::vector<int> who = read_array(subjects, value_count, kMostValues, "subjects");
        const std::string json =
            repeatability_json(list, who, read_list(blanks, blank_count, "blanks"));
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_statistics_bland_altman(mien_session* session, const double* first,
                                                   const double* second, uint64_t value_count,
                                                   char* dst, uint64_t capacity, uint64_t* count,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        const std::string json = bland_altman_json(read_list(first, value_count, "first"),
                                                   read_list(second, value_count, "second"));
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

}  // extern "C"
