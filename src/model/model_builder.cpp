#include "model/model_builder.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "model/kernel_basis.hpp"
#include "model/mirror.hpp"
#include "model/template_walls.hpp"

namespace mien {
namespace {

void check_names(const TriMesh& mesh, const std::vector<Landmark>& landmarks,
                 const std::vector<Zone>& zones) {
    const auto check = [&](std::uint32_t vertex, const char* what, const std::string& name) {
        if (static_cast<Index>(vertex) >= mesh.vertices.rows())
            fail_at(Status::invalid_argument, vertex,
                    "%s \"%.60s\" names vertex %lld, the template has %lld vertices", what,
                    name.c_str(), static_cast<long long>(vertex),
                    static_cast<long long>(mesh.vertices.rows()));
    };
    for (const Landmark& landmark : landmarks) check(landmark.vertex, "landmark", landmark.name);
    for (const Zone& zone : zones)
        for (const std::uint32_t vertex : zone.vertices) check(vertex, "zone", zone.name);
}

Index scalar_modes(const ModelOptions& options, const TriMesh& mesh) {
    if (options.num_modes < 3)
        fail(Status::invalid_argument,
             "%lld deformation modes; a model needs at least 3 (one per axis)",
             static_cast<long long>(options.num_modes));
    return std::min(options.num_modes / 3, mesh.vertices.rows());
}

void check_options(const ModelOptions& options, const TriMesh& mesh) {
    if (!options.kernels.empty() || options.pca_faces == nullptr) check_kernels(options.kernels);
    const Vector& scale = options.scale_per_vertex;
    if (scale.size() != 0 && scale.size() != mesh.vertices.rows())
        fail(Status::mismatch, "%lld vertex scales for a template of %lld vertices",
             static_cast<long long>(scale.size()), static_cast<long long>(mesh.vertices.rows()));
    for (Index v = 0; v < scale.size(); ++v)
        if (!(scale[v] >= 0) || !std::isfinite(scale[v]))
            fail_at(Status::invalid_argument, v,
                    "the scale of vertex %lld is %g; give numbers >= 0", static_cast<long long>(v),
                    scale[v]);
    if (scale.size() != 0 && !(scale.maxCoeff() > 0))
        fail(Status::invalid_argument, "every vertex scale is zero; nothing could move");
    if (!(options.mirror_correlation >= 0 && options.mirror_correlation <= 1))
        fail(Status::invalid_argument, "mirror correlation %g is outside 0 .. 1",
             options.mirror_correlation);
    if (options.num_control_points < 0)
        fail(Status::invalid_argument, "a negative number of control points");
}

struct Storage {
    Eigen::MatrixXf basis, pca_modes;
};

void describe(const ModelOptions& options, const LowRankReport& report, DeformationModel& model) {
    std::string names, sigmas, scales, nus;
    for (const KernelTerm& term : options.kernels) {
        const char* comma = names.empty() ? "" : ",";
        names += comma + std::string(kernel_name(term.kind));
        sigmas += comma + info_number(term.sigma_mm);
        scales += comma + info_number(term.scale_mm);
        nus += comma + info_number(term.nu);
    }
    auto& info = model.info;
    info["kernel"] = names;
    info["sigma_mm"] = sigmas;
    info["scale_mm"] = scales;
    info["nu"] = nus;
    info["scalar_modes"] = std::to_string(report.rank);
    info["deformation_modes"] = std::to_string(3 * report.rank);
    info["control_points"] = std::to_string(report.num_control_points);
    info["variance_explained"] = info_number(report.variance_explained);
    info["max_variance_error"] = info_number(report.max_variance_error);
    info["negative_mass"] = info_number(report.negative_mass);
    info["negative_eigenvalues"] = std::to_string(report.num_negative);
    info["smallest_eigenvalue"] = info_number(report.smallest_eigenvalue);
    info["mirror_symmetric"] = options.mirror_symmetric ? "1" : "0";
    info["mirror_correlation"] = info_number(options.mirror_correlation);
    info["scale_per_vertex"] = options.scale_per_vertex.size() != 0 ? "1" : "0";
    info["heat_time_factor"] = info_number(options.heat.time_factor);
    info["heat_boundary"] = std::to_string(static_cast<int>(options.heat.boundary));
}

/// The kernel's part of a model: basis, eigenvalues, prior variances.
LowRankReport build_basis(const TriMesh& mesh, const ModelOptions& options, const Context& context,
                          Storage& storage, DeformationModel& model) {
    RankOptions rank;
    rank.num_modes = scalar_modes(options, mesh);
    rank.tolerance = options.tolerance;
    rank.threshold = options.eigenvalue_threshold;
    const KernelBlocks blocks = prepare_kernel_blocks(
        mesh, options.kernels, rank.num_modes, options.num_control_points, options.heat, context);
    std::vector<std::uint32_t> mirror;
    if (options.mirror_symmetric) mirror = mirror_map(mesh, context);
    LowRankBasis low_rank = kernel_basis(blocks, options.kernels, rank, options.scale_per_vertex,
                                         context, options.mirror_symmetric ? &mirror : nullptr);
    if (options.mirror_symmetric)
        model.prior_variance = mirrored_prior_variance(low_rank.parity, options.mirror_correlation);
    storage.basis = std::move(low_rank.basis);
    model.eigenvalues = low_rank.eigenvalues;
    return low_rank.report;
}

}  // namespace

std::string info_number(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return std::string(text, end);
}

BuiltModel build_deformation_model(const TriMesh& template_mesh,
                                   const std::vector<Landmark>& landmarks,
                                   const std::vector<Zone>& zones, const ModelOptions& options,
                                   const Context& context) {
    check_mesh(template_mesh, "the template");
    check_names(template_mesh, landmarks, zones);
    check_options(options, template_mesh);
    const Index n = template_mesh.vertices.rows();
    auto storage = std::make_shared<Storage>();
    auto model = std::make_shared<DeformationModel>();
    LowRankReport report;
    if (options.pca_faces != nullptr) {
        PointDistribution faces =
            train_point_distribution(*options.pca_faces, template_mesh, options.pca, context);
        model->mean_displacement = std::move(faces.mean);
        storage->pca_modes = std::move(faces.modes);
        auto& info = model->info;
        info["pca_modes"] = std::to_string(faces.variances.size());
        info["pca_faces"] = std::to_string(faces.num_faces);
        info["pca_vertices"] = std::to_string(faces.num_vertices);
        info["pca_variance_explained"] = info_number(faces.variance_explained);
        model->pca_left_out_mm = faces.left_out_mm;
        if (faces.left_out_mm > 0) info[kLeftOutInfo] = info_number(faces.left_out_mm);
    }
    if (!options.kernels.empty()) {
        report = build_basis(template_mesh, options, context, *storage, *model);
        describe(options, report, *model);
    } else {
        storage->basis.resize(n, 0);
        model->info["kernel"] = "none";
    }
    model->template_mesh = template_mesh;
    model->landmarks = landmarks;
    model->zones = zones;
    model->basis = {storage->basis.data(), n, storage->basis.cols()};
    model->pca_modes = {storage->pca_modes.data(), 3 * n, storage->pca_modes.cols()};
    model->storage = storage;
    if (template_mesh.triangles.rows() > 0) {
        model->walls = find_walls(template_mesh, WallSettings(), context);
        model->walls_key = walls_key(template_mesh, WallSettings());
    }
    return {model, report};
}

}  // namespace mien
