#include "expression.hpp"

#include "arrays.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/report_json.hpp"
#include "expression/training.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

mien_train_options default_train_options() {
    const TrainOptions core;
    mien_train_options options{};
    options.method = MIEN_TRAIN_JPCA;
    options.identity_modes = static_cast<std::int32_t>(core.subspaces.identity_modes);
    options.expression_modes = static_cast<std::int32_t>(core.subspaces.expression_modes);
    options.max_iterations = core.subspaces.max_iterations;
    options.passes = core.span.passes;
    options.lambda_factor = core.subspaces.lambda_factor;
    options.angle_tolerance_rad = core.subspaces.angle_tolerance_rad;
    return options;
}

TrainOptions read_train_options(const mien_train_options& given) {
    TrainOptions options;
    if (given.method != MIEN_TRAIN_JPCA && given.method != MIEN_TRAIN_QOJPCA)
        fail(Status::invalid_argument, "options.method is %d; use MIEN_TRAIN_JPCA or MIEN_TRAIN_QOJPCA",
             given.method);
    if (!(given.noise_mm2 >= 0) || !(given.noise_mm2 < 1e12))
        fail(Status::invalid_argument, "options.noise_mm2 must be finite and not negative");
    options.subspaces.method = static_cast<TrainMethod>(given.method);
    options.subspaces.identity_modes = given.identity_modes;
    options.subspaces.expression_modes = given.expression_modes;
    options.subspaces.max_iterations = given.max_iterations;
    options.subspaces.lambda = given.lambda;
    options.subspaces.lambda_factor = given.lambda_factor;
    options.subspaces.angle_tolerance_rad = given.angle_tolerance_rad;
    options.span.passes = given.passes;
    options.map_noise_mm2 = options.mixture_noise_mm2 = given.noise_mm2;
    return options;
}

mien_neutralize_options default_neutralize_options() {
    const NeutralizeMeshOptions core;
    mien_neutralize_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.max_sweeps = core.neutralize.fit.max_sweeps;
    options.tolerance_mm = core.neutralize.fit.tolerance;
    options.decay_mm = core.decay_mm;
    return options;
}

NeutralizeMeshOptions read_neutralize_options(const mien_neutralize_options& given) {
    if (given.method < MIEN_FIT_MIXTURE || given.method > MIEN_FIT_ALTERNATING)
        fail(Status::invalid_argument, "options.method is %d; use one of MIEN_FIT_...", given.method);
    if (given.uncertainty != 0 && given.uncertainty != 1)
        fail(Status::invalid_argument, "options.uncertainty is %d, allowed are 0 and 1",
             given.uncertainty);
    NeutralizeMeshOptions options;
    options.neutralize.fit.method = static_cast<FitMethod>(given.method);
    options.neutralize.fit.max_sweeps = given.max_sweeps;
    options.neutralize.fit.tolerance = given.tolerance_mm;
    options.neutralize.fit.noise_mm2 = given.noise_mm2;
    options.neutralize.uncertainty = given.uncertainty != 0;
    options.decay_mm = given.decay_mm;
    return options;
}

Vector read_coordinates(const mien_array_view* view, const char* name) {
    return view == nullptr || view->count == 0 ? Vector() : read_values(*view, name);
}

mien_neutralization* finish(const ExpressionModel& model, const TriMesh& face,
                            NeutralizationResult&& result) {
    auto handle = std::make_unique<mien_neutralization>();
    auto mesh = std::make_shared<TriMesh>(face);
    mesh->vertices = std::move(result.neutral_vertices);
    handle->mesh = new mien_mesh(std::move(mesh));
    handle->json = neutralization_json(model, result);
    handle->result = std::move(result);
    return handle.release();
}

}  // namespace

extern "C" {

void MIEN_CALL mien_train_options_init(mien_train_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_train_options());
}

void MIEN_CALL mien_neutralize_options_init(mien_neutralize_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_neutralize_options());
}

mien_status MIEN_CALL mien_expression_model_train(mien_session* session, const char* dataset_path,
                                                  const mien_train_options* options,
                                                  mien_expression_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_train_options given = read_options(
            options, default_train_options(), MIEN_FIRST_SIZE(mien_train_options, cancel), "options");
        const TrainOptions settings = read_train_options(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        // Training looks at every face itself; hashing and checking first would read the file twice and
        // hold all of it in memory.
        const SafetensorsReadOptions unverified{false, false};
        auto dataset = std::make_shared<FaceDataset>(FaceDataset::open(
            checked_text(dataset_path, "dataset_path"), unverified, call.context()));
        TrainReport report;
        auto model = train_expression_model(std::move(dataset), settings, call.context(), &report);
        std::string json = training_json(*model, report);
        return new mien_expression_model(std::move(model), std::move(json));
    });
}

mien_status MIEN_CALL mien_expression_model_load(mien_session* session, const char* path,
                                                 mien_expression_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        auto model = load_expression_model(checked_text(path, "path"), {}, call.context());
        std::string json = model_json(*model);
        return new mien_expression_model(std::move(model), std::move(json));
    });
}

mien_status MIEN_CALL mien_expression_model_save(mien_session* session,
                                                 const mien_expression_model* model, const char* path,
                                                 mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_expression_model(checked_text(path, "path"), *checked(model, "model").model, call.context());
    });
}

void MIEN_CALL mien_expression_model_retain(mien_expression_model* model) { retain(model); }
void MIEN_CALL mien_expression_model_release(mien_expression_model* model) { release(model); }

mien_status MIEN_CALL mien_expression_model_get_counts(const mien_expression_model* model,
                                                       uint64_t* vertex_count, uint32_t* identity_modes,
                                                       uint32_t* expression_modes, mien_error* error) {
    return guarded(error, [&] {
        const ExpressionModel& data = *checked(model, "model").model;
        if (vertex_count != nullptr) *vertex_count = static_cast<uint64_t>(data.num_vertices());
        if (identity_modes != nullptr)
            *identity_modes = static_cast<uint32_t>(data.num_identity_modes());
        if (expression_modes != nullptr)
            *expression_modes = static_cast<uint32_t>(data.num_expression_modes());
    });
}

mien_status MIEN_CALL mien_expression_model_get_json(const mien_expression_model* model, char* dst,
                                                     uint64_t capacity, uint64_t* count,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(model, "model").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_expression_model_synthesize(mien_session* session,
                                                       const mien_expression_model* model,
                                                       const mien_array_view* identity,
                                                       const mien_array_view* expression,
                                                       mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const ExpressionModel& data = *checked(model, "model").model;
        const Vector who = read_coordinates(identity, "identity");
        const Vector what = read_coordinates(expression, "expression");
        if (!who.allFinite() || !what.allFinite())
            fail(Status::invalid_argument, "a coordinate is not finite");
        auto mesh = std::make_shared<TriMesh>();
        mesh->vertices = synthesize_face(call.context(), data, who, what);
        mesh->triangles = data.triangles;
        return new mien_mesh(std::move(mesh));
    });
}

mien_status MIEN_CALL mien_neutralize_mesh(mien_session* session, const mien_expression_model* model,
                                           const mien_mesh* face,
                                           const mien_neutralize_options* options,
                                           mien_neutralization** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_neutralize_options given =
            read_options(options, default_neutralize_options(),
                         MIEN_FIRST_SIZE(mien_neutralize_options, cancel), "options");
        const NeutralizeMeshOptions settings = read_neutralize_options(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const ExpressionModel& data = *checked(model, "model").model;
        const TriMesh& mesh = *checked(face, "face").mesh;
        const Vector weights =
            given.weights.count == 0 ? Vector() : read_values(given.weights, "options.weights");
        return finish(data, mesh, neutralize_mesh(call.context(), data, mesh, weights, settings));
    });
}

const mien_mesh* MIEN_CALL mien_neutralization_mesh(const mien_neutralization* neutralization) {
    return is_live(neutralization) ? neutralization->mesh : nullptr;
}

mien_status MIEN_CALL mien_neutralization_get_coordinates(const mien_neutralization* neutralization,
                                                          double* identity, double* expression,
                                                          mien_error* error) {
    return guarded(error, [&] {
        const NeutralizationResult& result = checked(neutralization, "neutralization").result;
        if (identity != nullptr)
            std::copy_n(result.identity.data(), result.identity.size(), identity);
        if (expression != nullptr)
            std::copy_n(result.expression.data(), result.expression.size(), expression);
    });
}

mien_status MIEN_CALL mien_neutralization_get_uncertainty(const mien_neutralization* neutralization,
                                                          double* dst, uint64_t capacity,
                                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const Vector& values = checked(neutralization, "neutralization").result.uncertainty_mm;
        if (values.size() == 0)
            fail(Status::not_found,
                 "no uncertainty was computed: set options.uncertainty and use a fit with a prior");
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst, capacity,
                  count);
    });
}

mien_status MIEN_CALL mien_neutralization_get_json(const mien_neutralization* neutralization, char* dst,
                                                   uint64_t capacity, uint64_t* count,
                                                   mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(neutralization, "neutralization").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_neutralization_release(mien_neutralization* neutralization) {
    release(neutralization);
}

}  // extern "C"
