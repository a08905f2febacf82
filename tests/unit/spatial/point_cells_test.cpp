// Neighbours by cells are those of a plain search.
#include "spatial/point_cells.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace mien {
namespace {

Points random_points(Index count, unsigned seed) {
    std::mt19937 random(seed);
    Points points(count, 3);
    for (Index i = 0; i < points.size(); ++i)
        points.data()[i] = 50.0 * (random() / 4294967296.0) - 20;
    return points;
}

std::vector<std::uint32_t> by_hand(const Points& points, const std::vector<std::uint32_t>& members,
                                   const Eigen::RowVector3d& centre, double width) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t i : members)
        if ((points.row(i) - centre).squaredNorm() < width * width) found.push_back(i);
    return found;
}

TEST(PointCells, FindsAllWithinAWidthInAscendingOrder) {
    const Points points = random_points(2000, 5);
    std::vector<std::uint32_t> members;
    for (std::uint32_t i = 0; i < 2000; i += 3) members.push_back(i);
    const PointCells cells(points, members, 7);
    std::vector<std::uint32_t> found;
    for (Index i = 0; i < 200; ++i) {
        const Eigen::RowVector3d centre = points.row(i) * 1.2;
        cells.around(centre, found);
        EXPECT_EQ(found, by_hand(points, members, centre, 7)) << i;
    }
}

TEST(PointCells, PointsFartherThanCellsCanBeNumberedAreFoundToo) {
    Points points = random_points(60, 9);
    points.bottomRows(30).array() += 1e9;
    std::vector<std::uint32_t> members(60);
    for (std::uint32_t i = 0; i < 60; ++i) members[i] = i;
    const PointCells cells(points, members, 10);
    std::vector<std::uint32_t> found;
    for (const Index i : {0, 45}) {
        cells.around(points.row(i), found);
        EXPECT_EQ(found, by_hand(points, members, points.row(i), 10)) << i;
    }
    cells.around(Eigen::RowVector3d::Constant(std::numeric_limits<double>::quiet_NaN()), found);
    EXPECT_TRUE(found.empty());
}

TEST(PointCells, OfNothingFindNothing) {
    const Points points(0, 3);
    std::vector<std::uint32_t> found{7};
    PointCells(points, {}, 1).around(Eigen::RowVector3d::Zero(), found);
    EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace mien
