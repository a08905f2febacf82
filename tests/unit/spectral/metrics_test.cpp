#include "spectral/metrics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/normals.hpp"
#include "mesh/topology.hpp"
#include "shapes.hpp"
#include "spectral/flat_vertices.hpp"

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

/// Every triangle in three, at its centroid.
TriMesh split_at_centroids(const TriMesh& mesh) {
    TriMesh split;
    const Index n = mesh.vertices.rows(), m = mesh.triangles.rows();
    split.vertices.resize(n + m, 3);
    split.vertices.topRows(n) = mesh.vertices;
    split.triangles.resize(3 * m, 3);
    for (Index f = 0; f < m; ++f) {
        const auto centre = static_cast<std::uint32_t>(n + f);
        split.vertices.row(centre).setZero();
        for (int c = 0; c < 3; ++c) {
            split.vertices.row(centre) += mesh.vertices.row(mesh.triangles(f, c)) / 3;
            split.triangles.row(3 * f + c) << mesh.triangles(f, c), mesh.triangles(f, (c + 1) % 3),
                centre;
        }
    }
    return split;
}

/// Every triangle in four, at the middles of its sides.
TriMesh split_at_middles(const TriMesh& mesh) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), {});
    TriMesh split;
    const Index n = mesh.vertices.rows(), m = mesh.triangles.rows();
    split.vertices.resize(n + static_cast<Index>(table.num_edges()), 3);
    split.vertices.topRows(n) = mesh.vertices;
    std::vector<std::uint32_t> middle(static_cast<std::size_t>(3 * m));
    for (std::size_t e = 0; e < table.num_edges(); ++e) {
        const auto at = static_cast<std::uint32_t>(n) + static_cast<std::uint32_t>(e);
        split.vertices.row(at) =
            (mesh.vertices.row(table.edges[e][0]) + mesh.vertices.row(table.edges[e][1])) / 2;
        for (std::uint32_t s = table.first_side[e]; s < table.first_side[e + 1]; ++s)
            middle[table.sides[s]] = at;
    }
    split.triangles.resize(4 * m, 3);
    for (Index f = 0; f < m; ++f) {
        const std::uint32_t* mid = &middle[static_cast<std::size_t>(3 * f)];
        for (int c = 0; c < 3; ++c)
            split.triangles.row(4 * f + c) << mesh.triangles(f, c), mid[c], mid[(c + 2) % 3];
        split.triangles.row(4 * f + 3) << mid[0], mid[1], mid[2];
    }
    return split;
}

/// As a PLY file keeps it.
TriMesh in_floats(const TriMesh& mesh) {
    return with(mesh, mesh.vertices.cast<float>().cast<double>());
}

// Vertices at the centroids have no angle defect by construction; the power of 0.15 made 0.498 of
// them where 0.11 mm of noise makes as much.
TEST(Fmpd, OfASurfaceWithSplitTrianglesIsZero) {
    for (const TriMesh& mesh : {test::face_like(30), test::sphere(50, 4)}) {
        const TriMesh thirds = split_at_centroids(mesh), quarters = split_at_middles(mesh);
        EXPECT_LT(fmpd(mesh, thirds, {}), 1e-9);
        EXPECT_LT(fmpd(mesh, quarters, {}), 1e-9);
        EXPECT_LT(fmpd(mesh, split_at_centroids(quarters), {}), 1e-9);
        EXPECT_LT(fmpd(in_floats(mesh), in_floats(thirds), {}), 1e-4);
        // What is no split still counts.
        EXPECT_GT(fmpd(mesh, with(thirds, test::noisy(thirds.vertices, 0.05)), {}), 0.05);
    }
}

TEST(FlatVertices, AreThoseOfSplitsAlone) {
    const TriMesh mesh = test::face_like(12);
    const ReducedSurface same = without_flat_vertices(mesh, {});
    EXPECT_EQ(same.mesh.vertices, mesh.vertices);
    EXPECT_EQ(same.mesh.triangles, mesh.triangles);
    for (const TriMesh& split : {split_at_centroids(mesh), split_at_middles(mesh)}) {
        const ReducedSurface reduced = without_flat_vertices(split, {});
        EXPECT_EQ(reduced.mesh.vertices, mesh.vertices);
        EXPECT_EQ(reduced.mesh.triangles.rows(), mesh.triangles.rows());
        ASSERT_EQ(reduced.into.size(), static_cast<std::size_t>(split.vertices.rows()));
        for (Index v = 0; v < mesh.vertices.rows(); ++v)
            EXPECT_EQ(reduced.into[static_cast<std::size_t>(v)], static_cast<std::uint32_t>(v));
    }
    // A flat sheet keeps its corners, and its area.
    const ReducedSurface flat = without_flat_vertices(test::grid(10, 10, 6, 6), {});
    EXPECT_LT(flat.mesh.vertices.rows(), 10);
    EXPECT_NEAR(
        triangle_normals(flat.mesh.vertices, flat.mesh.triangles).rowwise().norm().sum() / 2, 100.0,
        1e-9);
}

TEST(FlatVertices, LeaveBrokenMeshesInPeace) {
    TriMesh mesh = split_at_centroids(test::face_like(8));
    mesh.triangles.row(3) = mesh.triangles.row(2);  // doubled
    mesh.triangles(9, 1) = mesh.triangles(9, 0);    // degenerate
    mesh.triangles.row(20).reverseInPlace();        // turned over
    mesh.vertices.row(mesh.triangles(40, 0)) = mesh.vertices.row(mesh.triangles(40, 1));
    const ReducedSurface reduced = without_flat_vertices(mesh, {});
    EXPECT_LE(reduced.mesh.triangles.rows(), mesh.triangles.rows());
    EXPECT_LT(reduced.mesh.triangles.maxCoeff(),
              static_cast<std::uint32_t>(reduced.mesh.vertices.rows()));
}

TEST(Perception, FieldsShowWhereTheDistanceComesFrom) {
    const TriMesh mesh = test::face_like(30);
    TriMesh other = mesh;
    const Index middle = 15 * 31 + 15;
    other.vertices(middle, 2) += 0.5;
    for (const Vector& field : {dame_field(mesh, other, {}), fmpd_field(mesh, other, {}),
                                vertex_distances(mesh.vertices, other.vertices, false),
                                surface_distances(other, mesh, {})}) {
        Index where = 0;
        field.cwiseAbs().maxCoeff(&where);
        EXPECT_NEAR(static_cast<double>(where % 31), 15, 1.5);
        EXPECT_NEAR(static_cast<double>(where / 31), 15, 1.5);
        EXPECT_EQ(field[40], 0.0);
    }
    EXPECT_GT(fmpd_field(mesh, other, {})[middle], 0);  // rougher
    EXPECT_NEAR(vertex_distances(mesh.vertices, other.vertices, true).sum(), 0.5, 1e-12);
    EXPECT_EQ(fmpd_field(mesh, mesh, {}).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ(test::status_of([&] { fmpd_field(mesh, test::sphere(1, 1), {}); }), Status::mismatch);
}

TEST(Perception, RoughnessOfASplitMeshIsThatOfItsCorners) {
    const TriMesh mesh = test::face_like(20);
    const Vector whole = local_roughness(mesh, {}),
                 split = local_roughness(split_at_centroids(mesh), {});
    EXPECT_LT((split.head(whole.size()) - whole).cwiseAbs().maxCoeff(), 1e-9);
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
