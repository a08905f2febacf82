#include "model/kernel_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <queue>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"
#include "mesh/shortest_paths.hpp"

namespace mien {
namespace {

constexpr std::size_t kColumnChunk = 16;

/// The mean over a grid cell of sum_k b3(x - k)^2, per axis.
constexpr double kMeanSquaredSpline = 151.0 / 315.0;

/// Values of the four splines that are not zero at one coordinate.
struct SplineSupport {
    int first = 0;
    std::array<double, 4> value{};
};

SplineSupport spline_support(double coordinate, double step) {
    const double x = coordinate / step;
    SplineSupport support;
    support.first = static_cast<int>(std::floor(x)) - 1;
    for (int k = 0; k < 4; ++k)
        support.value[static_cast<std::size_t>(k)] = cubic_bspline(x - (support.first + k));
    return support;
}

double spline_product(const SplineSupport& a, const SplineSupport& b) {
    const int shift = b.first - a.first;
    double sum = 0;
    for (int k = std::max(0, shift); k < std::min(4, shift + 4); ++k)
        sum += a.value[static_cast<std::size_t>(k)] * b.value[static_cast<std::size_t>(k - shift)];
    return sum;
}

/// (2.15): the sum over a lattice in space falls apart into one sum per axis.
class SplineKernel {
  public:
    SplineKernel(const PointsRef& vertices, const KernelTerm& term)
        : supports_(static_cast<std::size_t>(vertices.rows())),
          factor_(std::pow(term.scale_mm, 2) / std::pow(kMeanSquaredSpline, 3)) {
        const double step = term.sigma_mm / 4;
        const double most = vertices.cwiseAbs().maxCoeff() / step;
        if (!(most < 1e8))
            fail(Status::invalid_argument, "B-spline sigma %g mm is too small for this template",
                 term.sigma_mm);
        for (std::size_t v = 0; v < supports_.size(); ++v)
            for (int axis = 0; axis < 3; ++axis)
                supports_[v][static_cast<std::size_t>(axis)] =
                    spline_support(vertices(static_cast<Index>(v), axis), step);
    }
    double operator()(std::size_t a, std::size_t b) const {
        double product = factor_;
        for (std::size_t axis = 0; axis < 3 && product != 0; ++axis)
            product *= spline_product(supports_[a][axis], supports_[b][axis]);
        return product;
    }

  private:
    std::vector<std::array<SplineSupport, 3>> supports_;
    double factor_;
};

double surface_area(const TriMesh& mesh) {
    return 0.5 * triangle_normals(mesh.vertices, mesh.triangles).rowwise().norm().sum();
}

}  // namespace

std::vector<std::uint32_t> farthest_points(const PointsRef& vertices, const TrianglesRef& triangles,
                                           Index count) {
    const auto n = static_cast<std::size_t>(vertices.rows());
    count = std::min<Index>(count, vertices.rows());
    const PathGraph graph = build_path_graph(vertices, build_rings(vertices.rows(), triangles));
    const Eigen::RowVector3d centroid = vertices.colwise().mean();
    Index start = 0;
    (vertices.rowwise() - centroid).rowwise().squaredNorm().maxCoeff(&start);

    std::vector<double> distance(n, std::numeric_limits<double>::infinity());
    std::vector<std::uint32_t> chosen;
    using Entry = std::pair<double, std::uint32_t>;  // (distance, vertex)
    // Candidates by distance; stale entries are skipped when they come up.
    const auto nearer = [](const Entry& a, const Entry& b) {
        return a.first != b.first ? a.first < b.first : a.second > b.second;
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(nearer)> farthest(nearer);
    for (std::size_t v = 0; v < n; ++v)
        farthest.emplace(distance[v], static_cast<std::uint32_t>(v));
    auto next = static_cast<std::uint32_t>(start);
    while (static_cast<Index>(chosen.size()) < count) {
        chosen.push_back(next);
        walk_paths(graph, {next}, std::numeric_limits<double>::infinity(), distance,
                   [&](const ReachedVertex& at) { farthest.emplace(at.path, at.vertex); });
        while (!farthest.empty() && farthest.top().first != distance[farthest.top().second])
            farthest.pop();
        // Only points already chosen are left: duplicates at distance zero would add nothing.
        if (farthest.empty() || farthest.top().first == 0) break;
        next = farthest.top().second;
    }
    return chosen;
}

MaternSpectrum matern_spectrum(const Vector& laplace_eigenvalues, double area_mm2,
                               const KernelTerm& term) {
    const double kappa_squared = 2 * term.nu / (term.sigma_mm * term.sigma_mm);
    MaternSpectrum spectrum;
    // Relative to kappa^2, so that no power over- or underflows.
    spectrum.variances =
        (1 + laplace_eigenvalues.array().max(0.0) / kappa_squared).pow(-(term.nu + 1)).matrix();
    const double last =
        1 + std::max(0.0, laplace_eigenvalues[laplace_eigenvalues.size() - 1]) / kappa_squared;
    const double beyond = area_mm2 * kappa_squared / (4 * kPi * term.nu) * std::pow(last, -term.nu);
    const double total = spectrum.variances.sum() + beyond;
    spectrum.tail = beyond / total;
    spectrum.variances *= term.scale_mm * term.scale_mm * area_mm2 / total;
    return spectrum;
}

KernelBlocks::KernelBlocks(const TriMesh& mesh, std::vector<std::uint32_t> control_points,
                           const std::vector<KernelTerm>& terms, Index num_pairs,
                           const HeatOptions& heat_options, const Context& context)
    : mesh_(mesh), control_points_(std::move(control_points)) {
    check_kernels(terms);
    bool geodesic = false, spectral = false;
    for (const KernelTerm& term : terms) {
        geodesic = geodesic || term.kind == KernelKind::geodesic_se;
        spectral = spectral || term.kind == KernelKind::surface_matern;
    }
    if ((geodesic || spectral) && mesh.triangles.rows() == 0)
        fail(Status::invalid_mesh, "kernel %s needs a template with triangles",
             geodesic ? "geodesic-se" : "surface-matern");
    area_mm2_ = surface_area(mesh);
    if (geodesic) {
        const HeatGeodesics heat(mesh.vertices, mesh.triangles, heat_options, context);
        geodesic_.resize(mesh.vertices.rows(), static_cast<Index>(control_points_.size()));
        // In a few steps, so that the host sees progress and can cancel.
        const std::size_t step = 128;
        for (std::size_t first = 0; first < control_points_.size(); first += step) {
            context.progress(Stage::geodesics, static_cast<double>(first) /
                                                   static_cast<double>(control_points_.size()));
            const std::size_t last = std::min(control_points_.size(), first + step);
            const std::vector<std::uint32_t> some(
                control_points_.begin() + static_cast<std::ptrdiff_t>(first),
                control_points_.begin() + static_cast<std::ptrdiff_t>(last));
            heat.distances(
                some,
                geodesic_.middleCols(static_cast<Index>(first), static_cast<Index>(last - first)),
                context);
        }
        make_symmetric(control_points_, geodesic_);
        context.progress(Stage::geodesics, 1);
    }
    if (spectral) {
        const LaplaceOperator laplace =
            build_laplacian(mesh.vertices, mesh.triangles, LaplacianOptions{});
        pairs_ =
            smallest_eigenpairs(laplace, std::min(num_pairs, mesh.vertices.rows() - 1), context,
                                [&](double share) { context.progress(Stage::geodesics, share); });
    }
}

void KernelBlocks::evaluate(const std::vector<KernelTerm>& terms, Matrix& values,
                            const Context& context) const {
    const Index n = mesh_.vertices.rows(), m = static_cast<Index>(control_points_.size());
    values.setZero(n, m);
    for (const KernelTerm& term : terms) {
        const double variance = term.scale_mm * term.scale_mm;
        const double fall = -0.5 / (term.sigma_mm * term.sigma_mm);
        const auto columns = [&](auto&& fill) {
            parallel_for(context, static_cast<std::size_t>(m), kColumnChunk,
                         [&](std::size_t begin, std::size_t end) {
                             for (std::size_t j = begin; j < end; ++j)
                                 fill(static_cast<Index>(j), control_points_[j]);
                         });
        };
        switch (term.kind) {
            case KernelKind::euclidean_se:
                columns([&](Index j, std::uint32_t control) {
                    const Eigen::RowVector3d centre = mesh_.vertices.row(control);
                    values.col(j).array() +=
                        variance *
                        (fall * (mesh_.vertices.rowwise() - centre).rowwise().squaredNorm().array())
                            .exp();
                });
                break;
            case KernelKind::geodesic_se:
                columns([&](Index j, std::uint32_t) {
                    values.col(j).array() +=
                        variance * (fall * geodesic_.col(j).cast<double>().array().square()).exp();
                });
                break;
            case KernelKind::bspline: {
                const SplineKernel spline(mesh_.vertices, term);
                columns([&](Index j, std::uint32_t control) {
                    for (Index v = 0; v < n; ++v)
                        values(v, j) += spline(static_cast<std::size_t>(v), control);
                });
                break;
            }
            case KernelKind::surface_matern: {
                const MaternSpectrum spectrum = matern_spectrum(pairs_.values, area_mm2_, term);
                Matrix right(m, pairs_.vectors.cols());
                for (Index j = 0; j < m; ++j)
                    right.row(j) = pairs_.vectors.row(control_points_[static_cast<std::size_t>(j)])
                                       .cwiseProduct(spectrum.variances.transpose());
                dense::multiply(context, 1.0, pairs_.vectors, dense::Op::none, right,
                                dense::Op::transpose, 1.0, values);
                break;
            }
        }
    }
}

Vector KernelBlocks::diagonal(const std::vector<KernelTerm>& terms) const {
    const Index n = mesh_.vertices.rows();
    Vector total = Vector::Zero(n);
    for (const KernelTerm& term : terms) {
        if (term.kind == KernelKind::bspline) {
            const SplineKernel spline(mesh_.vertices, term);
            for (Index v = 0; v < n; ++v)
                total[v] += spline(static_cast<std::size_t>(v), static_cast<std::size_t>(v));
        } else if (term.kind == KernelKind::surface_matern) {
            const MaternSpectrum spectrum = matern_spectrum(pairs_.values, area_mm2_, term);
            total += pairs_.vectors.cwiseAbs2() * spectrum.variances;
        } else {
            total.array() += term.scale_mm * term.scale_mm;
        }
    }
    return total;
}

}  // namespace mien
