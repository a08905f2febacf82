#include "base/scalar_math.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace mien {
namespace {

TEST(ScalarMath, FadeIsARampThatStartsAndEndsFlat) {
    EXPECT_EQ(fade(-3), 0);
    EXPECT_EQ(fade(0), 0);
    EXPECT_EQ(fade(0.5), 0.5);
    EXPECT_EQ(fade(1), 1);
    EXPECT_EQ(fade(7), 1);
    EXPECT_LT(fade(1e-4), 1e-7);
    EXPECT_GT(fade(1 - 1e-4), 1 - 1e-7);
    for (double x = 0; x < 1; x += 0.01) EXPECT_LT(fade(x), fade(x + 0.01));
}

TEST(ScalarMath, DegreesAndPiFitTheLibrarysTrigonometry) {
    EXPECT_EQ(kPi, std::acos(-1.0));
    EXPECT_DOUBLE_EQ(std::sin(30 * kRadiansPerDegree), 0.5);
}

}  // namespace
}  // namespace mien
