#include "measure/score_direction.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"

namespace mien {
namespace {

constexpr double kLadder[] = {3, 5, 10, 20, 30, 45, 60, 80, 100, 150};  ///< m
constexpr Index kMostVertices = 1500;
constexpr int kSteps = 40;
constexpr double kStill = 1e-3;      ///< of |c|, between two steps
constexpr double kBlunt = 1e-2;      ///< of b: lengths below count as this
constexpr double kRank = 1e-9;       ///< of the largest eigenvalue
constexpr double kClearly = 0.7;     ///< of the regression's risk
constexpr double kShrinkage = 1.0;   ///< of a slope's variance
constexpr double kRounding = 1e-20;  ///< of all that moves
constexpr double kLeastFocus = 0.01;

/// (c, g) for one m, from where the last one ended.
struct Chance {
    Vector coefficients;
    double risk = 0;  ///< against that of c = 0, K
};

/// basis: R and the six columns of Z.
Chance chance_within(const Matrix& basis, const Vector& slope, const Vector& shares, double places,
                     const Vector& start, const Context& context) {
    const Index vertices = shares.size(), columns = basis.cols(), k = columns - 6;
    Chance chance{start, 0};
    Matrix gram(columns, columns), system;
    Vector weights(3 * vertices);
    for (int step = 0; step < kSteps; ++step) {
        context.check_cancelled();
        const Vector left = slope - basis * chance.coefficients;
        const Vector lengths = Eigen::Map<const Points>(left.data(), vertices, 3).rowwise().norm();
        const double mean = shares.dot(lengths);
        if (!(mean > 0)) break;  // nothing is left to weigh
        for (Index v = 0; v < vertices; ++v) {
            const double squared = lengths[v] * lengths[v] + kBlunt * kBlunt * mean * mean;
            weights.segment<3>(3 * v).setConstant(places * shares[v] * std::pow(squared, -0.75) /
                                                  std::sqrt(mean));
        }
        dense::weighted_gram(context, basis, weights, gram);
        system = gram;
        system.diagonal().head(k).array() += 1.0;
        const Eigen::LLT<Matrix> factor(system);
        const Vector next = factor.solve(basis.transpose() * weights.cwiseProduct(slope));
        if (factor.info() != Eigen::Success || !next.allFinite())
            fail(Status::no_solution,
                 "the direction of the score cannot be told from how people differ");
        const double moved = (next - chance.coefficients).norm();
        chance.coefficients = next;
        chance.risk = next.head(k).squaredNorm() - static_cast<double>(k) +
                      2.0 * factor.solve(Matrix::Identity(columns, k)).topRows(k).trace();
        if (moved <= kStill * next.norm()) break;
    }
    return chance;
}

/// Translations, and rotations about the middle of the face by 1 mm at 100 mm: 3#V x 6.
Matrix rigid_motions(const PointsRef& face) {
    Matrix motions = Matrix::Zero(3 * face.rows(), 6);
    const Vector3 middle = face.colwise().mean();
    for (Index v = 0; v < face.rows(); ++v) {
        const Vector3 arm = 0.01 * (face.row(v).transpose() - middle);
        for (int axis = 0; axis < 3; ++axis) {
            motions(3 * v + axis, axis) = 1.0;
            motions.col(3 + axis).segment<3>(3 * v) = Vector3::Unit(axis).cross(arm);
        }
    }
    return motions;
}

}  // namespace

ScoreDirection score_direction(const PointsRef& mean_face,
                               const Eigen::Ref<const Matrix>& displacements, const Vector& areas,
                               const Vector& grades, const Context& context) {
    const Index vertices = areas.size(), n = grades.size();
    const Vector centred = grades.array() - grades.mean();
    const double squares = centred.squaredNorm();
    const Vector mean = displacements.rowwise().mean();
    ScoreDirection direction;
    direction.displacement = displacements * centred / squares;  // centred grades need no mean
    if (n < 4 || !(areas.sum() > 0)) return direction;

    // Residuals, and their span in coefficients of the faces.
    Matrix residuals = displacements.colwise() - mean;
    residuals.noalias() -= direction.displacement * centred.transpose();
    Matrix gram(n, n);
    dense::weighted_gram(context, residuals, Vector(), gram);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution,
             "the direction of the score cannot be told from how people differ");
    const Vector& values = eigen.eigenvalues();
    if (!(values[n - 1] > kRounding * displacements.squaredNorm())) return direction;
    const Index k = (values.array() > kRank * values[n - 1]).count();
    const Matrix mixing =
        eigen.eigenvectors().rightCols(k) / std::sqrt(static_cast<double>(n - 2) * squares);

    const Index stride = (vertices + kMostVertices - 1) / kMostVertices,
                used = (vertices + stride - 1) / stride;
    const Matrix motions = rigid_motions(mean_face);
    Matrix rows(3 * used, n), basis(3 * used, k + 6);
    Vector slope(3 * used), shares(used);
    for (Index v = 0; v < used; ++v) {
        rows.middleRows<3>(3 * v) = residuals.middleRows<3>(3 * v * stride);
        basis.middleRows<3>(3 * v).rightCols<6>() = motions.middleRows<3>(3 * v * stride);
        slope.segment<3>(3 * v) = direction.displacement.segment<3>(3 * v * stride);
        shares[v] = areas[v * stride];
    }
    if (!(shares.sum() > 0)) return direction;
    shares /= shares.sum();
    basis.leftCols(k) = rows * mixing;

    const double regression = static_cast<double>(k);  // the risk of c = 0
    double least = regression;
    Vector best = Vector::Zero(k + 6), last = best;
    for (const double places : kLadder) {
        const Chance chance = chance_within(basis, slope, shares, places, last, context);
        last = chance.coefficients;
        if (!(chance.risk < least)) continue;
        least = chance.risk;
        best = chance.coefficients;
        direction.places = places;
    }
    if (!(least < kClearly * regression)) {
        direction.places = 0;
        for (Index v = 0; v < vertices; ++v) {
            auto own = direction.displacement.segment<3>(3 * v);
            const double variance = residuals.middleRows<3>(3 * v).squaredNorm() /
                                    (static_cast<double>(n - 2) * squares);
            own *= std::max(0.0, 1.0 - kShrinkage * variance / std::max(own.squaredNorm(), 1e-300));
        }
        return direction;
    }
    direction.displacement -= residuals * (mixing * best.head(k)) + motions * best.tail<6>();
    return direction;
}

Vector focus_of(const ScoreDirection& direction) {
    const Vector& moved = direction.displacement;
    const Vector lengths =
        Eigen::Map<const Points>(moved.data(), moved.size() / 3, 3).rowwise().norm();
    const double longest = lengths.maxCoeff();
    if (direction.places == 0 || !(longest > 0)) return Vector::Ones(lengths.size());
    return (lengths / longest).cwiseMax(kLeastFocus);
}

}  // namespace mien
