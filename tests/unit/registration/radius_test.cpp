#include "registration/radius.hpp"

#include <gtest/gtest.h>

namespace mien {
namespace {

Verdict verdict_of(double face_mm, double nose_mm, double stated_mm) {
    Verdict v;
    for (const auto& [name, expected_mm] : {std::pair<const char*, double>("face", face_mm),
                                            std::pair<const char*, double>("nose", nose_mm)}) {
        v.zones.emplace_back();
        v.zones.back().name = name;
        v.zones.back().deviation_mm = stated_mm;
        v.expected.emplace_back();
        v.expected.back().zone = name;
        v.expected.back().expected_mm = expected_mm;
    }
    return v;
}

// A mask taken for skin, or a person outside the span: the posterior stays sure, the verdict does
// not, and the radius held 63 of 100 places under masks.
TEST(Radius, GrowsWithWhatTheVerdictExpectsOfTheZone) {
    const RadiusSettings settings;
    const Vector deviation = (Vector(4) << 1, 2, 1, 3).finished();
    const std::vector<Zone> zones = {{"face", {0, 1, 2, 3}}, {"nose", {1, 3}}};
    const Vector radius = radius95_mm(deviation, verdict_of(2, 4, 1), zones);
    for (const Index i : {0, 2})
        EXPECT_NEAR(radius[i], settings.of_sigma * settings.of_expected * 2 * deviation[i], 1e-12);
    for (const Index i : {1, 3})
        EXPECT_NEAR(radius[i], settings.of_sigma * settings.of_expected * 4 * deviation[i], 1e-12);
}

TEST(Radius, OfAnUnknownErrorIsTheDeviationsAlone) {
    const Vector deviation = (Vector(2) << 1, 2).finished();
    const Vector radius = radius95_mm(deviation, Verdict(), {});
    EXPECT_NEAR((radius - RadiusSettings().of_sigma * deviation).norm(), 0, 1e-12);
    EXPECT_EQ(radius95_mm(Vector(), verdict_of(2, 4, 1), {}).size(), 0);
}

TEST(Radius, IsBoundedAndReadsNoVertexBeyondTheFit) {
    const RadiusSettings settings;
    const Vector deviation = (Vector(2) << 1, 2).finished();
    const std::vector<Zone> zones = {{"nose", {1, 7}}};
    const Vector radius = radius95_mm(deviation, verdict_of(1e-6, 1e9, 1), zones);
    EXPECT_NEAR(radius[0], settings.of_sigma * settings.least_factor, 1e-12);
    EXPECT_NEAR(radius[1], settings.of_sigma * settings.most_factor * 2, 1e-12);
}

}  // namespace
}  // namespace mien
