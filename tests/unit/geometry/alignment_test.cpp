#include "geometry/alignment.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"

namespace mien {
namespace {

Points some_points() {
    Points p(6, 3);
    p << 0, 0, 0, 10, 1, 0, 3, 12, -4, -7, 2, 9, 5, 5, 5, -1, -8, 3;
    return p;
}

Similarity some_motion(double scale) {
    Similarity m;
    m.rotation = Eigen::AngleAxisd(2.4, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    m.translation = Vector3(100, -250, 33);
    m.scale = scale;
    return m;
}

// The decomposition's own verdict was not asked: points with NaN were said to lie on one line.
TEST(Alignment, PointsThatAreNotFiniteAreNamedAsSuch) {
    Points bad = some_points();
    bad(2, 1) = std::nan("");
    try {
        align_points(bad, some_points(), {}, false);
        FAIL() << "points with NaN were aligned";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::no_solution);
        EXPECT_NE(std::string(error.what()).find("not finite"), std::string::npos);
    }
}

TEST(Alignment, RecoversASimilarity) {
    const Similarity truth = some_motion(1.3);
    const Similarity found = align_points(some_points(), truth.apply(some_points()), {}, true);
    EXPECT_LT((found.rotation - truth.rotation).norm(), 1e-12);
    EXPECT_LT((found.translation - truth.translation).norm(), 1e-10);
    EXPECT_NEAR(1.3, found.scale, 1e-12);
}

TEST(Alignment, RigidKeepsTheScale) {
    const Similarity found =
        align_points(some_points(), some_motion(1.3).apply(some_points()), {}, false);
    EXPECT_EQ(1.0, found.scale);
    EXPECT_LT((found.rotation - some_motion(1).rotation).norm(), 1e-12);
}

TEST(Alignment, ZeroWeightHidesAnOutlier) {
    Points target = some_motion(1).apply(some_points());
    target.row(2) += Eigen::RowVector3d(500, 0, 0);
    Vector weights = Vector::Ones(6);
    weights[2] = 0;
    EXPECT_LT(
        (align_points(some_points(), target, weights, true).rotation - some_motion(1).rotation)
            .norm(),
        1e-12);
}

TEST(Alignment, NeverReturnsAReflection) {
    Points mirrored = some_points();
    mirrored.col(0) *= -1;
    EXPECT_NEAR(1.0, align_points(some_points(), mirrored, {}, true).rotation.determinant(), 1e-12);
}

TEST(Alignment, RefusesCollinearAndFewPoints) {
    Points line(4, 3);
    line << 0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 5, 5;
    EXPECT_THROW(align_points(line, line, {}, true), Error);
    EXPECT_THROW(align_points(some_points().topRows(2), some_points().topRows(2), {}, true), Error);
    EXPECT_THROW(align_points(some_points(), some_points().topRows(5), {}, true), Error);
}

TEST(Similarity, InverseUndoes) {
    const Similarity m = some_motion(0.7);
    EXPECT_LT((m.inverse().apply(m.apply(some_points())) - some_points()).cwiseAbs().maxCoeff(),
              1e-12);
}

}  // namespace
}  // namespace mien
