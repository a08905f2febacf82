#include "geometry/principal_frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "base/error.hpp"

namespace mien {
namespace {

/// Points of an ellipsoid that leans to one side of its two longer axes.
Points leaning_points() {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    Points points(2000, 3);
    for (Index i = 0; i < points.rows(); ++i) {
        const double a = normal(random), b = normal(random), c = normal(random);
        points.row(i) << 90 * (a + 0.2 * a * a), 60 * (b - 0.1 * b * b), 30 * c;
    }
    return points;
}

TEST(PrincipalFrame, TurnsWithTheSurfaceAndIsARotation) {
    const Points points = leaning_points();
    const Matrix3 frame = principal_frame(points, Triangles());
    EXPECT_NEAR(frame.determinant(), 1, 1e-12);
    EXPECT_GT(frame(0, 0), 0.99);
    EXPECT_LT(frame(1, 1), -0.99);
    for (const double angle_rad : {0.3, 1.6, 3.1}) {
        const Matrix3 turn =
            Eigen::AngleAxisd(angle_rad, Vector3(1, -2, 0.7).normalized()).toRotationMatrix();
        Points moved = points * turn.transpose();
        moved.rowwise() += Eigen::RowVector3d(300, -40, 1000);
        EXPECT_LT((principal_frame(moved, Triangles()) - turn * frame).norm(), 1e-6) << angle_rad;
    }
}

TEST(PrincipalFrame, GoesByAreaAndNotByHowFinelyItIsCut) {
    // A sheet of 4 x 2, bent up at one end; its right half is cut finely in the second.
    const auto sheet = [](Index fine) {
        Points vertices(0, 3);
        Triangles triangles(0, 3);
        const auto add = [&](double x0, double x1, Index count) {
            for (Index k = 0; k < count; ++k) {
                const double a = x0 + (x1 - x0) * static_cast<double>(k) / count,
                             b = x0 + (x1 - x0) * static_cast<double>(k + 1) / count;
                const Index v = vertices.rows(), t = triangles.rows();
                vertices.conservativeResize(v + 4, 3);
                vertices.bottomRows(4) << a, 0, std::max(0.0, a - 3), b, 0, std::max(0.0, b - 3), b,
                    2, std::max(0.0, b - 3), a, 2, std::max(0.0, a - 3);
                triangles.conservativeResize(t + 2, 3);
                const auto n = static_cast<std::uint32_t>(v);
                triangles.bottomRows(2) << n, n + 1, n + 2, n, n + 2, n + 3;
            }
        };
        add(0, 2, 20), add(2, 4, fine);
        return std::make_pair(vertices, triangles);
    };
    const auto coarse = sheet(20), fine = sheet(400);
    EXPECT_LT(
        (principal_frame(coarse.first, coarse.second) - principal_frame(fine.first, fine.second))
            .norm(),
        1e-6);
}

TEST(PrincipalFrame, OneOfNothingIsTheIdentityAndOfNoNumbersAnError) {
    EXPECT_EQ(principal_frame(Points(0, 3), Triangles()), Matrix3::Identity());
    Points points = leaning_points();
    points(7, 1) = std::nan("");
    EXPECT_THROW(principal_frame(points, Triangles()), Error);
}

}  // namespace
}  // namespace mien
