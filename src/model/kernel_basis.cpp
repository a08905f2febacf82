#include "model/kernel_basis.hpp"

#include <algorithm>
#include <cmath>

#include "model/mirror.hpp"

namespace mien {
namespace {

constexpr Index kControlPoints = 1000;

bool spectral_only(const std::vector<KernelTerm>& terms) {
    return std::all_of(terms.begin(), terms.end(), [](const KernelTerm& term) {
        return term.kind == KernelKind::surface_matern;
    });
}

/// K = factor factor' for Matern terms: eigenvectors times deviations.
Matrix spectral_factor(const KernelBlocks& blocks, const std::vector<KernelTerm>& terms) {
    Vector variances = Vector::Zero(blocks.eigenpairs().values.size());
    for (const KernelTerm& term : terms)
        variances += matern_spectrum(blocks.eigenpairs().values, blocks.area_mm2(), term).variances;
    return blocks.eigenpairs().vectors * variances.cwiseSqrt().asDiagonal();
}

/// k(x, x) including what the computed eigenpairs leave out, spread evenly over the surface.
Vector full_diagonal(const KernelBlocks& blocks, const std::vector<KernelTerm>& terms) {
    Vector diagonal = blocks.diagonal(terms);
    for (const KernelTerm& term : terms)
        if (term.kind == KernelKind::surface_matern)
            diagonal.array() +=
                matern_spectrum(blocks.eigenpairs().values, blocks.area_mm2(), term).tail *
                term.scale_mm * term.scale_mm;
    return diagonal;
}

}  // namespace

KernelBlocks prepare_kernel_blocks(const TriMesh& mesh, const std::vector<KernelTerm>& terms,
                                   Index num_modes, Index num_control_points,
                                   const HeatOptions& heat, const Context& context) {
    const Index n = mesh.vertices.rows();
    const Index wanted =
        num_control_points != 0 ? num_control_points : std::max(kControlPoints, 3 * num_modes);
    const Index count = std::min(wanted, n);
    // Two matrices of doubles, and little beside them: 17 bytes were measured.
    constexpr std::size_t kBytes = 18;
    context.require_memory(static_cast<std::size_t>(n) * static_cast<std::size_t>(count) * kBytes,
                           "building a deformation model");
    std::vector<std::uint32_t> control;
    if (!spectral_only(terms)) control = farthest_points(mesh.vertices, mesh.triangles, count);
    // Twice as many pairs as modes: eigenfunctions spread their detail evenly over the area, the
    // modes that are kept put it where the vertices are. On faces that is worth a tenth of the
    // residual.
    const Index num_pairs = 2 * num_modes + 1;
    return KernelBlocks(mesh, std::move(control), terms, num_pairs, heat, context);
}

LowRankBasis kernel_basis(const KernelBlocks& blocks, const std::vector<KernelTerm>& terms,
                          const RankOptions& rank, const Vector& scale_per_vertex,
                          const Context& context, const std::vector<std::uint32_t>* mirror) {
    context.progress(Stage::basis, 0);
    Vector diagonal = full_diagonal(blocks, terms);
    LowRankReport report;
    Matrix factor;
    if (spectral_only(terms)) {
        factor = spectral_factor(blocks, terms);
    } else {
        blocks.evaluate(terms, factor, context);
        factor = nystrom_factor(factor, blocks.control_points(), rank, report, context);
        // An indefinite kernel that was clipped has too much variance in places; correlations stay.
        if (report.num_negative != 0)
            for (Index v = 0; v < factor.rows(); ++v) {
                const double captured = factor.row(v).squaredNorm();
                if (captured > diagonal[v]) factor.row(v) *= std::sqrt(diagonal[v] / captured);
            }
    }
    if (scale_per_vertex.size() != 0) {
        factor = (scale_per_vertex.asDiagonal() * factor).eval();
        diagonal.array() *= scale_per_vertex.array().square();
    }
    LowRankBasis result = mirror != nullptr
                              ? mirrored_basis(factor, diagonal, *mirror, rank, context)
                              : principal_basis(factor, diagonal, rank, context);
    report.rank = result.report.rank;
    report.variance_explained = result.report.variance_explained;
    report.max_variance_error = result.report.max_variance_error;
    result.report = report;
    return result;
}

}  // namespace mien
