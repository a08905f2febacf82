#include "model/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <numeric>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/json_text.hpp"
#include "model/kernel_basis.hpp"

namespace mien {
namespace {

void check(const TuneOptions& options, const FaceDataset& faces, const TriMesh& mesh) {
    if (options.sigmas_mm.empty() || options.sigmas_mm.size() > 10000)
        fail(Status::invalid_argument, "%zu values of sigma; give 1 to 10000",
             options.sigmas_mm.size());
    const std::size_t others = std::max<std::size_t>(1, options.scales_mm.size()) *
                               std::max<std::size_t>(1, options.level_counts.size());
    if (options.scales_mm.size() > 10000 || options.level_counts.size() > 12 ||
        others * options.sigmas_mm.size() > 10000)
        fail(Status::invalid_argument,
             "%zu sigmas, %zu scales and %zu numbers of levels; give at most 10000 combinations",
             options.sigmas_mm.size(), options.scales_mm.size(), options.level_counts.size());
    if (options.num_modes < 3)
        fail(Status::invalid_argument, "%lld deformation modes; a model needs at least 3",
             static_cast<long long>(options.num_modes));
    if (!(options.rho >= 0) || !std::isfinite(options.rho))
        fail(Status::invalid_argument, "rho %g must be a number >= 0", options.rho);
    for (const Index face : options.faces)
        if (face < 0 || face >= faces.num_faces())
            fail(Status::invalid_argument, "face %lld of a dataset of %lld",
                 static_cast<long long>(face), static_cast<long long>(faces.num_faces()));
    if (faces.num_vertices() > mesh.vertices.rows())
        fail(Status::mismatch, "the dataset's faces have %lld vertices, the template %lld",
             static_cast<long long>(faces.num_vertices()),
             static_cast<long long>(mesh.vertices.rows()));
}

/// One place of the grid: the kernel of this sigma, scale and number of levels, and its residuals.
struct GridPlace {
    double sigma_mm, scale_mm;
    int levels;
};

std::vector<GridPlace> grid_of(const TuneOptions& options) {
    const std::vector<int> levels =
        options.level_counts.empty() ? std::vector<int>{options.levels} : options.level_counts;
    const std::vector<double> scales = options.scales_mm.empty()
                                           ? std::vector<double>{options.kernel.scale_mm}
                                           : options.scales_mm;
    std::vector<GridPlace> grid;
    for (const int level : levels)
        for (const double scale : scales)
            for (const double sigma : options.sigmas_mm) grid.push_back({sigma, scale, level});
    return grid;
}

TunePoint tune_point(const GridPlace& place, const TuneOptions& options, const KernelBlocks& blocks,
                     const RankOptions& rank, const std::vector<Points>& displacements,
                     const Context& context) {
    KernelTerm term = options.kernel;
    term.sigma_mm = place.sigma_mm;
    term.scale_mm = place.scale_mm;
    const std::vector<KernelTerm> terms = multiscale(term, place.levels);
    check_kernels(terms);
    const LowRankBasis basis = kernel_basis(blocks, terms, rank, Vector(), context);
    TunePoint point;
    point.sigma_mm = place.sigma_mm;
    point.scale_mm = place.scale_mm;
    point.levels = place.levels;
    point.report = basis.report;
    point.residuals = fit_residuals(basis.basis, displacements, options.rho, context);
    const double count = static_cast<double>(point.residuals.size());
    for (const double residual : point.residuals) point.residual_mean += residual / count;
    for (const double residual : point.residuals)
        point.residual_sd += std::pow(residual - point.residual_mean, 2);
    point.residual_sd = count > 1 ? std::sqrt(point.residual_sd / (count - 1)) : 0.0;
    return point;
}

}  // namespace

std::vector<double> fit_residuals(const Eigen::MatrixXf& basis,
                                  const std::vector<Points>& displacements, double rho,
                                  const Context& context) {
    if (displacements.empty()) return {};
    const Index known = displacements.front().rows(), r = basis.cols();
    const Index columns = 3 * static_cast<Index>(displacements.size());
    const Matrix a = basis.topRows(known).cast<double>();
    Matrix normal(r, r), y(known, columns);
    for (std::size_t k = 0; k < displacements.size(); ++k)
        y.middleCols(3 * static_cast<Index>(k), 3) = displacements[k];
    dense::weighted_gram(context, a, Vector(), normal);
    // Damping far below the data, so that rho = 0 is a least-squares fit whatever the basis.
    normal.diagonal().array() += rho + 1e-12 * normal.diagonal().maxCoeff();
    Matrix alpha(r, columns);
    dense::multiply(context, 1.0, a, dense::Op::transpose, y, dense::Op::none, 0.0, alpha);
    if (!dense::factor_spd(normal))
        fail(Status::no_solution, "the fit with known correspondence has no unique solution");
    dense::solve_factored(normal, alpha);
    dense::multiply(context, -1.0, a, dense::Op::none, alpha, dense::Op::none, 1.0, y);
    std::vector<double> residuals;
    for (std::size_t k = 0; k < displacements.size(); ++k)
        residuals.push_back(y.middleCols(3 * static_cast<Index>(k), 3).norm());
    return residuals;
}

TuneReport tune_kernel(const TriMesh& template_mesh, const FaceDataset& faces,
                       const TuneOptions& options, const Context& context) {
    check_mesh(template_mesh, "the template");
    check(options, faces, template_mesh);
    TuneReport report;
    report.kernel = options.kernel;
    report.levels = options.levels;
    report.rho = options.rho;
    report.faces = options.faces;
    if (report.faces.empty()) {
        report.faces.resize(static_cast<std::size_t>(faces.num_faces()));
        std::iota(report.faces.begin(), report.faces.end(), Index(0));
    }
    const Index known = faces.num_vertices();
    context.require_memory(static_cast<std::size_t>(known) * report.faces.size() * 48,
                           "tuning a kernel on these faces");
    std::vector<Points> displacements;
    for (const Index k : report.faces) {
        Points face;
        faces.face(k, face);
        displacements.push_back(face - template_mesh.vertices.topRows(known));
        if (!displacements.back().allFinite())
            fail_at(Status::corrupt, k, "face %lld of the dataset is not finite",
                    static_cast<long long>(k));
    }
    RankOptions rank;
    rank.num_modes = std::min(options.num_modes / 3, template_mesh.vertices.rows());
    const KernelBlocks blocks = prepare_kernel_blocks(template_mesh, {options.kernel},
                                                      rank.num_modes, 0, options.heat, context);
    const std::vector<GridPlace> grid = grid_of(options);
    for (const GridPlace& place : grid) {
        context.progress(Stage::fitting, static_cast<double>(report.points.size()) /
                                             static_cast<double>(grid.size()));
        // The inner steps run silently: their own progress would fall back at every place.
        Context silent = context;
        silent.progress_function = nullptr;
        report.points.push_back(tune_point(place, options, blocks, rank, displacements, silent));
        if (report.points.back().residual_mean < report.points[report.best].residual_mean)
            report.best = report.points.size() - 1;
    }
    context.progress(Stage::fitting, 1);
    return report;
}

std::vector<Index> select_faces(const FaceDataset& faces,
                                const std::vector<std::string>& expressions, Index max_subjects) {
    if (max_subjects < 0) fail(Status::invalid_argument, "a negative number of subjects");
    std::vector<char> wanted(faces.expression_names().size(), expressions.empty() ? 1 : 0);
    for (const std::string& name : expressions) {
        const auto& names = faces.expression_names();
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            fail(Status::not_found, "the dataset has no expression \"%.60s\"", name.c_str());
        wanted[static_cast<std::size_t>(found - names.begin())] = 1;
    }
    std::vector<int> subjects;
    std::vector<Index> chosen;
    for (Index k = 0; k < faces.num_faces(); ++k) {
        auto known = std::find(subjects.begin(), subjects.end(), faces.subject(k));
        if (known == subjects.end()) known = subjects.insert(known, faces.subject(k));
        if (max_subjects != 0 && known - subjects.begin() >= max_subjects) continue;
        if (wanted[static_cast<std::size_t>(faces.expression(k))]) chosen.push_back(k);
    }
    if (chosen.empty())
        fail(Status::invalid_argument, "no face of the dataset has these expressions");
    return chosen;
}

std::string tune_json(const TuneReport& report) {
    JsonText json;
    json.begin_object()
        .field("kernel", kernel_name(report.kernel.kind))
        .field("scale_mm", report.kernel.scale_mm)
        .field("nu", report.kernel.nu)
        .field("levels", report.levels)
        .field("rho", report.rho)
        .field("faces", report.faces.size())
        .field("best_sigma_mm", report.points[report.best].sigma_mm)
        .field("best_scale_mm", report.points[report.best].scale_mm)
        .field("best_levels", report.points[report.best].levels);
    json.key("points").begin_array();
    for (const TunePoint& point : report.points)
        json.begin_object()
            .field("sigma_mm", point.sigma_mm)
            .field("scale_mm", point.scale_mm)
            .field("levels", point.levels)
            .field("residual_mean_mm", point.residual_mean)
            .field("residual_sd_mm", point.residual_sd)
            .field("scalar_modes", point.report.rank)
            .field("variance_explained", point.report.variance_explained)
            .field("max_variance_error", point.report.max_variance_error)
            .field("negative_mass", point.report.negative_mass)
            .field("residuals_mm", point.residuals)
            .end_object();
    return json.end_array().end_object().take();
}

}  // namespace mien
