#include "geometry/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>

#include "unit/measure/shapes.hpp"

namespace mien {
namespace {

constexpr double kPi = 3.14159265358979323846;

LaplaceOperator laplacian(const TriMesh& mesh) {
    return build_laplacian(mesh.vertices, mesh.triangles, {});
}

Vector dense_values(const LaplaceOperator& laplace) {
    const Vector scale = laplace.mass.cwiseSqrt().cwiseInverse();
    const Matrix a = scale.asDiagonal() * Matrix(laplace.stiffness) * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Matrix>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

double orthonormality_defect(const LaplaceOperator& laplace, const EigenPairs& pairs) {
    Matrix gram = pairs.vectors.transpose() * laplace.mass.asDiagonal() * pairs.vectors;
    gram.diagonal().array() -= 1.0;
    return gram.cwiseAbs().maxCoeff();
}

double residual(const LaplaceOperator& laplace, const EigenPairs& pairs) {
    const Matrix r = laplace.stiffness * pairs.vectors -
                     laplace.mass.asDiagonal() * pairs.vectors * pairs.values.asDiagonal();
    const Vector scale = laplace.mass.cwiseSqrt().cwiseInverse();
    return (scale.asDiagonal() * r).colwise().norm().maxCoeff() /
           pairs.values[pairs.values.size() - 1];
}

TriMesh copies(const TriMesh& mesh, int count) {
    TriMesh many;
    const Index n = mesh.vertices.rows(), m = mesh.triangles.rows();
    many.vertices.resize(count * n, 3);
    many.triangles.resize(count * m, 3);
    for (int c = 0; c < count; ++c) {
        many.vertices.middleRows(c * n, n) =
            mesh.vertices.rowwise() + Eigen::RowVector3d(100.0 * c, 0, 0);
        many.triangles.middleRows(c * m, m) =
            mesh.triangles.array() + static_cast<std::uint32_t>(c * n);
    }
    return many;
}

TEST(Spectrum, AgreesWithADenseSolverForEveryK) {
    TriMesh mesh = test::grid(20, 13, 26, 19);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        mesh.vertices(v, 2) = std::sin(0.4 * mesh.vertices(v, 0)) * mesh.vertices(v, 1) * 0.3;
    const LaplaceOperator laplace = laplacian(mesh);
    const Vector expected = dense_values(laplace);
    for (const Index k : {1, 2, 3, 7, 40, 81, 160, 275, 450, 539}) {
        const EigenPairs pairs = smallest_eigenpairs(laplace, k, {});
        ASSERT_EQ(pairs.values.size(), k);
        EXPECT_LT((pairs.values - expected.head(k)).cwiseAbs().maxCoeff(), 1e-9 * expected[k]) << k;
        EXPECT_LT(orthonormality_defect(laplace, pairs), 1e-9) << k;
        if (k > 1) {
            EXPECT_LT(residual(laplace, pairs), 1e-7) << k;
        }
    }
}

TEST(Spectrum, SphereHasTheEigenvaluesOfTheSphericalHarmonics) {
    const LaplaceOperator laplace =
        laplacian(test::sphere(1.0, 5));  // 10,242 vertices, error ~ h^2
    const EigenPairs pairs = smallest_eigenpairs(laplace, 100, {});
    Index at = 0;
    for (int l = 0; l < 10; ++l)
        for (int m = 0; m < 2 * l + 1; ++m, ++at)
            EXPECT_NEAR(pairs.values[at], l * (l + 1.0), 0.01 * l * (l + 1.0)) << l << " " << m;
    EXPECT_LT(orthonormality_defect(laplace, pairs), 1e-8);
}

TEST(Spectrum, RectangleHasNeumannEigenvalues) {
    const LaplaceOperator laplace = laplacian(test::grid(3, 2, 60, 40));
    const EigenPairs pairs = smallest_eigenpairs(laplace, 6, {});
    const double x = kPi * kPi / 9, y = kPi * kPi / 4;
    const double expected[] = {0, x, y, x + y, 4 * x, 4 * x + y};
    for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(pairs.values[i], expected[i], 0.003 * expected[i] + 1e-12);
}

TEST(Spectrum, SameBitsForOneAndThreeThreads) {
    const LaplaceOperator laplace = laplacian(test::sphere(1.0, 4));
    const EigenPairs one = smallest_eigenpairs(laplace, 300, {});
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const EigenPairs three = smallest_eigenpairs(laplace, 300, context);
    EXPECT_TRUE(one.values == three.values);
    EXPECT_TRUE(one.vectors == three.vectors);
}

TEST(Spectrum, SeveralPiecesHaveOneZeroEachAndKeepTheirMultiplicities) {
    TriMesh mesh = copies(test::sphere(1.0, 3), 3);
    const LaplaceOperator laplace = laplacian(mesh);
    const EigenPairs pairs = smallest_eigenpairs(laplace, 60, {});
    for (int i = 0; i < 3; ++i) EXPECT_EQ(pairs.values[i], 0.0);
    for (int i = 3; i < 12; ++i) EXPECT_NEAR(pairs.values[i], 2.0, 0.02);
    EXPECT_GT(pairs.values[12], 5.5);
    EXPECT_LT(orthonormality_defect(laplace, pairs), 1e-9);
}

TEST(Spectrum, LooseVerticesAreConstantsOfTheirOwn) {
    TriMesh mesh = test::sphere(1.0, 3);
    const Index n = mesh.vertices.rows();
    mesh.vertices.conservativeResize(n + 40, 3);
    mesh.vertices.bottomRows(40).setConstant(7.0);
    const LaplaceOperator laplace = laplacian(mesh);
    const EigenPairs few = smallest_eigenpairs(laplace, 10, {});
    EXPECT_EQ(few.values.maxCoeff(), 0.0);
    const EigenPairs pairs = smallest_eigenpairs(laplace, 50, {});
    EXPECT_EQ(pairs.values[40], 0.0);
    EXPECT_NEAR(pairs.values[41], 2.0, 0.02);
    EXPECT_LT(orthonormality_defect(laplace, pairs), 1e-9);
}

TEST(Spectrum, LargestEntryOfEachVectorIsPositive) {
    const LaplaceOperator laplace = laplacian(test::sphere(1.0, 3));
    const EigenPairs pairs = smallest_eigenpairs(laplace, 30, {});
    for (Index c = 0; c < 30; ++c)
        EXPECT_GT(pairs.vectors.col(c).maxCoeff(),
                  0.99 * pairs.vectors.col(c).cwiseAbs().maxCoeff());
}

TEST(Spectrum, SurvivesDegenerateTriangles) {
    TriMesh mesh = test::grid(10, 10, 25, 25);
    mesh.vertices.row(70) = mesh.vertices.row(71);
    mesh.vertices.row(300) = mesh.vertices.row(301);
    const LaplaceOperator laplace = laplacian(mesh);
    const EigenPairs pairs = smallest_eigenpairs(laplace, 100, {});
    EXPECT_LT((pairs.values - dense_values(laplace).head(100)).cwiseAbs().maxCoeff(),
              1e-6 * pairs.values[99]);
    EXPECT_LT(orthonormality_defect(laplace, pairs), 1e-8);
}

TEST(Spectrum, RefusesImpossibleCounts) {
    const LaplaceOperator laplace = laplacian(test::grid(1, 1, 4, 4));
    for (const Index k : {-1, 0, 25, 1000})
        EXPECT_EQ(test::status_of([&] { smallest_eigenpairs(laplace, k, {}); }),
                  Status::invalid_argument);
    LaplaceOperator wrong = laplace;
    wrong.mass[3] = 0;
    EXPECT_EQ(test::status_of([&] { smallest_eigenpairs(wrong, 3, {}); }),
              Status::invalid_argument);
}

TEST(Spectrum, StopsWhenCancelledOrOverBudget) {
    const LaplaceOperator laplace = laplacian(test::sphere(1.0, 4));
    CancelToken token;
    token.request();
    Context context;
    context.cancel = &token;
    EXPECT_EQ(test::status_of([&] { smallest_eigenpairs(laplace, 100, context); }),
              Status::cancelled);
    Context tight;
    tight.max_bytes = 100000;
    EXPECT_EQ(test::status_of([&] { smallest_eigenpairs(laplace, 100, tight); }),
              Status::memory_budget);
}

}  // namespace
}  // namespace mien
