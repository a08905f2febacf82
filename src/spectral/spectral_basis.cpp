// Departures from kosk-2024: the Laplacian is positive semidefinite (4.10 has the other sign) and
// without its factor 2; bands are of displacements from the mean in millimetres.
#include "spectral/spectral_basis.hpp"

#include <algorithm>
#include <cstring>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/spectrum.hpp"

namespace mien {
namespace {

constexpr std::size_t kRows = 512;  // of one chunk; fixed, so that sums have the same bits

void check_field(const SpectralBasis& basis, const PointsRef& field, Index count) {
    if (field.rows() != basis.num_vertices())
        fail(Status::mismatch, "a face with %lld vertices for a spectral basis with %lld",
             static_cast<long long>(field.rows()), static_cast<long long>(basis.num_vertices()));
    if (count < 0 || count > basis.num_modes())
        fail(Status::invalid_argument, "%lld modes of a spectral basis with %lld",
             static_cast<long long>(count), static_cast<long long>(basis.num_modes()));
    for (Index v = 0; v < field.rows(); ++v)
        if (!field.row(v).allFinite())
            fail_at(Status::invalid_mesh, v, "vertex %lld of the face is not finite",
                    static_cast<long long>(v));
}

void check_limits(const SpectralBasis& basis, const std::vector<Index>& limits) {
    Index previous = 0;
    for (const Index limit : limits) {
        if (limit <= previous || limit > basis.num_modes())
            fail(Status::invalid_argument,
                 "band limit %lld after %lld: limits ascend from 1 to the basis' %lld modes",
                 static_cast<long long>(limit), static_cast<long long>(previous),
                 static_cast<long long>(basis.num_modes()));
        previous = limit;
    }
}

// The transposed matrix of `count` modes from `first` on.
Eigen::Map<const Matrix, 0, Eigen::OuterStride<>> modes_of(const SpectralBasis& basis, Index first,
                                                           Index count) {
    return {basis.vectors + first, count, basis.num_vertices(),
            Eigen::OuterStride<>(basis.num_modes())};
}

const char* name_of(MassKind kind) {
    return kind == MassKind::barycentric ? "barycentric" : "mixed_voronoi";
}
const char* name_of(NegativeCotangents kind) {
    return kind == NegativeCotangents::keep    ? "keep"
           : kind == NegativeCotangents::clamp ? "clamp"
                                               : "intrinsic_delaunay";
}

}  // namespace

std::shared_ptr<const SpectralBasis> build_spectral_basis(const TriMesh& mean_mesh,
                                                          const SpectralBasisOptions& options,
                                                          const Context& context) {
    check_mesh(mean_mesh, "the mean shape");
    const Index n = mean_mesh.vertices.rows(), k = options.num_modes;
    if (k < 1 || k >= n)
        fail(Status::invalid_argument, "%lld spectral modes of a mesh with %lld vertices",
             static_cast<long long>(k), static_cast<long long>(n));
    context.progress(Stage::basis, 0.0);
    LaplaceOperator laplace =
        build_laplacian(mean_mesh.vertices, mean_mesh.triangles, options.laplacian);
    if (!options.with_mass) laplace.mass.setOnes();
    EigenPairs pairs = smallest_eigenpairs(
        laplace, k, context, [&](double share) { context.progress(Stage::basis, 0.95 * share); });

    auto basis = std::make_shared<SpectralBasis>();
    basis->mean_mesh.vertices = mean_mesh.vertices;
    basis->mean_mesh.triangles = mean_mesh.triangles;
    basis->values = std::move(pairs.values);
    basis->mass = std::move(laplace.mass);
    basis->mass_kind = options.with_mass ? name_of(options.laplacian.mass) : "none";
    basis->negative_kind = name_of(options.laplacian.negative);
    auto rows = std::make_shared<std::vector<double>>(static_cast<std::size_t>(n * k));
    parallel_for(context, static_cast<std::size_t>(n), kRows,
                 [&](std::size_t begin, std::size_t end) {
                     for (Index c = 0; c < k; ++c)
                         for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
                             (*rows)[static_cast<std::size_t>(v * k + c)] = pairs.vectors(v, c);
                 });
    basis->vectors = rows->data();
    basis->storage = rows;
    context.progress(Stage::basis, 1.0);
    return basis;
}

std::shared_ptr<const SpectralBasis> load_spectral_basis(const std::string& path,
                                                         const SafetensorsReadOptions& options,
                                                         const Context& context) {
    const SafetensorsFile file = SafetensorsFile::open(path, options, context);
    file.require_kind("mien-spectral-basis");
    const TensorView& mean = file.tensor("mean", DType::f64, {-1, 3});
    const auto n = static_cast<std::int64_t>(mean.shape[0]);
    const TensorView& vectors = file.tensor("vectors", DType::f64, {n, -1});
    const auto k = static_cast<std::int64_t>(vectors.shape[1]);
    const TensorView& triangles = file.tensor("triangles", DType::u32, {-1, 3});
    auto basis = std::make_shared<SpectralBasis>();
    basis->mean_mesh.vertices =
        Eigen::Map<const Points>(static_cast<const double*>(mean.data), n, 3);
    basis->mean_mesh.triangles =
        Eigen::Map<const Triangles>(static_cast<const std::uint32_t*>(triangles.data),
                                    static_cast<Index>(triangles.shape[0]), 3);
    check_mesh(basis->mean_mesh, "the spectral basis' mean shape");
    basis->values = Eigen::Map<const Vector>(
        static_cast<const double*>(file.tensor("values", DType::f64, {k}).data), k);
    basis->mass = Eigen::Map<const Vector>(
        static_cast<const double*>(file.tensor("mass", DType::f64, {n}).data), n);
    if (k < 1 || !(basis->mass.minCoeff() > 0))
        fail(Status::bad_format,
             "a spectral basis file without modes or with a mass that is not positive");
    basis->vectors = static_cast<const double*>(vectors.data);
    basis->storage = file.storage();
    basis->mass_kind = file.metadata("mass");
    basis->negative_kind = file.metadata("negative_cotangents");
    return basis;
}

void save_spectral_basis(const std::string& path, const SpectralBasis& basis,
                         const Context& context) {
    const auto n = static_cast<std::uint64_t>(basis.num_vertices());
    const auto k = static_cast<std::uint64_t>(basis.num_modes());
    const auto m = static_cast<std::uint64_t>(basis.mean_mesh.triangles.rows());
    write_safetensors(path,
                      {{"vectors", DType::f64, {n, k}, basis.vectors},
                       {"values", DType::f64, {k}, basis.values.data()},
                       {"mass", DType::f64, {n}, basis.mass.data()},
                       {"mean", DType::f64, {n, 3}, basis.mean_mesh.vertices.data()},
                       {"triangles", DType::u32, {m, 3}, basis.mean_mesh.triangles.data()}},
                      {{"kind", "mien-spectral-basis"},
                       {"units", "millimetres"},
                       {"mass", basis.mass_kind},
                       {"negative_cotangents", basis.negative_kind}},
                      context);
}

Matrix project(const SpectralBasis& basis, const PointsRef& field, Index count,
               const Context& context) {
    check_field(basis, field, count);
    Matrix coefficients;
    dense::project_rows(context, modes_of(basis, 0, count), basis.mass.asDiagonal() * field,
                        coefficients);
    return coefficients;
}

Points synthesise(const SpectralBasis& basis, const Matrix& coefficients, Index first,
                  const Context& context) {
    const Index k = basis.num_modes(), count = coefficients.rows();
    if (first < 0 || first + count > k || (count > 0 && coefficients.cols() != 3))
        fail(Status::invalid_argument,
             "%lld coefficients from mode %lld of a basis with %lld modes",
             static_cast<long long>(count), static_cast<long long>(first),
             static_cast<long long>(k));
    Points field;
    dense::expand_rows(context, modes_of(basis, first, count), coefficients, field);
    return field;
}

std::vector<Points> split_bands(const SpectralBasis& basis, const PointsRef& face,
                                const std::vector<Index>& limits, const Context& context) {
    check_limits(basis, limits);
    check_field(basis, face, 0);
    Points rest = face - basis.mean_mesh.vertices;
    std::vector<Points> bands;
    const Index last = limits.empty() ? 0 : limits.back();
    const Matrix coefficients = project(basis, rest, last, context);
    Index first = 0;
    for (const Index limit : limits) {
        bands.push_back(
            synthesise(basis, coefficients.middleRows(first, limit - first), first, context));
        rest -= bands.back();
        first = limit;
    }
    bands.push_back(std::move(rest));
    return bands;
}

Points merge_bands(const SpectralBasis& basis, const std::vector<Points>& bands,
                   const std::vector<Index>& limits, const Context& context) {
    check_limits(basis, limits);
    if (bands.size() != limits.size() + 1)
        fail(Status::invalid_argument, "%zu bands for %zu band limits", bands.size(),
             limits.size());
    Points face = basis.mean_mesh.vertices;
    const Index last = limits.empty() ? 0 : limits.back();
    Matrix kept(last, 3);
    Index first = 0;
    for (std::size_t b = 0; b < limits.size(); ++b) {
        const Matrix all = project(basis, bands[b], limits[b], context);
        kept.middleRows(first, limits[b] - first) = all.bottomRows(limits[b] - first);
        first = limits[b];
    }
    check_field(basis, bands.back(), 0);
    // One synthesis for all: U (kept - U' M high) + high.
    kept -= project(basis, bands.back(), last, context);
    face += bands.back();
    face += synthesise(basis, kept, 0, context);
    return face;
}

Points low_band(const SpectralBasis& basis, const PointsRef& face, Index k,
                const Context& context) {
    check_field(basis, face, k);
    const Points displacement = face - basis.mean_mesh.vertices;
    return synthesise(basis, project(basis, displacement, k, context), 0, context) +
           basis.mean_mesh.vertices;
}

Points high_band(const SpectralBasis& basis, const PointsRef& face, Index k,
                 const Context& context) {
    check_field(basis, face, k);
    const Points displacement = face - basis.mean_mesh.vertices;
    return face - synthesise(basis, project(basis, displacement, k, context), 0, context);
}

Points assemble(const SpectralBasis& basis, const PointsRef& low, const PointsRef& high, Index k,
                const Context& context) {
    if (low.rows() != basis.num_vertices())
        fail(Status::mismatch, "a low band with %lld vertices for a basis with %lld",
             static_cast<long long>(low.rows()), static_cast<long long>(basis.num_vertices()));
    if (k >= basis.num_vertices()) return low;
    check_field(basis, high, k);
    // X low + (I - X) high = high + X (low - high): one projection, one synthesis.
    const Points difference = low - high;
    return high + synthesise(basis, project(basis, difference, k, context), 0, context);
}

Points edit_bands(const SpectralBasis& basis, const PointsRef& face,
                  const std::vector<Index>& limits, const Vector& gains, const Context& context) {
    check_limits(basis, limits);
    check_field(basis, face, 0);
    if (gains.size() != static_cast<Index>(limits.size()) + 1 || !gains.allFinite())
        fail(Status::invalid_argument, "%lld finite gains for %zu bands",
             static_cast<long long>(gains.size()), limits.size() + 1);
    const Points displacement = face - basis.mean_mesh.vertices;
    const Index last = limits.empty() ? 0 : limits.back();
    Matrix coefficients = project(basis, displacement, last, context);
    const double rest = gains[gains.size() - 1];
    Index first = 0;
    for (std::size_t b = 0; b < limits.size(); ++b) {
        coefficients.middleRows(first, limits[b] - first) *= gains[static_cast<Index>(b)] - rest;
        first = limits[b];
    }
    return basis.mean_mesh.vertices + rest * displacement +
           synthesise(basis, coefficients, 0, context);
}

Points mix_bands(const SpectralBasis& basis, const PointsRef& a, const PointsRef& b,
                 const std::vector<Index>& limits, const Vector& weights, const Context& context) {
    check_field(basis, a, 0);
    check_field(basis, b, 0);
    // Bands of b - a, weighted, on top of a.
    const Points from_mean = basis.mean_mesh.vertices + (b - a);
    return a + (edit_bands(basis, from_mean, limits, weights, context) - basis.mean_mesh.vertices);
}

}  // namespace mien
