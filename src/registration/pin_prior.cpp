#include "registration/pin_prior.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <limits>
#include <numeric>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "registration/evidence.hpp"

namespace mien {
namespace {

// In the model frame: displacements seen, their covariance by the kernel (amplitude 1) and by the
// trained modes, and the seven small motions.
struct PinPrior {
    Vector displacement;            // 3 n
    Matrix kernel, vectors, moves;  // 3 n x 3 n twice, 3 n x 7

    Matrix covariance(double kernel_amplitude, double pca_amplitude) const {
        return kernel_amplitude * kernel_amplitude * kernel +
               pca_amplitude * pca_amplitude * vectors;
    }
};

PinPrior pin_prior(const DeformationModel& model, const std::vector<Pin>& pins,
                   const Similarity& motion, const Context& context) {
    constexpr double kRadius_mm = 100;  // of a head: makes turns and shifts alike in size
    const Index n = static_cast<Index>(pins.size()), r = model.basis.cols, p = model.pca_modes.cols;
    const Similarity to_model = motion.inverse();
    PinPrior prior;
    prior.displacement.resize(3 * n);
    prior.moves.resize(3 * n, 7);
    prior.kernel.setZero(3 * n, 3 * n);
    Matrix modes(n, r), vectors(3 * n, p);
    for (Index k = 0; k < n; ++k) {
        const Pin& pin = pins[static_cast<std::size_t>(k)];
        const Vector3 x = rest_place(model, pin.vertex);
        prior.displacement.segment<3>(3 * k) = to_model.apply(pin.place) - x;
        if (r > 0) modes.row(k) = model.basis.map().row(pin.vertex).cast<double>();
        if (p > 0)
            vectors.middleRows(3 * k, 3) =
                model.pca_modes.map().middleRows(3 * pin.vertex, 3).cast<double>();
        const Vector3 y = x / kRadius_mm;
        prior.moves.middleRows(3 * k, 3) << 0, y[2], -y[1], 1, 0, 0, y[0], -y[2], 0, y[0], 0, 1, 0,
            y[1], y[1], -y[0], 0, 0, 0, 1, y[2];
    }
    for (int axis = 0; axis < 3 && r > 0; ++axis) {
        Vector variance = Vector::Ones(r);
        if (model.prior_variance.rows() >= r) variance = model.prior_variance.col(axis).head(r);
        const Matrix scaled = modes * variance.asDiagonal();
        Matrix kernel(n, n);
        dense::multiply(context, 1.0, scaled, dense::Op::none, modes, dense::Op::transpose, 0.0,
                        kernel);
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j) prior.kernel(3 * i + axis, 3 * j + axis) = kernel(i, j);
    }
    prior.vectors.setZero(3 * n, 3 * n);
    if (p > 0)
        dense::multiply(context, 1.0, vectors, dense::Op::none, vectors, dense::Op::transpose, 0.0,
                        prior.vectors);
    return prior;
}

// Of the kept pins the one that the others contradict most, as its place among them; -1 when none
// is beyond the limit.
Index find_worst(const Matrix& covariance, const Vector& displacement,
                 const std::vector<std::size_t>& kept, double limit) {
    const Index m = static_cast<Index>(kept.size());
    Matrix part(3 * m, 3 * m);
    Vector d(3 * m);
    for (Index i = 0; i < m; ++i) {
        const Index row = 3 * static_cast<Index>(kept[static_cast<std::size_t>(i)]);
        d.segment<3>(3 * i) = displacement.segment<3>(row);
        for (Index j = 0; j < m; ++j)
            part.block<3, 3>(3 * i, 3 * j) = covariance.block<3, 3>(
                row, 3 * static_cast<Index>(kept[static_cast<std::size_t>(j)]));
    }
    const Eigen::LLT<Matrix> factor(part);
    const Matrix inverse = factor.solve(Matrix::Identity(3 * m, 3 * m));
    if (factor.info() != Eigen::Success || !inverse.allFinite())  // NaN passes the factorisation
        fail(Status::no_solution,
             "registration: the covariance of %lld landmarks is not positive definite; check that "
             "they are finite and their sigma is not zero",
             static_cast<long long>(m));
    const Vector whitened = inverse * d;
    Index worst = -1;
    double worst_value = limit;
    for (Index i = 0; i < m; ++i) {
        const Matrix3 block = inverse.block<3, 3>(3 * i, 3 * i);
        const Vector3 w = whitened.segment<3>(3 * i);
        const Eigen::LDLT<Matrix3> inner(block);
        if (inner.info() != Eigen::Success)
            fail(Status::no_solution,
                 "registration: a landmark's own covariance is not positive definite");
        const double value = w.dot(inner.solve(w));
        if (value > worst_value) worst = i, worst_value = value;
    }
    return worst;
}

}  // namespace

std::vector<std::size_t> contradicting_pins(const DeformationModel& model,
                                            const std::vector<Pin>& pins, const Similarity& motion,
                                            double kernel_amplitude, double pca_amplitude,
                                            const PinPriorSettings& settings,
                                            const Context& context) {
    std::vector<std::size_t> rejected, kept(pins.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    if (pins.size() < settings.fewest_to_reject || pins.size() > settings.most) return rejected;
    const PinPrior prior = pin_prior(model, pins, motion, context);
    Matrix covariance = prior.covariance(kernel_amplitude, pca_amplitude) +
                        settings.motion_variance * prior.moves * prior.moves.transpose();
    for (std::size_t k = 0; k < pins.size(); ++k)
        covariance.diagonal().segment<3>(3 * static_cast<Index>(k)).array() +=
            pins[k].sigma_mm * pins[k].sigma_mm;
    const std::size_t most = std::max<std::size_t>(1, pins.size() / settings.reject_one_in);
    while (kept.size() + 1 > settings.fewest_to_reject) {
        const Index worst = find_worst(covariance, prior.displacement, kept, settings.limit);
        if (worst < 0) break;
        // A few wrong picks stand alone; where many places disagree it is the face that the prior
        // did not expect, and its landmarks are the best evidence there is.
        if (rejected.size() == most) return {};
        rejected.push_back(kept[static_cast<std::size_t>(worst)]);
        kept.erase(kept.begin() + worst);
    }
    return rejected;
}

PinFactors weigh_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                      const Similarity& motion, double kernel_amplitude, double pca_amplitude,
                      const PinPriorSettings& settings, const Context& context) {
    PinFactors best;
    if (!settings.weigh || pins.size() < settings.fewest_to_weigh || pins.size() > settings.most)
        return best;
    const PinPrior prior = pin_prior(model, pins, motion, context);
    const Index n = prior.displacement.size();
    // Motions carry no evidence: everything is seen orthogonal to them.
    const Matrix whole =
        Eigen::HouseholderQR<Matrix>(prior.moves).householderQ() * Matrix::Identity(n, n);
    const Matrix others = whole.rightCols(n - prior.moves.cols());
    const Matrix covariance = prior.covariance(kernel_amplitude, pca_amplitude);
    Matrix carried(n, others.cols()), seen_covariance(others.cols(), others.cols());
    dense::multiply(context, 1.0, covariance, dense::Op::none, others, dense::Op::none, 0.0,
                    carried);
    dense::multiply(context, 1.0, others, dense::Op::transpose, carried, dense::Op::none, 0.0,
                    seen_covariance);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(seen_covariance);
    if (eigen.info() != Eigen::Success || !eigen.eigenvalues().allFinite())
        fail(Status::no_solution,
             "registration: the eigenvalues of the landmarks' covariance were not found; check "
             "that the landmarks are finite");
    const Vector seen =
        eigen.eigenvectors().transpose() * (others.transpose() * prior.displacement);
    double sigma2 = 0;
    for (const Pin& pin : pins) sigma2 += pin.sigma_mm * pin.sigma_mm;
    sigma2 /= static_cast<double>(pins.size());
    double best_cost = std::numeric_limits<double>::infinity();
    const int most = model.pca_modes.cols > 0 && pca_amplitude > 0
                         ? 0
                         : settings.amplitude_octaves * settings.amplitude_steps;
    for (int s = settings.noise_low; s <= settings.noise_high; ++s)
        for (int k = -most; k <= most; ++k) {
            const double amplitude =
                std::pow(2.0, k / static_cast<double>(settings.amplitude_steps));
            const double noise = std::pow(2.0, s / 4.0);
            double cost =
                0.5 * s * s;  // the picking error was given: half or double of it surprises
            for (Index j = 0; j < seen.size(); ++j) {
                const double variance =
                    amplitude * amplitude * std::max(0.0, eigen.eigenvalues()[j]) +
                    noise * noise * sigma2;
                cost += std::log(variance) + seen[j] * seen[j] / variance;
            }
            if (cost < best_cost) best_cost = cost, best = {amplitude, noise, cost, true};
        }
    return best;
}

}  // namespace mien
