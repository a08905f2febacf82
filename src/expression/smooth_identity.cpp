#include "expression/smooth_identity.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "expression/joint_pca.hpp"

namespace mien {
namespace {

constexpr double kLeastShare = 1e-6;  ///< of the strongest direction: weaker ones are rounding
/// Of the strongest direction across the people's modes. Weaker ones hardly matter to a fit, and
/// are turned by rounding: merged shards would have others than a single run.
constexpr double kLeastModeShare = 1e-3;
constexpr Index kBlock = 2048;  ///< vertices at a time

void check(const SmoothIdentityOptions& options) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    const auto not_negative = [](double value) { return value >= 0.0 && std::isfinite(value); };
    if (options.scales_mm.empty() || options.centres < 1 || options.modes < 0 ||
        !std::all_of(options.scales_mm.begin(), options.scales_mm.end(), positive) ||
        options.variances_mm2.empty() || !(options.least_gain >= 0.0) ||
        !(options.least_gain <= 1.0) ||
        !std::all_of(options.variances_mm2.begin(), options.variances_mm2.end(), not_negative))
        fail(Status::invalid_argument,
             "the smooth prior of the identity needs scales above 0 mm and variances that are not "
             "negative");
}

/// K between some vertices and the centres.
Matrix kernel(const Eigen::Ref<const Points>& vertices, const Points& centres,
              const std::vector<double>& scales_mm) {
    Matrix values = Matrix::Zero(vertices.rows(), centres.rows());
    for (Index j = 0; j < centres.rows(); ++j) {
        const Eigen::ArrayXd squares =
            (vertices.rowwise() - centres.row(j)).rowwise().squaredNorm();
        for (const double scale : scales_mm)
            values.col(j).array() +=
                (squares * (-0.5 / (scale * scale))).exp() / static_cast<double>(scales_mm.size());
    }
    return values;
}

}  // namespace

Matrix smooth_gram(const Context& context, const JointSpan& span,
                   const SmoothIdentityOptions& options) {
    check(options);
    const Index n = span.mean.size() / 3, r = span.basis.cols();
    const Eigen::Map<const Points> mean(span.mean.data(), n, 3);
    const Index step = std::max<Index>(1, n / options.centres);
    Points centres((n + step - 1) / step, 3);
    for (Index k = 0; k < centres.rows(); ++k) centres.row(k) = mean.row(k * step);

    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(kernel(centres, centres, options.scales_mm));
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the smooth prior of the identity has no directions");
    const Vector& values = eigen.eigenvalues();
    const Index kept = (values.array() > kLeastShare * values.maxCoeff()).count();
    const Matrix whitened = eigen.eigenvectors().rightCols(kept) *
                            values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();

    std::vector<Matrix> projected(3, Matrix::Zero(kept, r));  // features' U, an axis each
    Matrix features, rows, part(kept, r);
    for (Index first = 0; first < n; first += kBlock) {
        context.check_cancelled();
        const Index size = std::min(kBlock, n - first);
        features = kernel(mean.middleRows(first, size), centres, options.scales_mm) * whitened;
        rows.resize(size, r);
        for (int axis = 0; axis < 3; ++axis) {
            for (Index i = 0; i < size; ++i) rows.row(i) = span.basis.row(3 * (first + i) + axis);
            dense::multiply(context, 1.0, features, dense::Op::transpose, rows, dense::Op::none,
                            0.0, part);
            projected[static_cast<std::size_t>(axis)] += part;
        }
    }
    Matrix gram = Matrix::Zero(r, r);
    for (const Matrix& axis : projected) gram += axis.transpose() * axis;
    return 0.5 * (gram + gram.transpose());
}

SmoothIdentity smooth_identity(const Matrix& identity, const Matrix& moved,
                               const Vector& deviations, const Matrix& gram, double variance,
                               Index most_modes) {
    const Index r = identity.rows(), p = identity.cols();
    SmoothIdentity smooth;
    smooth.modes.resize(r, 0);
    smooth.covariance = deviations.array().square().matrix().asDiagonal();
    const Index most = std::min(most_modes, r - p);
    if (!(variance > 0.0) || most < 1) return smooth;
    const Matrix half = gram - identity * (identity.transpose() * gram);
    const Matrix across = half - (half * identity) * identity.transpose();
    Vector values;
    Matrix modes = leading_eigenvectors(0.5 * (across + across.transpose()), most, &values);
    Index kept = 0;
    while (kept < modes.cols() && values[kept] > kLeastModeShare * values[0]) ++kept;
    if (kept == 0) return smooth;
    smooth.modes = modes.leftCols(kept);

    // The coordinates of K's directions along (moved, modes): least squares.
    Matrix basis(r, p + kept);
    basis << moved, smooth.modes;
    const Eigen::LDLT<Matrix> factor(Matrix(basis.transpose() * basis));
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the identity's modes are not independent of each other");
    const Matrix inverse = factor.solve(basis.transpose());
    const Matrix own = variance * inverse * gram * inverse.transpose();
    Matrix covariance = 0.5 * (own + own.transpose());
    covariance.diagonal().head(p) += deviations.array().square().matrix();
    // Steadies directions that rounding alone determines.
    covariance.diagonal().array() += kLeastShare * covariance.diagonal().maxCoeff();
    smooth.covariance = std::move(covariance);
    return smooth;
}

}  // namespace mien
