// What no scanner sees is no change, wherever a fit puts it.
#include <gtest/gtest.h>

#include "study/study.hpp"
#include "unit/registration/pocket.hpp"

namespace mien {
namespace {

constexpr Index kPlate = test::kPlateSide * test::kPlateSide;

StudyFace fitted(const TriMesh& mesh, int visit) {
    StudyFace face;
    face.mesh = std::make_shared<TriMesh>(mesh);
    face.normal_sd_mm = face.place_sd_mm = Vector::Constant(mesh.vertices.rows(), 0.1);
    face.weights = Vector::Zero(mesh.vertices.rows());
    face.weights.head(kPlate).setOnes();
    face.visit = visit;
    return face;
}

/// Of a plate, the vertices that are `rim` cells or more from its rim.
void add_middle(Zone& zone, int plate, int rim) {
    for (int j = rim; j < test::kPlateSide - rim; ++j)
        for (int i = rim; i < test::kPlateSide - rim; ++i)
            zone.vertices.push_back(
                static_cast<std::uint32_t>((plate * test::kPlateSide + j) * test::kPlateSide + i));
}

/// The second visit's fit guesses both walls 0.5 mm higher under unchanged skin.
Study made(bool unseen) {
    const TriMesh before = test::pocket();
    TriMesh after = before;
    after.vertices.bottomRows(2 * kPlate).col(2).array() += 0.5;
    after.vertices.middleRows(2 * kPlate, kPlate).col(2).array() += 0.4;
    StudySettings settings;
    Zone nose{"nose", {}}, sac{"sac", {}};
    add_middle(nose, 0, 0);
    for (const int wall : {1, 2}) {
        add_middle(nose, wall, 7);
        add_middle(sac, wall, 7);
    }
    settings.zones.zones = {nose, sac};
    settings.zones.stable = {"nose"};
    settings.zones.unseen = unseen;
    return Study(Context(), nullptr, {fitted(before, 0), fitted(after, 1)}, settings);
}

TEST(StudyWalls, AGuessBehindTheSkinIsNoChangeOfItsZone) {
    const Study open = made(false);
    const ZoneChange& nose = open.change(0, 1).zones[0];
    EXPECT_NEAR(nose.signed_ml.value, 0.0, 1e-6);
    EXPECT_NEAR(nose.absolute_ml.value, 0.0, 1e-6);
    EXPECT_EQ(nose.detected, 0);
    EXPECT_GT(nose.seen_share, 0.9);
    EXPECT_EQ(open.zones()[0].vertices.size(), static_cast<std::size_t>(kPlate));
    EXPECT_GT(made(true).change(0, 1).zones[0].absolute_ml.value, 0.1);
}

TEST(StudyWalls, AZoneOfWallsAloneStaysAndIsUnseen) {
    const Study open = made(false);
    EXPECT_GT(open.zones()[1].vertices.size(), 0u);
    EXPECT_EQ(open.change(0, 1).zones[1].reason, WhyUnknown::unseen);
}

/// Skin under hair in both visits was guessed, and the guess was read as a change.
TEST(StudyWalls, SkinThatNoVisitSawIsNoChangeAndCountsAsUnseen) {
    const TriMesh before = test::pocket();
    TriMesh after = before;
    StudyFace first = fitted(before, 0), second = fitted(before, 1);
    Zone skin{"skin", {}};
    add_middle(skin, 0, 0);
    for (Index v = 0; v < kPlate / 2; ++v) {
        first.weights[v] = second.weights[v] = 0;
        after.vertices(v, 2) += 1;
    }
    second.mesh = std::make_shared<TriMesh>(after);
    StudySettings settings;
    Zone held{"held", {}};  // far from the hair
    for (Index v = 2 * kPlate / 3; v < kPlate; ++v)
        held.vertices.push_back(static_cast<std::uint32_t>(v));
    settings.zones.zones = {skin, held};
    settings.zones.stable = {"held"};
    const ZoneChange change =
        Study(Context(), nullptr, {first, second}, settings).change(0, 1).zones[0];
    EXPECT_NEAR(change.seen_share, 0.5, 0.05);
    EXPECT_LT(change.absolute_ml.value, 0.05);
    second.weights.setOnes();
    EXPECT_GT(Study(Context(), nullptr, {first, second}, settings)
                  .change(0, 1)
                  .zones[0]
                  .absolute_ml.value,
              0.2);
}

TEST(StudyWalls, OpenSkinKeepsEveryVertex) {
    std::vector<Zone> zones{{"all", {0, 1, 2}}, {"walls", {3}}};
    leave_out(zones, {0, 0, 1, 1});
    EXPECT_EQ(zones[0].vertices, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(zones[1].vertices, (std::vector<std::uint32_t>{3}));
}

}  // namespace
}  // namespace mien
