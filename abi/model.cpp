#include "model.hpp"

#include "arrays.hpp"
#include "guard.hpp"
#include "mesh/dataset.hpp"
#include "model/model_builder.hpp"
#include "model/model_json.hpp"
#include "options.hpp"
#include "session.hpp"

using namespace mien;
using namespace mien::abi;

mien_model::mien_model(std::shared_ptr<const DeformationModel> data)
    : Object(kTag), model(std::move(data)), json(model_json(*model)) {
    // Points into the model and keeps it alive.
    mesh = new mien_mesh(std::shared_ptr<const TriMesh>(model, &model->template_mesh));
}

namespace {

constexpr std::uint64_t kMostNames = 100000;

mien_model_options default_model_options() {
    const ModelOptions core;
    const KernelTerm kernel;
    mien_model_options options{};
    options.kernel = static_cast<std::int32_t>(kernel.kind);
    options.sigma_mm = kernel.sigma_mm;
    options.scale_mm = kernel.scale_mm;
    options.nu = kernel.nu;
    options.levels = 1;
    options.num_modes = static_cast<std::int32_t>(core.num_modes);
    options.eigenvalue_threshold = core.eigenvalue_threshold;
    options.heat_time_factor = core.heat.time_factor;
    options.heat_boundary = static_cast<std::int32_t>(core.heat.boundary);
    options.pca_variance = core.pca.variance;
    return options;
}

bool read_flag(std::int32_t value, const char* name) {
    if (value != 0 && value != 1)
        fail(Status::unsupported_option, "options.%s is %d, allowed are 0 and 1", name, value);
    return value == 1;
}

KernelKind read_kind(std::int32_t kind) {
    if (kind < MIEN_KERNEL_EUCLIDEAN_SE || kind > MIEN_KERNEL_SURFACE_MATERN)
        fail(Status::unsupported_option, "kernel %d is unknown; use one of MIEN_KERNEL_...", kind);
    return static_cast<KernelKind>(kind);
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
    if (given.kernel_count > 64)
        fail(Status::invalid_argument, "options.kernel_count is %llu, at most 64 are allowed",
             static_cast<unsigned long long>(given.kernel_count));
    if (given.kernel_count != 0 && given.kernels == nullptr)
        fail(Status::invalid_argument, "options.kernels is null, kernel_count is not 0");
    for (std::uint64_t k = 0; k < given.kernel_count; ++k) {
        const mien_kernel& kernel = given.kernels[k];
        if (kernel.reserved != 0)
            fail(Status::unsupported_option, "options.kernels[%llu].reserved is not zero",
                 static_cast<unsigned long long>(k));
        terms.push_back({read_kind(kernel.kind), kernel.sigma_mm, kernel.scale_mm, kernel.nu});
    }
    return terms;
}

void check_count(std::uint64_t count, const void* data, const char* name) {
    if (count != 0 && data == nullptr)
        fail(Status::invalid_argument, "options.%s is null, its count is not 0", name);
    if (count > kMostNames)
        fail(Status::invalid_argument, "options holds %llu %s, at most %llu are allowed",
             static_cast<unsigned long long>(count), name,
             static_cast<unsigned long long>(kMostNames));
}

std::vector<Landmark> read_landmarks(const mien_model_options& given) {
    check_count(given.landmark_count, given.landmarks, "landmarks");
    std::vector<Landmark> landmarks;
    for (std::uint64_t i = 0; i < given.landmark_count; ++i)
        landmarks.push_back({checked_text(given.landmarks[i].name, "a landmark's name"),
                             given.landmarks[i].vertex});
    return landmarks;
}

std::vector<Zone> read_zones(const mien_model_options& given) {
    check_count(given.zone_count, given.zones, "zones");
    std::vector<Zone> zones;
    for (std::uint64_t i = 0; i < given.zone_count; ++i) {
        const mien_zone& zone = given.zones[i];
        Zone result;
        result.name = checked_text(zone.name, "a zone's name");
        if ((zone.vertex_count != 0 && zone.vertices == nullptr) || zone.vertex_count > 0xFFFFFFFFu ||
            reinterpret_cast<std::uintptr_t>(zone.vertices) % alignof(std::uint32_t) != 0)
            fail(Status::invalid_argument, "zone \"%.60s\": vertices is null or misaligned, or there are too many",
                 result.name.c_str());
        if (zone.vertex_count != 0)
            result.vertices.assign(zone.vertices, zone.vertices + zone.vertex_count);
        zones.push_back(std::move(result));
    }
    return zones;
}

ModelOptions read_model_options(const mien_model_options& given) {
    ModelOptions options;
    options.kernels = read_kernels(given);
    options.num_modes = given.num_modes;
    options.tolerance = given.tolerance;
    options.num_control_points = given.num_control_points;
    options.eigenvalue_threshold = given.eigenvalue_threshold;
    options.mirror_symmetric = read_flag(given.mirror_symmetric, "mirror_symmetric");
    options.mirror_correlation = given.mirror_correlation;
    options.heat.time_factor = given.heat_time_factor;
    if (given.heat_boundary < MIEN_HEAT_NEUMANN || given.heat_boundary > MIEN_HEAT_AVERAGE)
        fail(Status::unsupported_option, "options.heat_boundary is %d; use one of MIEN_HEAT_...",
             given.heat_boundary);
    options.heat.boundary = static_cast<HeatBoundary>(given.heat_boundary);
    options.pca.num_modes = given.pca_modes;
    options.pca.variance = given.pca_variance;
    options.pca.all_expressions = read_flag(given.pca_all_expressions, "pca_all_expressions");
    options.pca.align = read_flag(given.pca_align, "pca_align");
    if (given.scale_per_vertex.count != 0)
        options.scale_per_vertex = read_values(given.scale_per_vertex, "options.scale_per_vertex");
    return options;
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
        const mien_model_options given = read_options(
            options, default_model_options(), MIEN_FIRST_SIZE(mien_model_options, cancel), "options");
        const TriMesh& mesh = *checked(template_mesh, "template_mesh").mesh;
        const Call call(session, given.progress, given.progress_user, given.cancel);
        ModelOptions settings = read_model_options(given);
        FaceDataset faces;
        if (given.pca_dataset != nullptr) {
            faces = FaceDataset::open(given.pca_dataset, SafetensorsReadOptions{}, call.context());
            settings.pca_faces = &faces;
        }
        const BuiltModel built = build_deformation_model(mesh, read_landmarks(given),
                                                         read_zones(given), settings, call.context());
        return new mien_model(built.model);
    });
}

mien_status MIEN_CALL mien_model_load(mien_session* session, const char* path, mien_model** out,
                                      mien_error* error) {
    return load(session, path, true, out, error);
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
        if (vertex_count != nullptr) *vertex_count = static_cast<uint64_t>(data.num_vertices());
        if (scalar_modes != nullptr) *scalar_modes = static_cast<uint64_t>(data.basis.cols);
        if (vector_modes != nullptr) *vector_modes = static_cast<uint64_t>(data.pca_modes.cols);
    });
}

mien_status MIEN_CALL mien_model_get_json(const mien_model* model, char* dst, uint64_t capacity,
                                          uint64_t* count, mien_error* error) {
    return guarded(error, [&] {
        const std::string& json = checked(model, "model").json;
        copy_text(json.data(), json.size(), dst, capacity, count);
    });
}

const mien_mesh* MIEN_CALL mien_model_mesh(const mien_model* model) {
    return is_live(model) ? model->mesh : nullptr;
}

void MIEN_CALL mien_model_retain(mien_model* model) { retain(model); }

void MIEN_CALL mien_model_release(mien_model* model) { release(model); }

}  // extern "C"
