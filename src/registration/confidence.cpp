#include "registration/confidence.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense.hpp"
#include "base/error.hpp"
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

// The modes that the posterior is of, and one deviation of each in mm: trained modes, then the
// kernel's axis by axis.
struct Unknowns {
    Index p, r;
    Eigen::VectorXf scale;
    Index size() const { return p + 3 * r; }

    void block_of(const DeformationModel& model, Index i,
                  Eigen::Matrix<float, 3, Eigen::Dynamic>& block) const {
        block.setZero(3, size());
        if (p > 0) block.leftCols(p) = model.pca_modes.map().block(3 * i, 0, 3, p);
        for (int axis = 0; axis < 3 && r > 0; ++axis)
            block.row(axis).segment(p + axis * r, r) = model.basis.map().row(i).head(r);
        block *= scale.asDiagonal();
    }
};

Unknowns choose_unknowns(const DeformationModel& model, const FitState& state, double pca_amplitude,
                         const ConfidenceSettings& settings) {
    Unknowns u;
    u.p = std::min<Index>(state.coefficients.pca.size(), settings.pca_modes);
    u.r = std::min<Index>(state.coefficients.kernel.rows(),
                          u.p > 0 ? settings.kernel_modes_beside : settings.kernel_modes_alone);
    u.scale = Eigen::VectorXf::Constant(u.size(), static_cast<float>(state.kernel_amplitude));
    u.scale.head(u.p).setConstant(static_cast<float>(pca_amplitude));
    if (model.prior_variance.rows() >= u.r)
        for (int axis = 0; axis < 3; ++axis)
            u.scale.segment(u.p + axis * u.r, u.r).array() *=
                model.prior_variance.col(axis)
                    .head(u.r)
                    .cast<float>()
                    .array()
                    .max(static_cast<float>(settings.least_variance))
                    .sqrt();
    return u;
}

// One row per observation, over its deviation: planes of the places that stand for the surface,
// then three axes of each pin.
Eigen::MatrixXf observations(const DeformationModel& model, const Unknowns& unknowns,
                             const Vector& weight, const PointsRef& normals_model,
                             const std::vector<Pin>& pins, double sigma_mm,
                             const ConfidenceSettings& settings, const Context& context) {
    const Index n = model.num_vertices();
    const Index stride = std::max<Index>(1, n / settings.rows);
    std::vector<Index> rows;
    for (Index i = 0; i < n; i += stride)
        if (weight[i] > settings.least_weight) rows.push_back(i);
    const double sigma = std::max(settings.least_sigma_mm, sigma_mm);
    Eigen::MatrixXf observed(static_cast<Index>(rows.size() + 3 * pins.size()), unknowns.size());
    parallel_for(context, rows.size(), 128, [&](std::size_t begin, std::size_t end) {
        Eigen::Matrix<float, 3, Eigen::Dynamic> block;
        for (std::size_t k = begin; k < end; ++k) {
            unknowns.block_of(model, rows[k], block);
            observed.row(static_cast<Index>(k)) =
                static_cast<float>(std::sqrt(weight[rows[k]]) / sigma) *
                normals_model.row(rows[k]).cast<float>() * block;
        }
    });
    Eigen::Matrix<float, 3, Eigen::Dynamic> pin_block;
    for (std::size_t k = 0; k < pins.size(); ++k) {
        unknowns.block_of(model, pins[k].vertex, pin_block);
        observed.middleRows(static_cast<Index>(rows.size() + 3 * k), 3) =
            pin_block / static_cast<float>(pins[k].sigma_mm);
    }
    return observed;
}

}  // namespace

Vector place_deviation(const DeformationModel& model, const FitState& state,
                       const FitFreedom& freedom, const Vector& weight,
                       const PointsRef& normals_model, const std::vector<Pin>& pins,
                       double sigma_mm, const ConfidenceSettings& settings,
                       const Context& context) {
    const Unknowns unknowns = choose_unknowns(model, state, freedom.pca_amplitude, settings);
    const Index p = unknowns.p, r = unknowns.r, q = unknowns.size();
    Vector variance = Vector::Zero(model.num_vertices());
    if (q > 0) {
        const Eigen::MatrixXf observed =
            observations(model, unknowns, weight, normals_model, pins, sigma_mm, settings, context);
        Eigen::MatrixXf information(q, q);
        dense::weighted_gram(context, observed, Eigen::VectorXf(), information);
        information.diagonal().array() += 1.0f;  // the prior's own, as modes are in deviations
        const bool definite = dense::factor_spd(information);
        if (definite)
            variance = explained_variance(information, unknowns.scale, p, r, model, context);
        if (!definite || !variance.allFinite())  // infinities pass the factorisation
            fail(Status::no_solution,
                 "registration, confidence: the information of %lld modes is not positive "
                 "definite; check the landmarks' sigma and the model's modes",
                 static_cast<long long>(q));
    }
    const Vector left_out =
        left_out_variance(model, p, state.coefficients.pca.size(), freedom.pca_amplitude, r,
                          state.coefficients.kernel.rows(), state.kernel_amplitude, context);
    const double beside = p > 0 ? settings.beside_trained : settings.beside_kernel,
                 away = p > 0 ? settings.away_trained : settings.away_kernel;
    // Beside the scan, the surface tells one of three axes and its curvature a part of the others.
    const Eigen::ArrayXd seen = weight.array().max(0.0).min(1.0);
    return (beside * seen + away * (1 - seen)) *
           ((variance.array() + left_out.array() * (1 - settings.seen_share * seen)) / 3).sqrt();
}

}  // namespace mien
