#include "registration/start.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

Vector3 rest(const DeformationModel& model, Index vertex) {
    Vector3 place = model.template_mesh.vertices.row(vertex).transpose();
    if (model.mean_displacement.rows() > 0)
        place += model.mean_displacement.row(vertex).transpose();
    return place;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// What the prior says of the pinned places, in the model frame: displacement seen, its covariance
// by the kernel (amplitude 1) and by the trained modes, and the seven small motions.
struct PinPrior {
    Vector displacement;            // 3 n
    Matrix kernel, vectors, moves;  // 3 n x 3 n twice, 3 n x 7
};

PinPrior pin_prior(const DeformationModel& model, const std::vector<Pin>& pins,
                   const Similarity& motion) {
    const Index n = static_cast<Index>(pins.size()), r = model.basis.cols, p = model.pca_modes.cols;
    const Similarity to_model = motion.inverse();
    PinPrior prior;
    prior.displacement.resize(3 * n);
    prior.moves.resize(3 * n, 7);
    prior.kernel.setZero(3 * n, 3 * n);
    Matrix modes(n, r), vectors(3 * n, p);
    for (Index k = 0; k < n; ++k) {
        const Pin& pin = pins[static_cast<std::size_t>(k)];
        const Vector3 x = rest(model, pin.vertex);
        prior.displacement.segment<3>(3 * k) = to_model.apply(pin.place) - x;
        if (r > 0) modes.row(k) = model.basis.map().row(pin.vertex).cast<double>();
        if (p > 0)
            vectors.middleRows(3 * k, 3) =
                model.pca_modes.map().middleRows(3 * pin.vertex, 3).cast<double>();
        const Vector3 y = x / 100;
        prior.moves.middleRows(3 * k, 3) << 0, y[2], -y[1], 1, 0, 0, y[0], -y[2], 0, y[0], 0, 1, 0,
            y[1], y[1], -y[0], 0, 0, 0, 1, y[2];
    }
    for (int axis = 0; axis < 3 && r > 0; ++axis) {
        Vector variance = Vector::Ones(r);
        if (model.prior_variance.rows() >= r) variance = model.prior_variance.col(axis).head(r);
        const Matrix kernel = modes * variance.asDiagonal() * modes.transpose();
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j) prior.kernel(3 * i + axis, 3 * j + axis) = kernel(i, j);
    }
    prior.vectors = vectors * vectors.transpose();
    return prior;
}

}  // namespace

Similarity align_robustly(const DeformationModel& model, const std::vector<Pin>& pins,
                          bool with_scale) {
    const Index n = static_cast<Index>(pins.size());
    Points from(n, 3), to(n, 3);
    for (Index k = 0; k < n; ++k) {
        from.row(k) = rest(model, pins[static_cast<std::size_t>(k)].vertex).transpose();
        to.row(k) = pins[static_cast<std::size_t>(k)].place.transpose();
    }
    Similarity best = align_points(from, to, Vector(), with_scale);
    if (n < 5) return best;
    const auto distances = [&](const Similarity& motion) {
        std::vector<double> d(static_cast<std::size_t>(n));
        for (Index k = 0; k < n; ++k)
            d[static_cast<std::size_t>(k)] =
                (motion.apply(Vector3(from.row(k))) - to.row(k).transpose()).norm();
        return d;
    };
    double best_median = median(distances(best));
    // Fixed three-point samples with a wide spread over the list; size is taken from the whole.
    std::uint32_t state = 12345;
    const auto next = [&]() {
        state = state * 1664525u + 1013904223u;
        return static_cast<Index>((state >> 8) % static_cast<std::uint32_t>(n));
    };
    for (int trial = 0; trial < 300; ++trial) {
        const Index pick[3] = {next(), next(), next()};
        if (pick[0] == pick[1] || pick[1] == pick[2] || pick[0] == pick[2]) continue;
        Points a(3, 3), b(3, 3);
        for (int k = 0; k < 3; ++k) a.row(k) = from.row(pick[k]), b.row(k) = to.row(pick[k]);
        if ((Vector3(a.row(1) - a.row(0)).cross(Vector3(a.row(2) - a.row(0)))).norm() < 400)
            continue;
        Similarity motion;
        try {
            motion = align_points(a, b, Vector(), false);
        } catch (const Error&) {
            continue;
        }
        const double m = median(distances(motion));
        if (m < 0.6 * best_median) best = motion, best_median = m;
    }
    for (int round = 0; round < 10; ++round) {
        const std::vector<double> d = distances(best);
        const double scale = std::max(3.0, 2 * median(d));
        Vector weights(n);
        for (Index k = 0; k < n; ++k) {
            const double x = d[static_cast<std::size_t>(k)] / scale;
            weights[k] = 1 / (1 + x * x);
        }
        best = align_points(from, to, weights, with_scale);
    }
    return best;
}

std::vector<std::size_t> contradicting_pins(const DeformationModel& model,
                                            const std::vector<Pin>& pins, const Similarity& motion,
                                            double kernel_amplitude, double pca_amplitude) {
    std::vector<std::size_t> rejected, kept(pins.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    if (pins.size() < 5 || pins.size() > 300) return rejected;
    const PinPrior prior = pin_prior(model, pins, motion);
    const Vector& displacement = prior.displacement;
    Matrix covariance = kernel_amplitude * kernel_amplitude * prior.kernel +
                        pca_amplitude * pca_amplitude * prior.vectors +
                        1e3 * prior.moves * prior.moves.transpose();
    for (std::size_t k = 0; k < pins.size(); ++k)
        covariance.diagonal().segment<3>(3 * static_cast<Index>(k)).array() +=
            pins[k].sigma_mm * pins[k].sigma_mm;
    constexpr double kLimit = 40;  // chi-squared with 3 degrees, with room for an imperfect prior
    const std::size_t most = std::max<std::size_t>(1, pins.size() / 10);
    while (kept.size() > 4) {
        const Index m = static_cast<Index>(kept.size());
        Matrix part(3 * m, 3 * m);
        Vector d(3 * m);
        for (Index i = 0; i < m; ++i) {
            d.segment<3>(3 * i) =
                displacement.segment<3>(3 * static_cast<Index>(kept[static_cast<std::size_t>(i)]));
            for (Index j = 0; j < m; ++j)
                part.block<3, 3>(3 * i, 3 * j) = covariance.block<3, 3>(
                    3 * static_cast<Index>(kept[static_cast<std::size_t>(i)]),
                    3 * static_cast<Index>(kept[static_cast<std::size_t>(j)]));
        }
        const Eigen::LLT<Matrix> factor(part);
        if (factor.info() != Eigen::Success) return rejected;
        const Matrix inverse = factor.solve(Matrix::Identity(3 * m, 3 * m));
        const Vector whitened = inverse * d;
        Index worst = -1;
        double worst_value = kLimit;
        for (Index i = 0; i < m; ++i) {
            const Matrix3 block = inverse.block<3, 3>(3 * i, 3 * i);
            const Vector3 w = whitened.segment<3>(3 * i);
            const double value = w.dot(block.ldlt().solve(w));
            if (value > worst_value) worst = i, worst_value = value;
        }
        if (worst < 0) break;
        // A few wrong picks stand alone; where many places disagree it is the face that the prior
        // did not expect (an open mouth), and its landmarks are the best evidence there is.
        if (rejected.size() == most) return {};
        rejected.push_back(kept[static_cast<std::size_t>(worst)]);
        kept.erase(kept.begin() + worst);
    }
    return rejected;
}

PinEvidence weigh_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                       const Similarity& motion, double kernel_amplitude, double pca_amplitude) {
    PinEvidence best;
    if (pins.size() < 10 || pins.size() > 300) return best;
    const PinPrior prior = pin_prior(model, pins, motion);
    const Index n = prior.displacement.size();
    // Motions carry no evidence: everything is seen orthogonal to them.
    const Matrix whole =
        Eigen::HouseholderQR<Matrix>(prior.moves).householderQ() * Matrix::Identity(n, n);
    const Matrix others = whole.rightCols(n - prior.moves.cols());
    const Matrix covariance = kernel_amplitude * kernel_amplitude * prior.kernel +
                              pca_amplitude * pca_amplitude * prior.vectors;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(
        Matrix(others.transpose() * covariance * others));
    if (eigen.info() != Eigen::Success) return best;
    const Vector seen =
        eigen.eigenvectors().transpose() * (others.transpose() * prior.displacement);
    double sigma2 = 0;
    for (const Pin& pin : pins) sigma2 += pin.sigma_mm * pin.sigma_mm;
    sigma2 /= static_cast<double>(pins.size());
    double best_cost = 1e300;
    const int most = model.pca_modes.cols > 0 && pca_amplitude > 0
                         ? 0
                         : 24;  // trained modes know how far faces differ
    for (int s = -8; s <= 2; ++s)
        for (int k = -most; k <= most; ++k) {
            const double amplitude = std::pow(2.0, k / 8.0), noise = std::pow(2.0, s / 4.0);
            double cost =
                0.5 * s * s;  // the picking error was given: half or double of it surprises
            for (Index j = 0; j < seen.size(); ++j) {
                const double variance =
                    amplitude * amplitude * std::max(0.0, eigen.eigenvalues()[j]) +
                    noise * noise * sigma2;
                cost += std::log(variance) + seen[j] * seen[j] / variance;
            }
            if (cost < best_cost) best_cost = cost, best = {amplitude, noise};
        }
    return best;
}

double detect_unit_mm(const PointsRef& vertices) {
    // Extent between the 2nd and 98th of 100 along each axis, so that a stray point says nothing.
    Vector3 extent;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values(static_cast<std::size_t>(vertices.rows()));
        for (Index i = 0; i < vertices.rows(); ++i)
            values[static_cast<std::size_t>(i)] = vertices(i, axis);
        const std::size_t low = values.size() / 50, high = values.size() - 1 - low;
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(low),
                         values.end());
        const double a = values[low];
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(high),
                         values.end());
        extent[axis] = values[high] - a;
    }
    const double size = extent.norm();
    // A face alone measures about 200 mm across corners, a bust 700.
    for (const double unit : {1.0, 10.0, 25.4, 1000.0, 100.0})
        if (size * unit >= 110 && size * unit <= 900) return unit;
    return 0;
}

}  // namespace mien
