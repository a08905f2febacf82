#include "registration/confidence.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/dense.hpp"
#include "base/parallel.hpp"

namespace mien {

Vector place_deviation(const DeformationModel& model, const FitState& state, const Vector& weight,
                       const PointsRef& normals_model, const std::vector<Pin>& pins,
                       const RegistrationOptions& options, const Context& context) {
    const Index n = model.num_vertices();
    const Index p = std::min<Index>(state.coefficients.pca.size(), 80);
    const Index r = std::min<Index>(state.coefficients.kernel.rows(), p > 0 ? 30 : 60);
    const Index q = p + 3 * r;
    const double ka = state.kernel_amplitude, pa = options.pca_amplitude;
    const auto block_of = [&](Index i, Eigen::Matrix<float, 3, Eigen::Dynamic>& block) {
        block.setZero(3, q);
        if (p > 0) block.leftCols(p) = static_cast<float>(pa) * model.pca_modes.map().block(3 * i, 0, 3, p);
        for (int axis = 0; axis < 3 && r > 0; ++axis) {
            block.row(axis).segment(p + axis * r, r) = static_cast<float>(ka) * model.basis.map().row(i).head(r);
            if (model.prior_variance.rows() >= r)
                block.row(axis).segment(p + axis * r, r).array() *=
                    model.prior_variance.col(axis).head(r).transpose().cast<float>().array().max(1e-4f).sqrt();
        }
    };

    // A few hundred places speak for the smooth modes: neighbours' errors are alike, so each of them counts
    // as one observation of the surface's plane, and not as one per vertex.
    const Index stride = std::max<Index>(1, n / 1500);
    std::vector<Index> rows;
    for (Index i = 0; i < n; i += stride)
        if (weight[i] > 0.05) rows.push_back(i);
    const double sigma = std::max(0.5, state.sigma_mm);
    Eigen::MatrixXf observed(static_cast<Index>(rows.size() + 3 * pins.size()), q);
    parallel_for(context, rows.size(), 128, [&](std::size_t begin, std::size_t end) {
        Eigen::Matrix<float, 3, Eigen::Dynamic> block;
        for (std::size_t k = begin; k < end; ++k) {
            block_of(rows[k], block);
            observed.row(static_cast<Index>(k)) = static_cast<float>(std::sqrt(weight[rows[k]]) / sigma) *
                                                  normals_model.row(rows[k]).cast<float>() * block;
        }
    });
    Eigen::Matrix<float, 3, Eigen::Dynamic> pin_block;
    for (std::size_t k = 0; k < pins.size(); ++k) {
        block_of(pins[k].vertex, pin_block);
        observed.middleRows(static_cast<Index>(rows.size() + 3 * k), 3) =
            pin_block / static_cast<float>(pins[k].sigma_mm);
    }
    Eigen::MatrixXf information(q, q);
    Vector deviation = Vector::Zero(n);
    Eigen::LLT<Eigen::MatrixXf> factor;
    if (q > 0) {
        dense::weighted_gram(context, observed, Eigen::VectorXf(), information);
        information.diagonal().array() += 1.0f;
        factor.compute(information);
        if (factor.info() != Eigen::Success) return Vector::Constant(n, 10.0);
    }
    // What the formula leaves out: hits that slide together, noise that is not independent, faces outside the
    // training span, and, away from the scan, all that no observation checks. The factors were set on scans of
    // other people than those that the tables are made with, so that the 95 % radius holds nine of ten or more.
    const double beside = p > 0 ? 2.3 : 1.7, away = p > 0 ? 4.0 : 3.15;
    parallel_for(context, static_cast<std::size_t>(n), 256, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
        Eigen::MatrixXf columns(q, 3 * count);
        Eigen::Matrix<float, 3, Eigen::Dynamic> block;
        for (Index i = 0; i < count; ++i) {
            block_of(first + i, block);
            columns.middleCols(3 * i, 3) = block.transpose();
        }
        if (q > 0) factor.matrixL().solveInPlace(columns);
        for (Index i = 0; i < count; ++i) {
            const Index v = first + i;
            double variance = q > 0 ? columns.middleCols(3 * i, 3).squaredNorm() : 0;
            double left_out = 0;
            if (state.coefficients.kernel.rows() > r)
                left_out += 3 * ka * ka *
                            static_cast<double>(model.basis.map().row(v).segment(r, state.coefficients.kernel.rows() - r).squaredNorm());
            if (state.coefficients.pca.size() > p)
                left_out += pa * pa * static_cast<double>(
                    model.pca_modes.map().block(3 * v, p, 3, state.coefficients.pca.size() - p).squaredNorm());
            // Beside the scan, the surface tells one of three axes and its curvature a part of the others.
            const double seen = std::min(1.0, std::max(0.0, weight[v]));
            variance += left_out * (1 - 0.7 * seen);
            deviation[v] = (beside * seen + away * (1 - seen)) * std::sqrt(variance / 3);
        }
    });
    return deviation;
}

}  // namespace mien
