#include "geometry/laplacian.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>

#include "geometry/intrinsic_triangulation.hpp"
#include "unit/measure/shapes.hpp"

namespace mien {
namespace {

LaplaceOperator build(const TriMesh& mesh, NegativeCotangents negative,
                      MassKind mass = MassKind::mixed_voronoi) {
    LaplacianOptions options;
    options.negative = negative;
    options.mass = mass;
    return build_laplacian(mesh.vertices, mesh.triangles, options);
}

/// Two triangles over the edge 0-1 (length 2) whose angles opposite to it are obtuse.
TriMesh flat_kite() {
    TriMesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << -1, 0, 0, 1, 0, 0, 0, 0.3, 0, 0, -0.3, 0;
    mesh.triangles.resize(2, 3);
    mesh.triangles << 0, 1, 2, 1, 0, 3;
    return mesh;
}

TriMesh bumpy() {
    TriMesh mesh = test::grid(10, 10, 12, 9);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1);
        mesh.vertices(v, 2) = std::sin(1.3 * x) * std::cos(0.9 * y);
        mesh.vertices(v, 0) += 0.3 * std::sin(5 * y);
    }
    return mesh;
}

TEST(Laplacian, EntriesAreTheCotangentsOfTheOppositeAngles) {
    TriMesh mesh;
    mesh.vertices.resize(3, 3);
    mesh.vertices << 0, 0, 0, 2, 0, 0, 0, 1, 0;  // right angle at 0, cot at 1 = 2, at 2 = 1/2
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    const Matrix dense = Matrix(build(mesh, NegativeCotangents::keep).stiffness);
    EXPECT_NEAR(dense(0, 1), -0.25, 1e-14);
    EXPECT_NEAR(dense(0, 2), -1.0, 1e-14);
    EXPECT_NEAR(dense(1, 2), 0.0, 1e-14);
}

TEST(Laplacian, DirichletEnergyOfALinearFunctionIsItsGradientSquaredTimesTheArea) {
    const TriMesh mesh = test::grid(4, 3, 7, 5);
    for (const auto negative : {NegativeCotangents::keep, NegativeCotangents::intrinsic_delaunay}) {
        const SparseMatrix stiffness = build(mesh, negative).stiffness;
        const Vector u = 2.0 * mesh.vertices.col(0) - 0.5 * mesh.vertices.col(1);
        EXPECT_NEAR(u.dot(stiffness * u), 4.25 * 12, 1e-10);
    }
}

TEST(Laplacian, IsSymmetricPositiveSemidefiniteWithZeroRowSums) {
    const TriMesh mesh = bumpy();
    for (const auto negative : {NegativeCotangents::keep, NegativeCotangents::clamp,
                                NegativeCotangents::intrinsic_delaunay}) {
        const Matrix dense = Matrix(build(mesh, negative).stiffness);
        EXPECT_LT((dense - dense.transpose()).cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_LT(dense.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12);
        const Vector values = Eigen::SelfAdjointEigenSolver<Matrix>(dense).eigenvalues();
        EXPECT_GT(values[0], -1e-12);
        EXPECT_GT(values[1], 1e-6);
    }
}

TEST(Laplacian, NegativeWeightsAreKeptClampedOrFlippedAway) {
    const TriMesh kite = flat_kite();
    EXPECT_LT(-Matrix(build(kite, NegativeCotangents::keep).stiffness)(0, 1), -1.0);
    EXPECT_EQ(Matrix(build(kite, NegativeCotangents::clamp).stiffness)(0, 1), 0.0);
    const Matrix flipped = Matrix(build(kite, NegativeCotangents::intrinsic_delaunay).stiffness);
    EXPECT_EQ(flipped(0, 1), 0.0);
    EXPECT_LT(flipped(2, 3), -0.1);
    EXPECT_NEAR(build(kite, NegativeCotangents::intrinsic_delaunay).mass.sum(), 0.6, 1e-12);
}

TEST(Laplacian, DelaunayLeavesNoNegativeInnerWeightOnTheClosedSurface) {
    TriMesh mesh = test::sphere(10, 3);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        mesh.vertices(v, 2) *= 0.1;  // obtuse triangles
    const Matrix kept = Matrix(build(mesh, NegativeCotangents::keep).stiffness);
    const Matrix flipped = Matrix(build(mesh, NegativeCotangents::intrinsic_delaunay).stiffness);
    const auto largest_off_diagonal = [](Matrix m) {
        m.diagonal().setZero();
        return m.maxCoeff();
    };
    EXPECT_GT(largest_off_diagonal(kept), 0.01);
    EXPECT_LT(largest_off_diagonal(flipped), 1e-8);
}

TEST(Laplacian, DelaunayOfADelaunayMeshChangesNothing) {
    const TriMesh mesh = test::sphere(5, 2);
    const Matrix kept = Matrix(build(mesh, NegativeCotangents::keep).stiffness);
    const Matrix flipped = Matrix(build(mesh, NegativeCotangents::intrinsic_delaunay).stiffness);
    EXPECT_LT((kept - flipped).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Laplacian, FlippingKeepsTheAreaOfTheSurface) {
    TriMesh mesh = test::sphere(10, 3);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) mesh.vertices(v, 2) *= 0.1;
    const double before = build(mesh, NegativeCotangents::keep).mass.sum();
    IntrinsicTriangulation triangulation(mesh.vertices, mesh.triangles);
    EXPECT_GT(triangulation.make_delaunay(), 50u);
    double after = 0;
    for (const auto& t : triangulation.triangles()) after += t.area();
    EXPECT_NEAR(after, before, 1e-9 * before);
}

TEST(Mass, BothKindsAddUpToTheArea) {
    const TriMesh mesh = bumpy();
    const double area = build(mesh, NegativeCotangents::keep, MassKind::barycentric).mass.sum();
    for (const auto negative : {NegativeCotangents::keep, NegativeCotangents::clamp,
                                NegativeCotangents::intrinsic_delaunay}) {
        const Vector voronoi = build(mesh, negative).mass;
        EXPECT_GT(voronoi.minCoeff(), 0.0);
        if (negative != NegativeCotangents::intrinsic_delaunay) {
            EXPECT_NEAR(voronoi.sum(), area, 1e-10 * area);
        }
    }
}

TEST(Mass, ObtuseTriangleGivesHalfItsAreaToTheObtuseCorner) {
    TriMesh mesh;
    mesh.vertices.resize(3, 3);
    mesh.vertices << 0, 0.2, 0, -1, 0, 0, 1, 0, 0;
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    const Vector mass = build(mesh, NegativeCotangents::keep).mass;
    EXPECT_NEAR(mass[0], 0.1, 1e-14);
    EXPECT_NEAR(mass[1], 0.05, 1e-14);
}

TEST(Laplacian, IsRigidlyInvariantAndScalesWithTheUnit) {
    TriMesh mesh = bumpy();
    const LaplaceOperator before = build(mesh, NegativeCotangents::intrinsic_delaunay);
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    motion.translation << 100, -50, 3;
    motion.scale = 10;
    mesh.vertices = motion.apply(mesh.vertices);
    const LaplaceOperator after = build(mesh, NegativeCotangents::intrinsic_delaunay);
    EXPECT_LT(Matrix(before.stiffness - after.stiffness).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((100 * before.mass - after.mass).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Laplacian, NeedlesAndZeroAreaTrianglesStayFinite) {
    TriMesh mesh = test::grid(10, 10, 5, 5);
    mesh.vertices.row(7) = mesh.vertices.row(8);  // coincident vertices
    mesh.vertices.row(20) << 4, 6 + 1e-14, 0;     // nearly collinear
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 1, 3);
    mesh.triangles.bottomRows(1) << 3, 3, 4;  // not a triangle at all
    for (const auto negative : {NegativeCotangents::keep, NegativeCotangents::clamp,
                                NegativeCotangents::intrinsic_delaunay})
        for (const auto mass : {MassKind::barycentric, MassKind::mixed_voronoi}) {
            const LaplaceOperator laplace = build(mesh, negative, mass);
            const Matrix dense = Matrix(laplace.stiffness);
            EXPECT_TRUE(dense.allFinite());
            EXPECT_GT(laplace.mass.minCoeff(), 0.0);
            EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix>(dense).eigenvalues()[0],
                      -1e-10 * dense.cwiseAbs().maxCoeff());
        }
}

TEST(Laplacian, EverythingInOnePlaceStaysFinite) {
    TriMesh mesh = test::grid(1, 1, 3, 3);
    mesh.vertices.setZero();
    const LaplaceOperator laplace = build(mesh, NegativeCotangents::intrinsic_delaunay);
    EXPECT_TRUE(Matrix(laplace.stiffness).allFinite());
    EXPECT_GT(laplace.mass.minCoeff(), 0.0);
}

TEST(Laplacian, NonManifoldEdgesAreHingesThatAreNeverFlipped) {
    TriMesh mesh = flat_kite();
    mesh.vertices.conservativeResize(5, 3);
    mesh.vertices.row(4) << 0, 0, 0.3;
    mesh.triangles.conservativeResize(3, 3);
    mesh.triangles.row(2) << 0, 1, 4;
    IntrinsicTriangulation triangulation(mesh.vertices, mesh.triangles);
    EXPECT_EQ(triangulation.make_delaunay(), 0u);
    EXPECT_TRUE(Matrix(build(mesh, NegativeCotangents::intrinsic_delaunay).stiffness).allFinite());
}

TEST(Laplacian, TrianglesOfOppositeOrientationAreNotFlipped) {
    TriMesh mesh = flat_kite();
    mesh.triangles.row(1) << 0, 1, 3;
    IntrinsicTriangulation triangulation(mesh.vertices, mesh.triangles);
    EXPECT_EQ(triangulation.make_delaunay(), 0u);
}

TEST(Laplacian, VerticesWithoutTrianglesGetAMassAndNoWeight) {
    TriMesh mesh = test::grid(2, 2, 2, 2);
    mesh.vertices.conservativeResize(10, 3);
    mesh.vertices.row(9) << 50, 50, 50;
    const LaplaceOperator laplace = build(mesh, NegativeCotangents::intrinsic_delaunay);
    EXPECT_GT(laplace.mass[9], 0.0);
    EXPECT_EQ(Matrix(laplace.stiffness).row(9).norm(), 0.0);
}

TEST(Laplacian, RefusesWhatIsNoMesh) {
    TriMesh mesh = test::grid(2, 2, 2, 2);
    mesh.vertices(4, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(test::status_of([&] { build(mesh, NegativeCotangents::keep); }),
              Status::invalid_mesh);
    mesh = test::grid(2, 2, 2, 2);
    mesh.triangles(3, 1) = 9;
    EXPECT_EQ(test::status_of([&] { build(mesh, NegativeCotangents::keep); }),
              Status::invalid_mesh);
    EXPECT_EQ(test::status_of([&] { build(TriMesh(), NegativeCotangents::keep); }),
              Status::invalid_mesh);
}

}  // namespace
}  // namespace mien
