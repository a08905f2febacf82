#include "spectral/metrics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "shapes.hpp"

namespace mien {
namespace {

TriMesh with(const TriMesh& mesh, const Points& vertices) {
    TriMesh result = mesh;
    result.vertices = vertices;
    return result;
}
Similarity some_motion(double scale) {
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.8, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    motion.translation << 10, -200, 35;
    motion.scale = scale;
    return motion;
}

TEST(Distances, OfAShiftAreItsLength) {
    const TriMesh mesh = test::face_like();
    const Points moved = mesh.vertices.rowwise() + Eigen::RowVector3d(3, -4, 0);
    EXPECT_NEAR(l1_distance(mesh.vertices, moved), 7.0, 1e-12);
    EXPECT_NEAR(l2_distance(mesh.vertices, moved), 5.0, 1e-12);
}

TEST(Distances, HausdorffFindsTheFarthestVertexBothWays) {
    const TriMesh plane = test::grid(10, 10, 5, 5);
    TriMesh peak = plane;
    peak.vertices(14, 2) = 4;
    EXPECT_NEAR(hausdorff_distance(plane, peak, {}), 4.0, 1e-12);
    EXPECT_NEAR(hausdorff_distance(peak, plane, {}), 4.0, 1e-12);
    EXPECT_NEAR(hausdorff_distance(plane, test::grid(10, 10, 8, 3), {}), 0.0, 1e-12);
}

TEST(Dame, MeasuresTheChangeOfACrease) {
    TriMesh flat = test::grid(2, 1, 2, 1), folded;
    folded = flat;
    const double angle = 0.3;
    for (Index v = 0; v < flat.vertices.rows(); ++v)
        if (flat.vertices(v, 0) > 1.5) {
            folded.vertices(v, 0) = 1 + std::cos(angle);
            folded.vertices(v, 2) = std::sin(angle);
        }
    // Three inner edges of equal weight, flat in the reference (mask 1); one of them folds.
    EXPECT_NEAR(dame(flat, folded, {}), angle / 3, 1e-12);
}

TEST(Dame, IsZeroForTheSameAndUnderSimilarity) {
    const TriMesh mesh = test::face_like();
    EXPECT_EQ(dame(mesh, mesh, {}), 0.0);
    const TriMesh other = with(mesh, test::noisy(mesh.vertices, 0.2));
    const double value = dame(mesh, other, {});
    EXPECT_GT(value, 0.01);
    EXPECT_NEAR(dame(mesh, with(mesh, some_motion(1).apply(other.vertices)), {}), value, 1e-10);
    EXPECT_NEAR(dame(with(mesh, some_motion(3).apply(mesh.vertices)), other, {}), value, 1e-10);
    EXPECT_NEAR(dame(mesh, with(mesh, some_motion(0.01).apply(mesh.vertices)), {}), 0.0, 1e-10);
}

TEST(Dame, KeepsSmallAngles) {
    const TriMesh flat = test::grid(10, 10, 10, 10);
    TriMesh bumped = flat;
    bumped.vertices(60, 2) = 1e-9;
    EXPECT_GT(dame(flat, bumped, {}), 1e-12);
}

TEST(Fmpd, IsZeroForTheSameAndUnderSimilarity) {
    const TriMesh mesh = test::sphere(50, 3);
    EXPECT_EQ(fmpd(mesh, mesh, {}), 0.0);
    const TriMesh other = with(mesh, test::noisy(mesh.vertices, 0.5));
    const double value = fmpd(mesh, other, {});
    EXPECT_GT(value, 0.01);
    EXPECT_NEAR(fmpd(other, mesh, {}), value, 1e-12);
    EXPECT_NEAR(fmpd(mesh, with(mesh, some_motion(1).apply(other.vertices)), {}), value, 1e-8);
    EXPECT_NEAR(fmpd(with(mesh, some_motion(7).apply(mesh.vertices)), other, {}), value, 1e-8);
}

TEST(Fmpd, ComparesTwoConnectivitiesOfOneSurface) {
    // Noise on one connectivity is farther from the smooth surface than another smooth
    // connectivity.
    const TriMesh coarse = test::sphere(50, 3), fine = test::sphere(50, 4);
    const TriMesh noisy = with(fine, test::noisy(fine.vertices, 0.5));
    EXPECT_LT(fmpd(coarse, fine, {}), 0.5 * fmpd(coarse, noisy, {}));
}

TEST(Perception, GrowsWithNoise) {
    const TriMesh mesh = test::face_like(30);
    double last_dame = 0, last_fmpd = 0;
    for (const double amplitude : {0.005, 0.01, 0.02, 0.05, 0.1}) {
        const TriMesh other = with(mesh, test::noisy(mesh.vertices, amplitude));
        const double d = dame(mesh, other, {}), f = fmpd(mesh, other, {});
        EXPECT_GT(d, last_dame) << amplitude;
        EXPECT_GT(f, last_fmpd) << amplitude;
        last_dame = d;
        last_fmpd = f;
    }
}

TEST(Perception, RanksNoiseWorseThanASmoothBendOfEqualDistance) {
    const TriMesh mesh = test::face_like(30);
    const TriMesh bent = with(mesh, test::bent(mesh.vertices, 0.1));
    Points shaken = test::noisy(mesh.vertices, 0.1);
    const double ratio =
        l2_distance(mesh.vertices, bent.vertices) / l2_distance(mesh.vertices, shaken);
    shaken = mesh.vertices + ratio * (shaken - mesh.vertices);
    EXPECT_NEAR(l2_distance(mesh.vertices, shaken), l2_distance(mesh.vertices, bent.vertices),
                1e-9);
    EXPECT_GT(dame(mesh, with(mesh, shaken), {}), 5 * dame(mesh, bent, {}));
    EXPECT_GT(fmpd(mesh, with(mesh, shaken), {}), 2 * fmpd(mesh, bent, {}));
}

TEST(Perception, SurvivesDegenerateTriangles) {
    TriMesh mesh = test::face_like();
    mesh.vertices.row(50) = mesh.vertices.row(51);
    const TriMesh other = with(mesh, test::noisy(mesh.vertices, 0.1));
    EXPECT_TRUE(std::isfinite(dame(mesh, other, {})));
    EXPECT_TRUE(std::isfinite(fmpd(mesh, other, {})));
}

TEST(Perception, RefusesWhatDoesNotFit) {
    const TriMesh mesh = test::face_like();
    TriMesh turned = mesh;
    turned.triangles.row(0).reverseInPlace();
    EXPECT_EQ(test::status_of([&] { dame(mesh, turned, {}); }), Status::mismatch);
    EXPECT_EQ(test::status_of([&] { dame(mesh, test::sphere(1, 1), {}); }), Status::mismatch);
    TriMesh cloud = mesh;
    cloud.triangles.resize(0, 3);
    EXPECT_EQ(test::status_of([&] { fmpd(mesh, cloud, {}); }), Status::invalid_mesh);
    EXPECT_EQ(test::status_of([&] { l1_distance(mesh.vertices, mesh.vertices.topRows(3)); }),
              Status::mismatch);
}

}  // namespace
}  // namespace mien
