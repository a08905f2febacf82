#include "expression.hpp"

#include "arrays.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/report_json.hpp"
#include "expression/sampling.hpp"
#include "expression/scan_transfer.hpp"
#include "expression/training.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "memory_file.hpp"
#include "options.hpp"
#include "registration.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

namespace {

/// Allocates nothing: it runs in a function that can report nothing.
mien_train_options default_train_options() {
    const JointPcaOptions subspaces;
    const JointSpanOptions span;
    mien_train_options options{};
    options.method = MIEN_TRAIN_JPCA;
    options.identity_modes = static_cast<std::int32_t>(subspaces.identity_modes);
    options.expression_modes = static_cast<std::int32_t>(subspaces.expression_modes);
    options.max_iterations = subspaces.max_iterations;
    options.passes = span.passes;
    options.lambda_factor = subspaces.lambda_factor;
    options.angle_tolerance_rad = subspaces.angle_tolerance_rad;
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
    check_fit(given.method, "options.method");
    check_pose(given.pose);
    check_numbers({{"tolerance_mm", given.tolerance_mm},
                   {"noise_mm2", given.noise_mm2},
                   {"decay_mm", given.decay_mm}});
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    NeutralizeMeshOptions options;
    options.neutralize.fit.method = static_cast<FitMethod>(given.method);
    options.neutralize.fit.max_sweeps = given.max_sweeps;
    options.neutralize.fit.tolerance = given.tolerance_mm;
    options.neutralize.fit.noise_mm2 = given.noise_mm2;
    options.neutralize.pose = static_cast<Pose>(given.pose);
    options.neutralize.uncertainty = read_switch(given.uncertainty, "options.uncertainty");
    options.decay_mm = given.decay_mm;
    return options;
}

Vector read_coordinates(const mien_array_view* view, const char* name) {
    check_output(view, name);
    return view == nullptr || checked_view(view, name).count == 0 ? Vector()
                                                                  : read_values(*view, name);
}

mien_neutralization* neutralize_face(mien_session* session, const ExpressionModel& model,
                                     std::shared_ptr<const TriMesh> face, const Vector* weights,
                                     const mien_neutralize_options* options) {
    const mien_neutralize_options given =
        read_options(options, default_neutralize_options(),
                     MIEN_FIRST_SIZE(mien_neutralize_options, cancel), "options");
    const NeutralizeMeshOptions settings = read_neutralize_options(given);
    const Call call(session, given.progress, given.progress_user, given.cancel);
    Vector own;
    if (given.weights.count != 0)
        own = read_values(given.weights, "options.weights");
    else if (weights != nullptr)
        own = *weights;
    NeutralizationResult result = neutralize_mesh(call.context(), model, *face, own, settings);

    auto handle = std::make_unique<mien_neutralization>();
    auto mesh = std::make_shared<TriMesh>(*face);
    mesh->vertices = std::move(result.neutral_vertices);
    handle->face = std::move(face);
    handle->mesh = new mien_mesh(std::move(mesh));
    handle->json = neutralization_json(model, result);
    handle->result = std::move(result);
    return handle.release();
}

mien_evaluate_options default_evaluate_options() {
    mien_evaluate_options options{};
    options.method = MIEN_FIT_MIXTURE;
    options.max_sweeps = 200;
    options.against_method = MIEN_FIT_ALTERNATING;
    options.against_max_sweeps = 3;
    return options;
}

EvaluationOptions evaluation_with(const EvaluationOptions& common, std::int32_t method,
                                  std::int32_t max_sweeps) {
    EvaluationOptions options = common;
    options.neutralize.fit.method = static_cast<FitMethod>(method);
    options.neutralize.fit.max_sweeps = max_sweeps;
    return options;
}

}  // namespace

namespace mien::abi {

void check_fit(std::int32_t method, const char* name) {
    check_choice(method, MIEN_FIT_MIXTURE, MIEN_FIT_ALTERNATING, name);
}

TrainOptions read_train_options(const mien_train_options& given) {
    TrainOptions options;
    check_choice(given.method, MIEN_TRAIN_JPCA, MIEN_TRAIN_QOJPCA, "options.method");
    check_numbers({{"lambda", given.lambda},
                   {"lambda_factor", given.lambda_factor},
                   {"angle_tolerance_rad", given.angle_tolerance_rad}});
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

void check_pose(std::int32_t pose) {
    check_choice(pose, MIEN_POSE_AUTO, MIEN_POSE_RIGID, "options.pose");
}

mien_train_options given_train_options(const mien_train_options* options) {
    return read_options(options, default_train_options(),
                        MIEN_FIRST_SIZE(mien_train_options, cancel), "options");
}

}  // namespace mien::abi

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
        const mien_train_options given = given_train_options(options);
        TrainOptions settings = read_train_options(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        auto dataset = std::make_shared<FaceDataset>(FaceDataset::open(
            checked_text(dataset_path, "dataset_path"), unverified(), call.context()));
        TrainReport report;
        settings.stable_vertices =
            read_vertices(given.stable_vertices, given.stable_count, dataset->num_vertices(),
                          "options.stable_vertices");
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

mien_status MIEN_CALL mien_expression_model_load_memory(mien_session* session, const void* data,
                                                        uint64_t size, mien_expression_model** out,
                                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const MemoryFile from = copy_memory_file(data, size, call.context());
        auto model = keep_memory_file(from, *read_expression_model(from.file));
        std::string json = model_json(*model);
        return new mien_expression_model(std::move(model), std::move(json));
    });
}

mien_status MIEN_CALL mien_expression_model_save(mien_session* session,
                                                 const mien_expression_model* model,
                                                 const char* path, mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        save_expression_model(checked_text(path, "path"), *checked(model, "model").model,
                              call.context());
    });
}

void MIEN_CALL mien_expression_model_retain(mien_expression_model* model) {
    retain(model);
}
void MIEN_CALL mien_expression_model_release(mien_expression_model* model) {
    release(model);
}

mien_status MIEN_CALL mien_expression_model_get_counts(const mien_expression_model* model,
                                                       uint64_t* vertex_count,
                                                       uint32_t* identity_modes,
                                                       uint32_t* expression_modes,
                                                       mien_error* error) {
    return guarded(error, [&] {
        const ExpressionModel& data = *checked(model, "model").model;
        store(vertex_count, data.num_vertices());
        store(identity_modes, data.num_identity_modes());
        store(expression_modes, data.num_expression_modes());
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

mien_status MIEN_CALL mien_expression_model_sample(mien_session* session,
                                                   const mien_expression_model* model,
                                                   uint64_t seed, const char* expression,
                                                   mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const ExpressionModel& data = *checked(model, "model").model;
        auto mesh = std::make_shared<TriMesh>();
        mesh->vertices =
            sample_face(call.context(), data, seed, expression == nullptr ? "" : expression);
        mesh->triangles = data.triangles;
        return new mien_mesh(std::move(mesh));
    });
}

mien_status MIEN_CALL mien_expression_model_transfer(mien_session* session,
                                                     const mien_expression_model* model,
                                                     const mien_neutralization* source,
                                                     const mien_neutralization* target,
                                                     mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const ExpressionModel& data = *checked(model, "model").model;
        const NeutralizationResult& from = checked(source, "source").result;
        const mien_neutralization& to = checked(target, "target");
        auto mesh = std::make_shared<TriMesh>(*to.mesh->mesh);
        mesh->vertices = transfer_expression(call.context(), data, *to.mesh->mesh, to.result.pose,
                                             from.expression);
        return new mien_mesh(std::move(mesh));
    });
}

mien_status MIEN_CALL mien_neutralize(mien_session* session, const mien_expression_model* model,
                                      const mien_registration* fitted,
                                      const mien_neutralize_options* options,
                                      mien_neutralization** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        checked(session, "session");
        const mien_registration& registration = checked(fitted, "fitted");
        const ExpressionModel& data = *checked(model, "model").model;
        return neutralize_face(session, data, registration.mesh->mesh, &registration.data.weight,
                               options);
    });
}

mien_status MIEN_CALL mien_neutralize_mesh(mien_session* session,
                                           const mien_expression_model* model,
                                           const mien_mesh* face,
                                           const mien_neutralize_options* options,
                                           mien_neutralization** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        checked(session, "session");
        const ExpressionModel& data = *checked(model, "model").model;
        return neutralize_face(session, data, checked(face, "face").mesh, nullptr, options);
    });
}

mien_status MIEN_CALL mien_neutralization_apply_to_scan(mien_session* session,
                                                        const mien_neutralization* neutralization,
                                                        const mien_mesh* scan,
                                                        double max_distance_mm, mien_mesh** out,
                                                        mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const mien_neutralization& source = checked(neutralization, "neutralization");
        const TriMesh& target = *checked(scan, "scan").mesh;
        ScanTransferOptions options;
        if (max_distance_mm != 0.0) options.max_distance_mm = max_distance_mm;
        ScanTransferResult moved = transfer_to_scan(call.context(), *source.face,
                                                    source.mesh->mesh->vertices, target, options);
        return new mien_mesh(std::make_shared<const TriMesh>(std::move(moved.scan)));
    });
}

void MIEN_CALL mien_evaluate_options_init(mien_evaluate_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_evaluate_options());
}

mien_status MIEN_CALL mien_evaluate_neutralization(mien_session* session,
                                                   const mien_expression_model* model,
                                                   const char* dataset_path,
                                                   const mien_evaluate_options* options,
                                                   mien_evaluation** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_evaluate_options given =
            read_options(options, default_evaluate_options(),
                         MIEN_FIRST_SIZE(mien_evaluate_options, cancel), "options");
        check_fit(given.method, "options.method");
        check_fit(given.against_method, "options.against_method");
        if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const ExpressionModel& data = *checked(model, "model").model;
        EvaluationOptions common;
        const FaceDataset dataset =
            FaceDataset::open(checked_text(dataset_path, "dataset_path"), {}, call.context());
        common.zone = read_vertices(given.zone_vertices, given.zone_count, dataset.num_vertices(),
                                    "options.zone_vertices");
        common.stable = read_vertices(given.stable_vertices, given.stable_count,
                                      dataset.num_vertices(), "options.stable_vertices");
        const EvaluatedFaces baseline = evaluate_faces(call.context(), dataset, common, nullptr);
        const EvaluatedFaces result = evaluate_model(
            call.context(), dataset, data, evaluation_with(common, given.method, given.max_sweeps));
        EvaluatedFaces other;
        if (given.against != nullptr) {
            // Progress is monotone within a call: the second model's share is not reported.
            Context quiet = call.context();
            quiet.progress_function = nullptr;
            other = evaluate_model(
                quiet, dataset, *checked(given.against, "options.against").model,
                evaluation_with(common, given.against_method, given.against_max_sweeps));
        }
        return new mien_evaluation(evaluation_json(dataset, baseline, result,
                                                   given.against != nullptr ? &other : nullptr));
    });
}

mien_status MIEN_CALL mien_evaluation_get_json(const mien_evaluation* evaluation, char* dst,
                                               uint64_t capacity, uint64_t* count,
                                               mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(evaluation, "evaluation").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_evaluation_release(mien_evaluation* evaluation) {
    release(evaluation);
}

const mien_mesh* MIEN_CALL mien_neutralization_mesh(const mien_neutralization* neutralization) {
    return is_live(neutralization) ? neutralization->mesh : nullptr;
}

mien_status MIEN_CALL mien_neutralization_get_counts(const mien_neutralization* neutralization,
                                                     uint64_t* vertex_count,
                                                     uint32_t* identity_modes,
                                                     uint32_t* expression_modes,
                                                     mien_error* error) {
    return guarded(error, [&] {
        const NeutralizationResult& result = checked(neutralization, "neutralization").result;
        store(vertex_count, result.neutral_vertices.rows());
        store(identity_modes, result.identity.size());
        store(expression_modes, result.expression.size());
    });
}

mien_status MIEN_CALL mien_neutralization_get_coordinates(const mien_neutralization* neutralization,
                                                          double* identity, double* expression,
                                                          mien_error* error) {
    return guarded(error, [&] {
        const NeutralizationResult& result = checked(neutralization, "neutralization").result;
        check_output(identity, "identity");
        check_output(expression, "expression");
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
        copy_rows(values.data(), static_cast<uint64_t>(values.size()), sizeof(double), dst,
                  capacity, count);
    });
}

mien_status MIEN_CALL mien_neutralization_get_json(const mien_neutralization* neutralization,
                                                   char* dst, uint64_t capacity, uint64_t* count,
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
