#include "model.hpp"

#include <algorithm>

#include "arrays.hpp"
#include "guard.hpp"
#include "memory_file.hpp"
#include "mesh/dataset.hpp"
#include "model/landmarks.hpp"
#include "model/model_builder.hpp"
#include "model/model_json.hpp"
#include "model/posterior.hpp"
#include "model/sampling.hpp"
#include "model/tuning.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

mien_model::mien_model(std::shared_ptr<const DeformationModel> data)
    : Object(kTag), model(std::move(data)), json(model_json(*model)) {
    // Points into the model and keeps it alive.
    mesh = new mien_mesh(std::shared_ptr<const TriMesh>(model, &model->template_mesh));
}

struct mien_tuning : Object {
    static constexpr Tag kTag = Tag::tuning;
    static constexpr const char* kName = "tuning";
    explicit mien_tuning(std::string report) : Object(kTag), json(std::move(report)) {}
    const std::string json;
};

namespace {

/// Allocates nothing: it runs in a function that can report nothing.
mien_model_options default_model_options() {
    const HeatOptions heat;
    const PcaOptions pca;
    const KernelTerm kernel;
    mien_model_options options{};
    options.kernel = static_cast<std::int32_t>(kernel.kind);
    options.sigma_mm = kernel.sigma_mm;
    options.scale_mm =
        3;  // what faces differ by from their mean, so that a scan may pull a template along
    options.nu = kernel.nu;
    options.levels = 1;
    options.num_modes = static_cast<std::int32_t>(ModelOptions::kNumModes);
    options.eigenvalue_threshold = ModelOptions::kEigenvalueThreshold;
    options.heat_time_factor = heat.time_factor;
    options.heat_boundary = static_cast<std::int32_t>(heat.boundary);
    options.pca_variance = pca.variance;
    options.pca_all_expressions = pca.all_expressions ? 1 : 0;
    options.pca_align = pca.align ? 1 : 0;
    return options;
}

KernelKind read_kind(std::int32_t kind) {
    check_choice(kind, MIEN_KERNEL_EUCLIDEAN_SE, MIEN_KERNEL_SURFACE_MATERN, "kernel");
    return static_cast<KernelKind>(kind);
}

template <typename Number>
void check_reserved(Number reserved, const char* name, std::uint64_t index) {
    if (reserved != 0)
        fail_at(Status::unsupported_option, static_cast<std::int64_t>(index),
                "%s[%llu].reserved is not zero", name, static_cast<unsigned long long>(index));
}

std::vector<KernelTerm> read_kernels(const mien_model_options& given) {
    std::vector<KernelTerm> terms;
    if (given.kernel != MIEN_KERNEL_NONE) {
        KernelTerm term;
        term.kind = read_kind(given.kernel);
        term.sigma_mm = given.sigma_mm;
        term.scale_mm = given.scale_mm;
        term.nu = given.nu;
        terms = multiscale(term, given.levels);
    }
    check_array(given.kernels, given.kernel_count, alignof(mien_kernel), 64, "options.kernels");
    for (std::uint64_t k = 0; k < given.kernel_count; ++k) {
        const mien_kernel& kernel = given.kernels[k];
        check_reserved(kernel.reserved, "options.kernels", k);
        check_numbers(
            {{"sigma_mm", kernel.sigma_mm}, {"scale_mm", kernel.scale_mm}, {"nu", kernel.nu}},
            "options.kernels[]");
        terms.push_back({read_kind(kernel.kind), kernel.sigma_mm, kernel.scale_mm, kernel.nu});
    }
    return terms;
}

std::vector<Landmark> read_landmarks(const mien_model_options& given) {
    check_array(given.landmarks, given.landmark_count, alignof(mien_landmark), kMostNames,
                "options.landmarks");
    std::vector<Landmark> landmarks;
    for (std::uint64_t i = 0; i < given.landmark_count; ++i) {
        const mien_landmark& landmark = given.landmarks[i];
        check_reserved(landmark.reserved, "options.landmarks", i);
        landmarks.push_back({checked_text(landmark.name, "a landmark's name"), landmark.vertex});
    }
    return landmarks;
}

ModelOptions read_model_options(const mien_model_options& given) {
    check_numbers({{"sigma_mm", given.sigma_mm},
                   {"scale_mm", given.scale_mm},
                   {"nu", given.nu},
                   {"tolerance", given.tolerance},
                   {"mirror_correlation", given.mirror_correlation},
                   {"eigenvalue_threshold", given.eigenvalue_threshold},
                   {"heat_time_factor", given.heat_time_factor},
                   {"pca_variance", given.pca_variance}});
    ModelOptions options;
    options.kernels = read_kernels(given);
    options.num_modes = given.num_modes;
    options.tolerance = given.tolerance;
    options.num_control_points = given.num_control_points;
    options.eigenvalue_threshold = given.eigenvalue_threshold;
    options.mirror_symmetric = read_switch(given.mirror_symmetric, "options.mirror_symmetric");
    options.mirror_correlation = given.mirror_correlation;
    options.heat.time_factor = given.heat_time_factor;
    check_choice(given.heat_boundary, MIEN_HEAT_NEUMANN, MIEN_HEAT_AVERAGE,
                 "options.heat_boundary");
    options.heat.boundary = static_cast<HeatBoundary>(given.heat_boundary);
    options.pca.num_modes = given.pca_modes;
    options.pca.variance = given.pca_variance;
    options.pca.all_expressions =
        read_switch(given.pca_all_expressions, "options.pca_all_expressions");
    options.pca.align = read_switch(given.pca_align, "options.pca_align");
    if (given.scale_per_vertex.count != 0)
        options.scale_per_vertex = read_values(given.scale_per_vertex, "options.scale_per_vertex");
    return options;
}

mien_tune_options default_tune_options() {
    const TuneOptions core;
    mien_tune_options options{};
    options.kernel = static_cast<std::int32_t>(core.kernel.kind);
    options.scale_mm = core.kernel.scale_mm;
    options.nu = core.kernel.nu;
    options.rho = core.rho;
    options.levels = core.levels;
    options.num_modes = static_cast<std::int32_t>(core.num_modes);
    return options;
}

TuneOptions read_tune_options(const mien_tune_options& given, const FaceDataset& faces) {
    check_numbers({{"scale_mm", given.scale_mm}, {"nu", given.nu}, {"rho", given.rho}});
    TuneOptions options;
    options.kernel = {read_kind(given.kernel), options.kernel.sigma_mm, given.scale_mm, given.nu};
    options.levels = given.levels;
    options.num_modes = given.num_modes;
    options.rho = given.rho;
    if (given.sigma_count != 0)
        options.sigmas_mm =
            read_array(given.sigmas_mm, given.sigma_count, kMostNames, "options.sigmas_mm");
    options.scales_mm =
        read_array(given.scales_mm, given.scale_count, kMostNames, "options.scales_mm");
    for (const std::int32_t levels :
         read_array(given.level_counts, given.level_count, kMostNames, "options.level_counts"))
        options.level_counts.push_back(levels);
    check_array(given.expressions, given.expression_count, alignof(const char*), kMostNames,
                "options.expressions");
    std::vector<std::string> expressions;
    for (std::uint32_t i = 0; i < given.expression_count; ++i)
        expressions.emplace_back(checked_text(given.expressions[i], "an expression name"));
    options.faces = select_faces(faces, expressions, given.max_subjects);
    return options;
}

std::vector<LandmarkObservation> read_observations(const DeformationModel& model,
                                                   const mien_landmark_observation* given,
                                                   std::uint64_t count) {
    if (count == 0) fail(Status::invalid_argument, "observation_count is 0");
    check_array(given, count, alignof(mien_landmark_observation), kMostNames, "observations");
    std::vector<LandmarkObservation> observations;
    for (std::uint64_t i = 0; i < count; ++i) {
        check_reserved(given[i].reserved, "observations", i);
        LandmarkObservation seen;
        seen.vertex = given[i].vertex;
        if (given[i].name != nullptr) {
            const Landmark* found = find_landmark(model.landmarks, given[i].name);
            if (found == nullptr)
                fail_at(Status::not_found, static_cast<std::int64_t>(i),
                        "the model has no landmark \"%.60s\"", given[i].name);
            seen.vertex = found->vertex;
        }
        if (static_cast<Index>(seen.vertex) >= model.num_vertices())
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "observation %llu is vertex %lld of %lld", static_cast<unsigned long long>(i),
                    static_cast<long long>(seen.vertex),
                    static_cast<long long>(model.num_vertices()));
        for (int c = 0; c < 3; ++c)
            seen.displacement_mm[c] =
                given[i].position[c] -
                model.template_mesh.vertices(static_cast<Index>(seen.vertex), c);
        seen.noise_mm = given[i].noise_mm;
        observations.push_back(seen);
    }
    return observations;
}

mien_status load(mien_session* session, const char* path, bool verify, mien_model** out,
                 mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        SafetensorsReadOptions options;
        options.verify_hash = options.verify_finite = verify;
        return new mien_model(
            load_deformation_model(checked_text(path, "path"), options, call.context()));
    });
}

}  // namespace

extern "C" {

void MIEN_CALL mien_model_options_init(mien_model_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_model_options());
}

mien_status MIEN_CALL mien_model_build(mien_session* session, const mien_mesh* template_mesh,
                                       const mien_model_options* options, mien_model** out,
                                       mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_model_options given =
            read_options(options, default_model_options(),
                         MIEN_FIRST_SIZE(mien_model_options, cancel), "options");
        const TriMesh& mesh = *checked(template_mesh, "template_mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        ModelOptions settings = read_model_options(given);
        FaceDataset faces;
        if (given.pca_dataset != nullptr) {
            faces = FaceDataset::open(given.pca_dataset, SafetensorsReadOptions{}, call.context());
            settings.pca_faces = &faces;
        }
        const BuiltModel built = build_deformation_model(
            mesh, read_landmarks(given),
            read_zones(given.zones, given.zone_count, mesh.vertices.rows(), "options.zones"),
            settings, call.context());
        return new mien_model(built.model);
    });
}

mien_status MIEN_CALL mien_model_load(mien_session* session, const char* path, mien_model** out,
                                      mien_error* error) {
    return load(session, path, true, out, error);
}

mien_status MIEN_CALL mien_model_load_memory(mien_session* session, const void* data, uint64_t size,
                                             mien_model** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const Call call(session);
        const MemoryFile from = copy_memory_file(data, size, call.context());
        return new mien_model(keep_memory_file(from, *read_deformation_model(from.file)));
    });
}

mien_status MIEN_CALL mien_model_load_trusted(mien_session* session, const char* path,
                                              mien_model** out, mien_error* error) {
    return load(session, path, false, out, error);
}

mien_status MIEN_CALL mien_model_save(mien_session* session, const mien_model* model,
                                      const char* path, mien_error* error) {
    return guarded(error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        const Call call(session);
        save_deformation_model(checked_text(path, "path"), data, call.context());
    });
}

mien_status MIEN_CALL mien_model_get_counts(const mien_model* model, uint64_t* vertex_count,
                                            uint64_t* scalar_modes, uint64_t* vector_modes,
                                            mien_error* error) {
    return guarded(error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        store(vertex_count, data.num_vertices());
        store(scalar_modes, data.basis.cols);
        store(vector_modes, data.pca_modes.cols);
    });
}

mien_status MIEN_CALL mien_model_get_json(const mien_model* model, char* dst, uint64_t capacity,
                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(model, "model").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_model_get_variance(const mien_model* model, double* dst,
                                              uint64_t capacity, uint64_t* count,
                                              mien_error* error) {
    return guarded(error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        const auto rows = static_cast<std::uint64_t>(data.num_vertices());
        Points variance;
        if (dst != nullptr && capacity >= rows) variance = pointwise_variance(data, Context());
        copy_doubles(variance.data(), rows, 3, MIEN_DTYPE_F64, dst, capacity, count);
    });
}

mien_status MIEN_CALL mien_model_sample(mien_session* session, const mien_model* model,
                                        uint64_t seed, uint64_t index, double strength,
                                        mien_mesh** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        const Call call(session);
        return new mien_mesh(std::make_shared<const TriMesh>(
            sample_face(data, seed, index, strength, call.context())));
    });
}

mien_status MIEN_CALL mien_model_condition(mien_session* session, const mien_model* model,
                                           const mien_landmark_observation* observations,
                                           uint64_t observation_count, mien_model** out,
                                           mien_error* error) {
    return guarded_create(out, error, [&] {
        const DeformationModel& data = *checked(model, "model").model;
        const Call call(session);
        return new mien_model(condition_model(
            data, read_observations(data, observations, observation_count), call.context()));
    });
}

void MIEN_CALL mien_tune_options_init(mien_tune_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_tune_options());
}

mien_status MIEN_CALL mien_model_tune(mien_session* session, const mien_mesh* template_mesh,
                                      const char* dataset, const mien_tune_options* options,
                                      mien_tuning** out, mien_error* error) {
    return guarded_create(out, error, [&] {
        const mien_tune_options given = read_options(
            options, default_tune_options(), MIEN_FIRST_SIZE(mien_tune_options, cancel), "options");
        const TriMesh& mesh = *checked(template_mesh, "template_mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        const FaceDataset faces = FaceDataset::open(checked_text(dataset, "dataset"),
                                                    SafetensorsReadOptions{}, call.context());
        return new mien_tuning(
            tune_json(tune_kernel(mesh, faces, read_tune_options(given, faces), call.context())));
    });
}

mien_status MIEN_CALL mien_tuning_get_json(const mien_tuning* tuning, char* dst, uint64_t capacity,
                                           uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(tuning, "tuning").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

void MIEN_CALL mien_tuning_release(mien_tuning* tuning) {
    release(tuning);
}

const mien_mesh* MIEN_CALL mien_model_mesh(const mien_model* model) {
    return is_live(model) ? model->mesh : nullptr;
}

void MIEN_CALL mien_model_retain(mien_model* model) {
    retain(model);
}

void MIEN_CALL mien_model_release(mien_model* model) {
    release(model);
}

}  // extern "C"
