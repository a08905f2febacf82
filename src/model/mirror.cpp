#include "model/mirror.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

double mean_edge(const TriMesh& mesh) {
    double sum = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.vertices.row(mesh.triangles(t, k)) -
                    mesh.vertices.row(mesh.triangles(t, (k + 1) % 3)))
                       .norm();
    return sum / std::max<double>(1.0, 3.0 * static_cast<double>(mesh.triangles.rows()));
}

}  // namespace

std::vector<std::uint32_t> mirror_map(const TriMesh& mesh, const Context& context) {
    const Index n = mesh.vertices.rows();
    const double reach = mean_edge(mesh);
    // In cells of y and z as wide as the reach, sorted: only vertices of the cells about an image
    // are looked at.
    const auto cell = [&](double place) {
        constexpr double kMost = 1e9;  // a template without edges has cells of no width
        return static_cast<std::int64_t>(std::floor(std::clamp(place / reach, -kMost, kMost)));
    };
    struct Entry {
        std::int64_t y, z;
        std::uint32_t vertex;
        bool operator<(const Entry& other) const {
            return std::tie(y, z, vertex) < std::tie(other.y, other.z, other.vertex);
        }
    };
    std::vector<Entry> entries;
    for (Index v = 0; v < n; ++v)
        entries.push_back(
            {cell(mesh.vertices(v, 1)), cell(mesh.vertices(v, 2)), static_cast<std::uint32_t>(v)});
    std::sort(entries.begin(), entries.end());
    std::vector<std::uint32_t> mirror(static_cast<std::size_t>(n));
    const auto find = [&](Index v) {
        const Eigen::RowVector3d image(-mesh.vertices(v, 0), mesh.vertices(v, 1),
                                       mesh.vertices(v, 2));
        double best = reach * reach;
        bool found = false;
        const auto look_at = [&](std::uint32_t other) {
            const double squared = (mesh.vertices.row(other) - image).squaredNorm();
            if (squared < best ||
                (squared == best && found && other < mirror[static_cast<std::size_t>(v)])) {
                best = squared;
                mirror[static_cast<std::size_t>(v)] = other;
                found = true;
            }
        };
        const std::int64_t y = cell(image[1]), z = cell(image[2]);
        for (std::int64_t row = y - 1; row <= y + 1; ++row)
            for (auto at = std::lower_bound(entries.begin(), entries.end(), Entry{row, z - 1, 0});
                 at != entries.end() && at->y == row && at->z <= z + 1; ++at)
                look_at(at->vertex);
        if (!found)
            fail_at(Status::invalid_mesh, v,
                    "the template is not symmetric about x = 0: no vertex within %.3g mm of the "
                    "mirror image of vertex %lld; build without mirror symmetry",
                    reach, static_cast<long long>(v));
    };
    parallel_for(context, mirror.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) find(static_cast<Index>(v));
    });
    for (std::size_t v = 0; v < mirror.size(); ++v)
        if (mirror[mirror[v]] != v)
            fail_at(
                Status::invalid_mesh, static_cast<std::int64_t>(v),
                "the template is not symmetric about x = 0: vertices %zu and %lld do not mirror "
                "each other; build without mirror symmetry",
                v, static_cast<long long>(mirror[v]));
    return mirror;
}

namespace {

/// The even (sign 1) or odd (sign -1) part of functions on the template: one row for each pair of
/// vertices, times the root of two, so that products of columns are those of whole functions.
class HalfFace {
  public:
    HalfFace(const std::vector<std::uint32_t>& mirror, double sign) : mirror_(mirror), sign_(sign) {
        for (std::size_t v = 0; v < mirror.size(); ++v)
            if (mirror[v] >= v) first_.push_back(static_cast<Index>(v));
    }

    /// Without columns that have nothing but rounding of this parity.
    Matrix part_of(const Matrix& functions) const {
        const auto rows = static_cast<Index>(first_.size());
        Matrix half(rows, functions.cols());
        Index kept = 0;
        for (Index j = 0; j < functions.cols(); ++j) {
            for (Index i = 0; i < rows; ++i) {
                const Index v = first_[static_cast<std::size_t>(i)];
                half(i, kept) =
                    0.5 * weight(v) * (functions(v, j) + sign_ * functions(image(v), j));
            }
            const double least = kRounding * kRounding * functions.col(j).squaredNorm();
            if (half.col(kept).squaredNorm() > least) ++kept;
        }
        half.conservativeResize(rows, kept);
        return half;
    }

    Eigen::MatrixXf whole(const Eigen::MatrixXf& half) const {
        Eigen::MatrixXf result(static_cast<Index>(mirror_.size()), half.cols());
        for (Index j = 0; j < half.cols(); ++j)
            for (std::size_t i = 0; i < first_.size(); ++i) {
                const Index v = first_[i];
                const auto value = static_cast<float>(half(static_cast<Index>(i), j) / weight(v));
                result(image(v), j) = static_cast<float>(sign_) * value;
                result(v, j) = value;
            }
        return result;
    }

  private:
    static constexpr double kRounding = 1e-10;  // of a column's norm
    Index image(Index v) const { return mirror_[static_cast<std::size_t>(v)]; }
    double weight(Index v) const { return image(v) == v ? 1.0 : std::sqrt(2.0); }

    const std::vector<std::uint32_t>& mirror_;
    double sign_;
    std::vector<Index> first_;  // of each pair, and the vertices of the plane
};

}  // namespace

LowRankBasis mirrored_basis(const Matrix& factor, const Vector& diagonal,
                            const std::vector<std::uint32_t>& mirror, const RankOptions& options,
                            const Context& context) {
    // Each part is cut at the full rank first; the tolerance applies to both together.
    RankOptions full = options;
    full.tolerance = 0;
    LowRankBasis parts[2];
    for (int odd = 0; odd < 2; ++odd) {
        const HalfFace face(mirror, odd == 0 ? 1 : -1);
        const Matrix half = face.part_of(factor);
        if (half.cols() == 0) continue;
        parts[odd] = principal_basis(half, Vector::Ones(half.rows()), full, context);
        parts[odd].basis = face.whole(parts[odd].basis);
        parts[odd].eigenvalues *=
            static_cast<double>(half.rows()) / static_cast<double>(factor.rows());
    }
    struct Column {
        double value;
        int part;
        Index index;
    };
    std::vector<Column> columns;
    for (int part = 0; part < 2; ++part)
        for (Index j = 0; j < parts[part].eigenvalues.size(); ++j)
            columns.push_back({parts[part].eigenvalues[j], part, j});
    std::stable_sort(columns.begin(), columns.end(),
                     [](const Column& a, const Column& b) { return a.value > b.value; });
    const double total = diagonal.mean();
    std::size_t rank = 0;
    double explained = 0;
    while (rank < columns.size() && static_cast<Index>(rank) < options.num_modes) {
        explained += columns[rank++].value;
        if (options.tolerance > 0 && explained >= (1 - options.tolerance) * total) break;
    }
    LowRankBasis merged;
    merged.basis.resize(factor.rows(), static_cast<Index>(rank));
    merged.eigenvalues.resize(static_cast<Index>(rank));
    for (std::size_t j = 0; j < rank; ++j) {
        merged.basis.col(static_cast<Index>(j)) =
            parts[columns[j].part].basis.col(columns[j].index);
        merged.eigenvalues[static_cast<Index>(j)] = columns[j].value;
        merged.parity.push_back(columns[j].part == 0 ? 1 : -1);
    }
    const Vector captured = merged.basis.cast<double>().rowwise().squaredNorm();
    merged.report.rank = static_cast<Index>(rank);
    merged.report.variance_explained = captured.sum() / diagonal.sum();
    merged.report.max_variance_error =
        (captured - diagonal).cwiseAbs().maxCoeff() / diagonal.maxCoeff();
    return merged;
}

Matrix mirrored_prior_variance(const std::vector<std::int8_t>& parity, double correlation) {
    Matrix variance(static_cast<Index>(parity.size()), 3);
    for (std::size_t j = 0; j < parity.size(); ++j) {
        const double odd_axis = parity[j] < 0 ? 1 + correlation : 1 - correlation;
        const double even_axis = parity[j] > 0 ? 1 + correlation : 1 - correlation;
        variance.row(static_cast<Index>(j)) << odd_axis, even_axis, even_axis;
    }
    return variance;
}

}  // namespace mien
