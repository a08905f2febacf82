#include <mien/mien.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "handles.hpp"

namespace {

using mien_test::fresh_error;

constexpr int kSide = 12;

/// A bumpy sheet with 10 mm between its vertices; `lift` of its far corner, mm.
mien::Mesh face(const mien::Session& session, double lift, double noise = 0) {
    std::vector<mien::Position> positions;
    std::vector<mien::Triangle> triangles;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            positions.push_back({10.0 * x, 10.0 * y,
                                 8 * std::sin(0.5 * x) * std::cos(0.4 * y) +
                                     noise * std::sin(91.0 * x + 57.0 * y) +
                                     (x > 7 && y > 7 ? lift : 0)});
    for (int y = 0; y + 1 < kSide; ++y)
        for (int x = 0; x + 1 < kSide; ++x) {
            const auto a = static_cast<std::uint32_t>(y * kSide + x);
            triangles.push_back({a, a + 1, a + kSide});
            triangles.push_back({a + 1, a + kSide + 1, a + kSide});
        }
    return mien::Mesh(session, positions, triangles);
}

std::vector<double> all(double value, int faces = 1) {
    return std::vector<double>(static_cast<std::size_t>(faces * kSide * kSide), value);
}

mien::StudyOptions zones() {
    mien::StudyOptions options;
    options.zones = {{"still", {}}, {"corner", {}}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            if (x < 6 || y < 6)
                options.zones[0].vertices.push_back(static_cast<std::uint32_t>(y * kSide + x));
            else if (x > 7 && y > 7)
                options.zones[1].vertices.push_back(static_cast<std::uint32_t>(y * kSide + x));
    options.stable = {"still"};
    return options;
}

mien::Registration fit(const mien::Session& session, double lift, double noise = 0.01) {
    return mien::Registration(session, face(session, lift, noise), all(1), all(0.02), all(0.5),
                              MIEN_QUALITY_GOOD);
}

TEST(Study, RegistrationsGiveChangesWithTheirErrors) {
    const mien::Session session;
    const mien::Study study(session, {fit(session, 0), fit(session, 2, 0.02)}, nullptr, zones());
    EXPECT_EQ(study.visit_count(), 2);
    ASSERT_EQ(study.zone_count(), 2);
    EXPECT_EQ(study.zone_name(1), "corner");
    EXPECT_EQ(study.expression(0), "");
    const mien_study_change corner = study.change(0, 1, 1), still = study.change(0, 1, 0);
    EXPECT_EQ(corner.unknown, MIEN_STUDY_KNOWN);
    EXPECT_EQ(corner.detected, 1);
    EXPECT_EQ(still.detected, 0);
    EXPECT_LE(still.signed_ml.low, 0);
    EXPECT_GE(still.signed_ml.high, 0);
    EXPECT_GT(corner.signed_ml.low, 0.5 * corner.signed_ml.value);
    EXPECT_NEAR(corner.signed_ml.high - corner.signed_ml.value, 1.96 * corner.signed_ml.sd,
                1e-3 * corner.signed_ml.sd);
    EXPECT_NEAR(corner.absolute_ml.value, corner.gained_ml.value - corner.lost_ml.value, 1e-12);
    EXPECT_NEAR(corner.signed_ml.value, corner.gained_ml.value + corner.lost_ml.value, 1e-12);
    EXPECT_NEAR(corner.area_change_mm2.value, corner.area_after_mm2 - corner.area_before_mm2, 1e-9);
    EXPECT_EQ(corner.seen_share, 1);
    EXPECT_GT(study.alignment(0, 1).pairs, 10u);
    EXPECT_EQ(study.neutral(1, 0).positions().size(), all(0).size());
    EXPECT_EQ(study.neutral(1).positions(), face(session, 2, 0.02).positions());
    EXPECT_NEAR(study.distances_mm(0, 1)[kSide * kSide - 1], 2, 0.3);
    EXPECT_NEAR(study.field(0, MIEN_STUDY_FIELD_NORMAL_SD_MM)[5], std::hypot(0.08, 0.02), 1e-12);
    EXPECT_THROW(study.field(0, MIEN_STUDY_FIELD_EXPRESSION_SD_MM), mien::Exception);
    EXPECT_NE(study.json().find("\"changes_since_first\""), std::string::npos);
    auto* const shared = const_cast<mien_study*>(study.get());
    mien_study_retain(shared);
    mien_study_release(shared);
    EXPECT_EQ(study.visit_count(), 2);
}

TEST(Study, AWiderLevelGivesWiderIntervals) {
    const mien::Session session;
    const std::vector<mien::Registration> fits{fit(session, 0), fit(session, 2)};
    mien::StudyOptions options = zones();
    const double usual =
        mien::Study(session, fits, nullptr, options).change(0, 1, 1).signed_ml.high;
    options.c.level = 0.99;
    EXPECT_GT(mien::Study(session, fits, nullptr, options).change(0, 1, 1).signed_ml.high, usual);
}

TEST(Study, MeshesWithoutDeviationsHaveNoIntervals) {
    const mien::Session session;
    const std::vector<mien::Mesh> faces{face(session, 0), face(session, 2)};
    const mien_study_change bare =
        mien::Study(session, faces, {}, {}, nullptr, zones()).change(0, 1, 1);
    EXPECT_EQ(bare.unknown, MIEN_STUDY_NO_SURFACE_ERRORS);
    EXPECT_TRUE(std::isfinite(bare.signed_ml.value));
    EXPECT_TRUE(std::isnan(bare.signed_ml.low));
    EXPECT_TRUE(std::isnan(bare.signed_ml.limit_of_detection));
    EXPECT_TRUE(std::isnan(bare.seen_share));
    EXPECT_EQ(bare.detected, -1);
    const mien_study_change known =
        mien::Study(session, faces, all(0.1, 2), all(1, 2), nullptr, zones()).change(0, 1, 1);
    EXPECT_EQ(known.unknown, MIEN_STUDY_KNOWN);
    EXPECT_EQ(known.signed_ml.value, bare.signed_ml.value);
    EXPECT_GT(known.signed_ml.low, 0);
}

TEST(Study, ARecordOfAFitGivesTheSameBitsAsTheFit) {
    const mien::Session session;
    const mien::Registration before = fit(session, 0), after = fit(session, 2, 0.03);
    const std::string path = testing::TempDir() + "mien_abi_fit_record.safetensors";
    after.save(session, path);
    const mien::Registration read(session, path);
    EXPECT_EQ(read.json(), after.json());
    EXPECT_EQ(read.field(MIEN_REGISTRATION_NORMAL_DEVIATION_MM),
              after.field(MIEN_REGISTRATION_NORMAL_DEVIATION_MM));
    EXPECT_EQ(mien::Study(session, {before, after}, nullptr, zones()).json(),
              mien::Study(session, {before, read}, nullptr, zones()).json());
    std::remove(path.c_str());
    EXPECT_THROW(mien::Registration(session, path), mien::Exception);
}

TEST(Study, CapturesOfOneVisitTellTheLimitOfDetection) {
    const mien::Session session;
    std::vector<mien::Registration> fits;
    for (int k = 0; k < 3; ++k) fits.push_back(fit(session, 0, 0.05 + 0.01 * k));
    fits.push_back(fit(session, 0.02));
    mien::StudyOptions options = zones();
    options.visits = {0, 0, 0, 1};
    const mien::Study study(session, fits, nullptr, options);
    EXPECT_EQ(study.visit_count(), 2);
    EXPECT_NE(study.json().find("\"blanks\":3"), std::string::npos);
    options.visits = {0, 0, 1};
    EXPECT_THROW(mien::Study(session, fits, nullptr, options), mien::Exception);
    options.visits = {1, 1, 1, 1};
    EXPECT_THROW(mien::Study(session, fits, nullptr, options), mien::Exception);
}

TEST(Study, TreatedZonesStandAgainWithTheirMargin) {
    const mien::Session session;
    mien::StudyOptions options = zones();
    options.treated = {"corner"};
    const mien::Study study(session, {fit(session, 0), fit(session, 2)}, nullptr, options);
    ASSERT_EQ(study.zone_count(), 3);
    EXPECT_EQ(study.zone_name(2), "corner and 10 mm around");
    options.treated = {"elbow"};
    try {
        mien::Study(session, {fit(session, 0)}, nullptr, options);
        FAIL() << "a zone that is none is accepted";
    } catch (const mien::Exception& failure) {
        EXPECT_EQ(failure.status(), MIEN_E_NOT_FOUND);
        EXPECT_NE(std::string(failure.what()).find("elbow"), std::string::npos);
    }
}

TEST(Study, WrongInputIsRefusedAndLeavesNothingBehind) {
    const mien::Session session;
    const mien::Registration good = fit(session, 0);
    const mien_registration* list[] = {good.get(), nullptr};
    mien_error error = fresh_error();
    mien_study* study = reinterpret_cast<mien_study*>(&error);
    EXPECT_EQ(MIEN_E_INVALID_HANDLE,
              mien_study_create(session.get(), list, 2, nullptr, nullptr, &study, &error));
    EXPECT_EQ(nullptr, study);
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_study_create(session.get(), list, 0, nullptr, nullptr, &study, &error));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_study_create(session.get(), list, 1000, nullptr, nullptr, &study, &error));
    mien_study_options options;
    mien_study_options_init(&options, sizeof options);
    options.level = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_study_create(session.get(), list, 1, nullptr, &options, &study, &error));
    mien_study_options_init(&options, sizeof options);
    mien_cancel* cancel = nullptr;
    ASSERT_EQ(MIEN_OK, mien_cancel_create(&cancel, nullptr));
    mien_cancel_request(cancel);
    options.cancel = cancel;
    list[1] = good.get();
    EXPECT_EQ(MIEN_E_CANCELLED,
              mien_study_create(session.get(), list, 2, nullptr, &options, &study, &error));
    mien_cancel_release(cancel);
    // Without any zone the whole face holds still; one visit has no change.
    ASSERT_EQ(MIEN_OK, mien_study_create(session.get(), list, 1, nullptr, nullptr, &study, &error));
    mien_study_change change{};
    change.struct_size = sizeof change;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_study_get_change(study, 0, 1, 0, &change, &error));
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_E_NOT_FOUND, mien_study_get_mesh(study, 0, 1, &mesh, &error));
    EXPECT_EQ(MIEN_OK, mien_study_get_mesh(study, 0, 0, &mesh, &error));
    mien_mesh_release(mesh);
    mien_study_release(study);
    mien_study_release(nullptr);
    std::vector<double> wrong = all(1);
    wrong[3] = 2;
    EXPECT_THROW(mien::Registration(session, face(session, 0), wrong, {}, {}, MIEN_QUALITY_GOOD),
                 mien::Exception);
    EXPECT_THROW(mien::Registration(session, face(session, 0), {1.0}, {}, {}, MIEN_QUALITY_GOOD),
                 mien::Exception);
    EXPECT_THROW(mien::Registration(session, face(session, 0), {}, {}, {}, 7), mien::Exception);
    EXPECT_THROW(mien::Registration(session, face(session, 0), {}, {}, {}, 0)
                     .field(MIEN_REGISTRATION_NORMAL_DEVIATION_MM),
                 mien::Exception);
}

}  // namespace
