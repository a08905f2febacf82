#include "model/low_rank.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/symmetric_eigen.hpp"

namespace mien {
namespace {

void check(const RankOptions& options) {
    if (options.num_modes < 1)
        fail(Status::invalid_argument, "%lld scalar modes; a model needs at least 1 (3 modes)",
             static_cast<long long>(options.num_modes));
    if (!(options.tolerance >= 0 && options.tolerance < 1))
        fail(Status::invalid_argument, "variance tolerance %g is outside 0 .. 1",
             options.tolerance);
    if (!(options.threshold > 0 && options.threshold < 1))
        fail(Status::invalid_argument, "eigenvalue threshold %g is outside 0 .. 1",
             options.threshold);
}

}  // namespace

LowRankBasis principal_basis(const Matrix& factor, const Vector& diagonal,
                             const RankOptions& options, const Context& context) {
    check(options);
    const Index n = factor.rows(), q = factor.cols();
    Matrix gram(q, q);
    dense::weighted_gram(context, factor, Vector(), gram);
    context.progress(Stage::basis, 0.7);
    const SymmetricSpectrum spectrum(gram, "the kernel's modes", context);
    const Vector& values = spectrum.values();
    context.progress(Stage::basis, 0.85);

    const double total = diagonal.sum();
    // Directions that are nothing but rounding.
    const double least = values[q - 1] * 1e-12;
    Index rank = 0;
    double explained = 0;
    while (rank < std::min(options.num_modes, q) && values[q - 1 - rank] > least) {
        explained += values[q - 1 - rank];
        ++rank;
        if (options.tolerance > 0 && explained >= (1 - options.tolerance) * total) break;
    }
    if (rank == 0) fail(Status::no_solution, "the kernel is zero on this template");

    LowRankBasis result;
    Matrix basis(n, rank);
    const Matrix head = spectrum.strongest(rank, context).rowwise().reverse();
    dense::multiply(context, 1.0, factor, dense::Op::none, head, dense::Op::none, 0.0, basis);
    result.eigenvalues.resize(rank);
    for (Index j = 0; j < rank; ++j) {
        Index largest = 0;
        basis.col(j).cwiseAbs().maxCoeff(&largest);
        if (basis(largest, j) < 0) basis.col(j) = -basis.col(j);
        result.eigenvalues[j] = values[q - 1 - j] / static_cast<double>(n);
    }
    const Vector captured = basis.rowwise().squaredNorm();
    result.report.rank = rank;
    result.report.variance_explained = captured.sum() / total;
    result.report.max_variance_error =
        (captured - diagonal).cwiseAbs().maxCoeff() / diagonal.maxCoeff();
    result.basis = basis.cast<float>();
    if (!result.basis.allFinite())
        fail(Status::no_solution,
             "the deformation basis is not finite; check the template's units");
    context.progress(Stage::basis, 1);
    return result;
}

Matrix nystrom_factor(Matrix& columns, const std::vector<std::uint32_t>& control_points,
                      const RankOptions& options, LowRankReport& report, const Context& context) {
    check(options);
    const Index m = columns.cols();
    Matrix block(m, m);
    for (Index i = 0; i < m; ++i)
        block.row(i) = columns.row(control_points[static_cast<std::size_t>(i)]);
    block = (0.5 * (block + block.transpose())).eval();
    context.progress(Stage::basis, 0.1);
    const SymmetricSpectrum spectrum(block, "the kernel's block of control points", context);
    const Vector& values = spectrum.values();
    context.progress(Stage::basis, 0.3);

    const double largest = values[m - 1];
    if (!(largest > 0)) fail(Status::no_solution, "the kernel is zero on this template");
    report.num_control_points = m;
    report.smallest_eigenvalue = values[0] / largest;
    double mass = 0, negative = 0;
    Index kept = 0;
    for (Index j = 0; j < m; ++j) {
        mass += std::abs(values[j]);
        // Rounding of single precision distances, not of the kernel.
        if (values[j] < -1e-7 * largest) {
            negative -= values[j];
            ++report.num_negative;
        }
        if (values[j] > options.threshold * largest) ++kept;
    }
    report.negative_mass = negative / mass;
    Matrix right = spectrum.strongest(kept, context) *
                   values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
    Matrix factor(columns.rows(), kept);
    dense::multiply(context, 1.0, columns, dense::Op::none, right, dense::Op::none, 0.0, factor);
    columns.resize(0, 0);
    context.progress(Stage::basis, 0.5);
    return factor;
}

}  // namespace mien
