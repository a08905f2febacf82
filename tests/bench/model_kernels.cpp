// Kernels in numbers: model_kernels TEMPLATE.ply FACES.safetensors
//
// FACES: a dataset in the template's correspondence with several expressions (it may cover only the
// template's first vertices). Prints, as Markdown, what each model costs and the residuals of fits
// with known correspondence in the layout of the thesis (figure 2.12).
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "mesh/mesh_file.hpp"
#include "model/kernel_basis.hpp"
#include "model/model_builder.hpp"
#include "model/tuning.hpp"

using namespace mien;

namespace {

double seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

struct Candidate {
    const char* title;
    KernelKind kind;
    std::vector<double> sigmas;
};

const std::vector<Candidate>& candidates() {
    static const std::vector<Candidate> list{
        {"Euclidean", KernelKind::euclidean_se, {5, 7, 10, 12, 14, 18}},
        {"Geodesic", KernelKind::geodesic_se, {12, 16, 20, 25}},
        {"Spline", KernelKind::bspline, {40, 55, 70}},
        {"Matern", KernelKind::surface_matern, {10, 14, 20, 28, 40}}};
    return list;
}

struct Column {
    std::vector<double> mean, sd;  ///< per expression
};

Column residuals_of(const TriMesh& mesh, const FaceDataset& faces, const KernelTerm& term,
                    const Context& context) {
    RankOptions rank;
    const KernelBlocks blocks = prepare_kernel_blocks(mesh, {term}, rank.num_modes, 0, {}, context);
    const LowRankBasis basis = kernel_basis(blocks, {term}, rank, Vector(), context);
    Column column;
    for (std::size_t e = 0; e < faces.expression_names().size(); ++e) {
        std::vector<Points> displacements;
        Points face;
        for (Index k = 0; k < faces.num_faces(); ++k)
            if (faces.expression(k) == static_cast<int>(e)) {
                faces.face(k, face);
                displacements.push_back(face - mesh.vertices.topRows(faces.num_vertices()));
            }
        const std::vector<double> residuals = fit_residuals(basis.basis, displacements, 5, context);
        double mean = 0, squares = 0;
        for (const double r : residuals) mean += r / static_cast<double>(residuals.size());
        for (const double r : residuals) squares += (r - mean) * (r - mean);
        column.mean.push_back(mean);
        column.sd.push_back(
            std::sqrt(squares / std::max(1.0, static_cast<double>(residuals.size()) - 1)));
    }
    return column;
}

void table(const TriMesh& mesh, const FaceDataset& faces, const Context& context) {
    std::printf(
        "\nTuning: one neutral and one mouth_stretch face, residual norm in mm, rho 5, 999 "
        "modes.\n\n"
        "| kernel | residual at sigma (mm) | best |\n|---|---|---|\n");
    std::vector<Column> columns;
    std::vector<double> best;
    for (const Candidate& candidate : candidates()) {
        TuneOptions options;
        options.kernel.kind = candidate.kind;
        options.sigmas_mm = candidate.sigmas;
        options.faces = select_faces(faces, {"neutral", "mouth_stretch"}, 1);
        const TuneReport report = tune_kernel(mesh, faces, options, context);
        std::printf("| %s |", kernel_name(candidate.kind));
        for (const TunePoint& point : report.points)
            std::printf(" %g: %.1f", point.sigma_mm, point.residual_mean);
        best.push_back(report.points[report.best].sigma_mm);
        std::printf(" | %g |\n", best.back());
        KernelTerm term;
        term.kind = candidate.kind;
        term.sigma_mm = best.back();
        columns.push_back(residuals_of(mesh, faces, term, context));
        std::fflush(stdout);
    }
    std::printf(
        "\nResidual norm in mm, mean and standard deviation over %lld subjects.\n\n| pose |",
        static_cast<long long>(faces.num_faces()) /
            static_cast<long long>(faces.expression_names().size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        std::printf(" %s mean | std |", candidates()[k].title);
    std::printf("\n|---|");
    for (std::size_t k = 0; k < columns.size(); ++k) std::printf("---:|---:|");
    for (std::size_t e = 0; e < faces.expression_names().size(); ++e) {
        std::printf("\n| %s |", faces.expression_names()[e].c_str());
        for (const Column& column : columns)
            std::printf(" %.1f | %.1f |", column.mean[e], column.sd[e]);
    }
    std::printf("\n| all |");
    for (const Column& column : columns) {
        double mean = 0, squares = 0;
        const double count = static_cast<double>(column.mean.size());
        for (const double m : column.mean) mean += m / count;
        for (const double m : column.mean) squares += (m - mean) * (m - mean);
        std::printf(" %.1f | %.1f |", mean, std::sqrt(squares / (count - 1)));
    }
    std::printf("\n");
}

void costs(const TriMesh& mesh, const Context& context) {
    std::printf(
        "\n| kernel, 999 modes, %lld vertices | seconds | cpu s | scalar modes | variance "
        "explained | "
        "largest error | clipped mass |\n|---|---:|---:|---:|---:|---:|---:|\n",
        static_cast<long long>(mesh.vertices.rows()));
    for (const Candidate& candidate : candidates()) {
        ModelOptions options;
        options.kernels[0].kind = candidate.kind;
        if (candidate.kind == KernelKind::bspline) options.kernels[0].sigma_mm = 60;
        const double start = seconds(), cpu = cpu_seconds();
        const LowRankReport report = build_deformation_model(mesh, {}, {}, options, context).report;
        std::printf("| %s | %.2f | %.2f | %lld | %.4f | %.3f | %.2e |\n",
                    kernel_name(candidate.kind), seconds() - start, cpu_seconds() - cpu,
                    static_cast<long long>(report.rank), report.variance_explained,
                    report.max_variance_error, report.negative_mass);
        std::fflush(stdout);
    }
    std::printf("\npeak memory %ld MB\n", peak_megabytes());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: model_kernels TEMPLATE.ply FACES.safetensors\n");
        return 2;
    }
    try {
        ThreadPool pool(2);
        Context context;
        context.pool = &pool;
        const TriMesh mesh = read_mesh_file(argv[1], context);
        const FaceDataset faces = FaceDataset::open(argv[2], {}, context);
        costs(mesh, context);
        table(mesh, faces, context);
    } catch (const Error& error) {
        std::fprintf(stderr, "model_kernels: %s\n", error.what());
        return 1;
    }
    return 0;
}
