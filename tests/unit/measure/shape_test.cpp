#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "measure/curvature_summary.hpp"
#include "measure/lengths.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

constexpr double kStraightAngle = 3.14159265358979323846;

// A sphere with a cap that bulges: two zones of known curvature.
TEST(CurvatureSummary, OfASphereIsThatOfItsRadiusInEveryZone) {
    const TriMesh mesh = test::sphere(40, 5);
    std::vector<Zone> zones(2);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        zones[mesh.vertices(v, 1) > 10 ? 0 : 1].vertices.push_back(static_cast<std::uint32_t>(v));
    zones[0].name = "top";
    const CurvatureReport report =
        measure_curvature(mesh.vertices, mesh.triangles, zones, {3.0, true}, {});
    for (const CurvatureSummary* s : {&report.whole, &report.zones[0], &report.zones[1]}) {
        EXPECT_NEAR(s->mean_mean_per_mm, 1.0 / 40, 0.002 / 40);
        EXPECT_NEAR(s->mean_gaussian_per_mm2, 1.0 / 1600, 0.005 / 1600);
        EXPECT_NEAR(s->bending_per_mm, 1.0 / 40, 0.003 / 40);
        EXPECT_LT(s->sd_mean_per_mm, 0.01 / 40);
    }
    EXPECT_EQ(report.zones[0].name, "top");
    // Gauss and Bonnet: the integral over the closed surface is 4 pi.
    EXPECT_NEAR(report.whole.mean_gaussian_per_mm2 * 4 * kStraightAngle * 1600, 4 * kStraightAngle,
                0.01 * 4 * kStraightAngle);
}

TEST(CurvatureSummary, WeighsWithAreasAndNotWithVertices) {
    // A quarter of the grid is a cylinder's coat; the vertices there stand four times closer.
    TriMesh mesh = test::grid(120, 30, 120, 30);
    const double radius = 20;
    double bent_area = 0;
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const double x = mesh.vertices(v, 0);
        if (x <= 60) {
            mesh.vertices(v, 0) = radius * std::sin(0.25 * x / radius);
            mesh.vertices(v, 2) = radius * std::cos(0.25 * x / radius) - radius;
        } else {  // straight on along the tangent
            const double angle = 15 / radius;
            mesh.vertices(v, 0) = radius * std::sin(angle) + (x - 60) * std::cos(angle);
            mesh.vertices(v, 2) = radius * std::cos(angle) - radius - (x - 60) * std::sin(angle);
        }
    }
    bent_area = 15 * 30;
    const double area = bent_area + 60 * 30;
    const CurvatureSummary whole =
        measure_curvature(mesh.vertices, mesh.triangles, {}, {3.0, false}, {}).whole;
    EXPECT_NEAR(whole.mean_maximal_per_mm, bent_area / area / radius,
                0.15 * bent_area / area / radius);
    EXPECT_NEAR(whole.mean_gaussian_per_mm2, 0.0, 1e-5);
}

TEST(CurvatureSummary, RefusesDamagedSurfacesAndZones) {
    TriMesh mesh = test::sphere(40, 2);
    EXPECT_EQ(test::status_of([&] {
                  measure_curvature(mesh.vertices, mesh.triangles, {{"x", {9999}}}, {}, {});
              }),
              Status::mismatch);
    EXPECT_EQ(test::status_of([&] {
                  measure_curvature(mesh.vertices, mesh.triangles, {}, {0.0, true}, {});
              }),
              Status::invalid_argument);
    mesh.vertices(3, 1) = std::nan("");
    EXPECT_EQ(
        test::status_of([&] { measure_curvature(mesh.vertices, mesh.triangles, {}, {}, {}); }),
        Status::invalid_mesh);
}

TEST(Lengths, OnASphereAreChordAndArc) {
    const TriMesh mesh = test::sphere(70, 5);
    const auto nearest = [&](const Eigen::RowVector3d& place) {
        Index v = 0;
        (mesh.vertices.rowwise() - place).rowwise().squaredNorm().minCoeff(&v);
        return static_cast<std::uint32_t>(v);
    };
    const std::uint32_t top = nearest({0, 70, 0}), side = nearest({70, 0, 0}),
                        low = nearest({0, -70, 0});
    const auto lengths = measure_lengths(mesh.vertices, mesh.triangles,
                                         {{top, side}, {side, top}, {top, low}, {low, low}}, {});
    EXPECT_NEAR(lengths[0].straight_mm, 70 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(lengths[0].geodesic_mm, 70 * kStraightAngle / 2, 0.01 * 70 * kStraightAngle / 2);
    EXPECT_EQ(lengths[0].geodesic_mm, lengths[1].geodesic_mm);
    EXPECT_NEAR(lengths[2].straight_mm, 140, 1e-9);
    EXPECT_NEAR(lengths[2].geodesic_mm, 70 * kStraightAngle, 0.01 * 70 * kStraightAngle);
    EXPECT_EQ(lengths[3].straight_mm, 0);
    EXPECT_EQ(lengths[3].geodesic_mm, 0);
}

TEST(Lengths, AreInfiniteBetweenPiecesAndRefuseUnknownVertices) {
    TriMesh mesh = test::grid(20, 20, 10, 10);
    const Index n = mesh.vertices.rows(), m = mesh.triangles.rows();
    mesh.vertices.conservativeResize(2 * n, 3);
    mesh.vertices.bottomRows(n) =
        mesh.vertices.topRows(n).rowwise() + Eigen::RowVector3d(100, 0, 0);
    mesh.triangles.conservativeResize(2 * m, 3);
    mesh.triangles.bottomRows(m) =
        mesh.triangles.topRows(m).array() + static_cast<std::uint32_t>(n);
    const auto apart =
        measure_lengths(mesh.vertices, mesh.triangles, {{0, static_cast<std::uint32_t>(n)}}, {});
    EXPECT_NEAR(apart[0].straight_mm, 100, 1e-9);
    EXPECT_TRUE(std::isinf(apart[0].geodesic_mm));
    EXPECT_EQ(test::status_of([&] {
                  measure_lengths(mesh.vertices, mesh.triangles,
                                  {{0, static_cast<std::uint32_t>(2 * n)}}, {});
              }),
              Status::mismatch);
}

}  // namespace
}  // namespace mien
