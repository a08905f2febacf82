#include "registration/confidence.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

// Variance of each vertex, all axes together, that the modes keep: |L^-1 B_i|^2 for the factor L of
// their information.
Vector explained_variance(const Eigen::MatrixXf& factor, const Eigen::VectorXf& scale, Index p,
                          Index r, const DeformationModel& model, const Context& context) {
    const Index n = model.num_vertices(), q = factor.rows();
    Eigen::MatrixXf whitening = Eigen::MatrixXf::Identity(q, q);
    factor.triangularView<Eigen::Lower>().solveInPlace(whitening);
    whitening *= scale.asDiagonal();
    constexpr Index kBlock = 2048;
    Vector variance = Vector::Zero(n);
    Eigen::MatrixXf modes, whitened;
    for (Index first = 0; first < n; first += kBlock) {
        context.check_cancelled();
        const Index count = std::min(kBlock, n - first);
        for (int axis = 0; axis < 3; ++axis) {
            whitened.setZero(q, count);
            if (p > 0) {
                modes.resize(count, p);
                for (Index j = 0; j < p; ++j)
                    for (Index i = 0; i < count; ++i)
                        modes(i, j) = model.pca_modes.map()(3 * (first + i) + axis, j);
                dense::multiply(context, 1.0f, whitening.leftCols(p), dense::Op::none, modes,
                                dense::Op::transpose, 0.0f, whitened);
            }
            if (r > 0)
                dense::multiply(context, 1.0f, whitening.middleCols(p + axis * r, r),
                                dense::Op::none, model.basis.map().block(first, 0, count, r),
                                dense::Op::transpose, 1.0f, whitened);
            variance.segment(first, count) +=
                whitened.colwise().squaredNorm().transpose().cast<double>();
        }
    }
    return variance;
}

// Prior variance of each vertex in the trained modes from p and the kernel's from r on, all axes
// together.
Vector left_out_variance(const DeformationModel& model, Index p, Index all_p, double pca_amplitude,
                         Index r, Index all_r, double kernel_amplitude, const Context& context) {
    const Index n = model.num_vertices();
    Vector variance = Vector::Zero(n);
    parallel_for(
        context, static_cast<std::size_t>(n), 1024, [&](std::size_t begin, std::size_t end) {
            const Index first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
            Eigen::VectorXf squares = Eigen::VectorXf::Zero(count),
                            flat = Eigen::VectorXf::Zero(3 * count);
            for (Index j = r; j < all_r; ++j)
                squares += model.basis.map().col(j).segment(first, count).cwiseAbs2();
            for (Index j = p; j < all_p; ++j)
                flat += model.pca_modes.map().col(j).segment(3 * first, 3 * count).cwiseAbs2();
            const Eigen::Map<const Eigen::Matrix<float, 3, Eigen::Dynamic>> axes(flat.data(), 3,
                                                                                 count);
            variance.segment(first, count) =
                3 * kernel_amplitude * kernel_amplitude * squares.cast<double>() +
                pca_amplitude * pca_amplitude * axes.colwise().sum().transpose().cast<double>();
        });
    return variance;
}

}  // namespace

Vector place_deviation(const DeformationModel& model, const FitState& state, const Vector& weight,
                       const PointsRef& normals_model, const std::vector<Pin>& pins,
                       const RegistrationOptions& options, const Context& context) {
    const Index n = model.num_vertices();
    const Index p = std::min<Index>(state.coefficients.pca.size(), 80);
    const Index r = std::min<Index>(state.coefficients.kernel.rows(), p > 0 ? 30 : 60);
    const Index q = p + 3 * r;
    const double ka = state.kernel_amplitude, pa = options.pca_amplitude;
    // One deviation of each mode, in mm: trained modes, then the kernel's axis by axis.
    Eigen::VectorXf scale = Eigen::VectorXf::Constant(q, static_cast<float>(ka));
    scale.head(p).setConstant(static_cast<float>(pa));
    if (model.prior_variance.rows() >= r)
        for (int axis = 0; axis < 3; ++axis)
            scale.segment(p + axis * r, r).array() *=
                model.prior_variance.col(axis).head(r).cast<float>().array().max(1e-4f).sqrt();
    const auto block_of = [&](Index i, Eigen::Matrix<float, 3, Eigen::Dynamic>& block) {
        block.setZero(3, q);
        if (p > 0) block.leftCols(p) = model.pca_modes.map().block(3 * i, 0, 3, p);
        for (int axis = 0; axis < 3 && r > 0; ++axis)
            block.row(axis).segment(p + axis * r, r) = model.basis.map().row(i).head(r);
        block *= scale.asDiagonal();
    };

    // A few hundred places speak for the smooth modes: neighbours' errors are alike, so each of
    // them counts as one observation of the surface's plane, and not as one per vertex.
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
            observed.row(static_cast<Index>(k)) =
                static_cast<float>(std::sqrt(weight[rows[k]]) / sigma) *
                normals_model.row(rows[k]).cast<float>() * block;
        }
    });
    Eigen::Matrix<float, 3, Eigen::Dynamic> pin_block;
    for (std::size_t k = 0; k < pins.size(); ++k) {
        block_of(pins[k].vertex, pin_block);
        observed.middleRows(static_cast<Index>(rows.size() + 3 * k), 3) =
            pin_block / static_cast<float>(pins[k].sigma_mm);
    }
    Vector variance = Vector::Zero(n);
    if (q > 0) {
        Eigen::MatrixXf information(q, q);
        dense::weighted_gram(context, observed, Eigen::VectorXf(), information);
        information.diagonal().array() += 1.0f;
        if (!dense::factor_spd(information)) return Vector::Constant(n, 10.0);
        variance = explained_variance(information, scale, p, r, model, context);
    }
    const Vector left_out = left_out_variance(model, p, state.coefficients.pca.size(), pa, r,
                                              state.coefficients.kernel.rows(), ka, context);
    // What the formula leaves out: hits that slide together, noise that is not independent, faces
    // outside the training span, and, away from the scan, all that no observation checks. The
    // factors were set on scans of other people than those that the tables are made with, so that
    // the 95 % radius holds nine of ten or more.
    const double beside = p > 0 ? 2.3 : 1.7, away = p > 0 ? 4.0 : 3.15;
    // Beside the scan, the surface tells one of three axes and its curvature a part of the others.
    const Eigen::ArrayXd seen = weight.array().max(0.0).min(1.0);
    return (beside * seen + away * (1 - seen)) *
           ((variance.array() + left_out.array() * (1 - 0.7 * seen)) / 3).sqrt();
}

}  // namespace mien
