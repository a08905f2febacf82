#include "expression.hpp"

#include "arrays.hpp"
#include "expression/report_json.hpp"
#include "expression/sampling.hpp"
#include "expression/training.hpp"
#include "expression_options.hpp"
#include "guard.hpp"
#include "memory_file.hpp"
#include "options.hpp"
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
    options.identity_modes = options.expression_modes = static_cast<std::int32_t>(kSearchedModes);
    options.max_iterations = subspaces.max_iterations;
    options.passes = span.passes;
    options.lambda_factor = subspaces.lambda_factor;
    options.angle_tolerance_rad = subspaces.angle_tolerance_rad;
    return options;
}

Vector read_coordinates(const mien_array_view* view, const char* name) {
    check_output(view, name);
    return view == nullptr || checked_view(view, name).count == 0 ? Vector()
                                                                  : read_values(*view, name);
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

mien_status MIEN_CALL mien_expression_model_train(mien_session* session, const char* dataset_path,
                                                  const mien_train_options* options,
                                                  mien_expression_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_train_options given = given_train_options(options);
        TrainOptions settings = read_train_options(given);
        const Call call(session, given.progress, given.progress_user, given.cancel);
        auto dataset = std::make_shared<FaceDataset>(FaceDataset::open(
            checked_text(dataset_path, "dataset_path"), digest_alone(), call.context()));
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

}  // extern "C"
