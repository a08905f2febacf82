#include "registration/shifted_landmarks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

/// Landmarks on a grid of 5 x 5, picked 1 mm off to alternating sides, on places at rest.
struct Picked {
    Points places = Points(25, 3);
    std::vector<Pin> pins = std::vector<Pin>(25);

    Picked() {
        for (Index k = 0; k < 25; ++k) {
            const double x = 20.0 * static_cast<double>(k % 5),
                         y = 25.0 * static_cast<double>(k / 5);
            places.row(k) << x, y, 0;
            Pin& pin = pins[static_cast<std::size_t>(k)];
            pin.vertex = k;
            pin.place = Vector3(x, y, k % 2 == 0 ? 1 : -1);
        }
    }
};

TEST(ShiftedLandmarks, AShiftCommonToAllIsFound) {
    Picked picked;
    for (Pin& pin : picked.pins) pin.place += Vector3(0, 3, -2);
    const auto found = common_misfit(picked.pins, picked.places, {});
    ASSERT_TRUE(found);
    EXPECT_LT((found->mean - Vector3(0, 3, -2)).norm(), 0.1);
}

TEST(ShiftedLandmarks, ErrorsOfPickingAreNone) {
    const Picked picked;
    EXPECT_FALSE(common_misfit(picked.pins, picked.places, {}));
}

// An open mouth that the fit does not follow is no shift of the landmarks.
TEST(ShiftedLandmarks, AShiftOfTheLowerOnesAloneIsNone) {
    Picked picked;
    for (std::size_t k = 0; k < 10; ++k) picked.pins[k].place += Vector3(0, -6, 0);
    EXPECT_FALSE(common_misfit(picked.pins, picked.places, {}));
}

TEST(ShiftedLandmarks, FewOnesOfALargeErrorAreNone) {
    Picked picked;
    picked.pins.resize(4);
    for (Pin& pin : picked.pins) pin.place += Vector3(0, 0.8, 0);
    EXPECT_FALSE(common_misfit(picked.pins, picked.places, {}));
}

// A fit that yields to its landmarks shows a share of what they are off by.
TEST(ShiftedLandmarks, TheWholeShiftIsFoundFromShares) {
    const ShiftedLandmarkSettings settings;
    const Vector3 truth(5, -6, 2);
    for (const double share : {0.3, 0.5, 0.7, 0.95}) {
        const auto misfit = [&](const Vector3& shift) {
            const Vector3 mean = share * (truth - shift);
            return Misfit{mean, std::hypot(2.0, mean.norm())};
        };
        ShiftSearch search(misfit(Vector3::Zero()), settings);
        Vector3 kept = Vector3::Zero();
        for (int k = 0; k < settings.most_fits && !search.settled(); ++k) {
            const Vector3 tried = search.shift();
            if (search.take(misfit(tried))) kept = tried;
        }
        EXPECT_LT((kept - truth).norm(), 1.2) << share;
    }
}

}  // namespace
}  // namespace mien
