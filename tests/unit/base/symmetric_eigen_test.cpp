#include "base/symmetric_eigen.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/random.hpp"
#include "base/thread_pool.hpp"

namespace mien {
namespace {

Matrix chance(Index rows, Index cols, std::uint64_t seed) {
    const CounterRandom random(seed, 0);
    Matrix m(rows, cols);
    for (Index i = 0; i < m.size(); ++i) m.data()[i] = random.normal(static_cast<std::uint64_t>(i));
    return m;
}

/// Q diag(values) Q' for a chance rotation.
Matrix with_values(const Vector& values, std::uint64_t seed) {
    const Index n = values.size();
    const Matrix q = Eigen::HouseholderQR<Matrix>(chance(n, n, seed)).householderQ();
    return q * values.asDiagonal() * q.transpose();
}

void expect_eigenvectors(const Matrix& matrix, Index k) {
    Matrix work = matrix;
    const SymmetricSpectrum spectrum(work, "a test's matrix", {});
    const Vector truth =
        Eigen::SelfAdjointEigenSolver<Matrix>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
    const double size = std::max(1e-300, truth.cwiseAbs().maxCoeff());
    EXPECT_LT((spectrum.values() - truth).cwiseAbs().maxCoeff(), 1e-12 * size);
    const Matrix vectors = spectrum.strongest(k, {});
    ASSERT_EQ(vectors.cols(), k);
    EXPECT_LT(
        (matrix * vectors - vectors * spectrum.values().tail(k).asDiagonal()).cwiseAbs().maxCoeff(),
        1e-11 * size);
    EXPECT_LT((vectors.transpose() * vectors - Matrix::Identity(k, k)).cwiseAbs().maxCoeff(),
              1e-12);
    const Matrix weakest = spectrum.vectors(0, k, {});
    EXPECT_LT(
        (matrix * weakest - weakest * spectrum.values().head(k).asDiagonal()).cwiseAbs().maxCoeff(),
        1e-11 * size);
}

TEST(SymmetricEigen, RecoversSpreadValues) {
    expect_eigenvectors(with_values(Vector::LinSpaced(311, -2, 5), 1), 100);
    expect_eigenvectors(with_values(Vector::LinSpaced(60, -2, 5), 2), 60);
}

TEST(SymmetricEigen, PartsValuesThatDecayToNothing) {
    Vector values(420);
    for (Index j = 0; j < 420; ++j) values[j] = std::pow(static_cast<double>(j + 1), -4.4);
    expect_eigenvectors(with_values(values, 3), 400);
}

TEST(SymmetricEigen, EqualValuesGetOrthogonalVectors) {
    Vector values = Vector::LinSpaced(300, 0, 1);
    values.tail(40).setConstant(2);
    values.segment(100, 25).setConstant(values[100]);
    expect_eigenvectors(with_values(values, 4), 250);
    expect_eigenvectors(Matrix::Identity(230, 230), 230);
    expect_eigenvectors(Matrix::Zero(230, 230), 7);
}

TEST(SymmetricEigen, MatricesThatFallApartAreWhole) {
    Matrix two = Matrix::Zero(500, 500);
    two.topLeftCorner(250, 250) = with_values(Vector::LinSpaced(250, 0, 1), 5);
    two.bottomRightCorner(250, 250) = two.topLeftCorner(250, 250);
    expect_eigenvectors(two, 120);
}

TEST(SymmetricEigen, SizesOfHugeAndTinyNumbersDoNotMatter) {
    const Matrix plain = with_values(Vector::LinSpaced(260, -1, 1), 6);
    expect_eigenvectors(1e120 * plain, 30);
    expect_eigenvectors(1e-120 * plain, 30);
}

TEST(SymmetricEigen, BitsDoNotDependOnThreads) {
    const Matrix matrix = with_values(Vector::LinSpaced(700, 0, 1), 7);
    Matrix one = matrix, three = matrix;
    ThreadPool pool(3);
    Context many;
    many.pool = &pool;
    const SymmetricSpectrum first(one, "a", {}), second(three, "b", many);
    EXPECT_TRUE(first.values() == second.values());
    EXPECT_TRUE(first.strongest(200, {}) == second.strongest(200, many));
}

TEST(SymmetricEigen, RefusesWhatIsNotFinite) {
    Matrix broken = with_values(Vector::LinSpaced(250, 0, 1), 8);
    broken(200, 17) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(SymmetricSpectrum(broken, "a test's matrix", {}), Error);
}

}  // namespace
}  // namespace mien
