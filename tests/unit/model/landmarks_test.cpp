#include "model/landmarks.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Landmarks, AreFoundByTheirWholeNameOnly) {
    const std::vector<Landmark> landmarks{{"jaw_00", 3}, {"jaw_01", 5}, {"jaw_01", 7}};
    ASSERT_NE(find_landmark(landmarks, "jaw_01"), nullptr);
    EXPECT_EQ(find_landmark(landmarks, "jaw_01")->vertex, 5u) << "the first of equal names";
    EXPECT_EQ(find_landmark(landmarks, "jaw_0"), nullptr);
    EXPECT_EQ(find_landmark(landmarks, "JAW_00"), nullptr);
    EXPECT_EQ(find_landmark({}, "jaw_00"), nullptr);
    const std::vector<Zone> zones{{"chin", {1, 2}}};
    ASSERT_NE(find_zone(zones, "chin"), nullptr);
    EXPECT_EQ(find_zone(zones, "chin")->vertices.size(), 2u);
    EXPECT_EQ(find_zone(zones, ""), nullptr);
}

}  // namespace
}  // namespace mien
