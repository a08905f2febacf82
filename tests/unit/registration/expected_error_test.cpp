#include "registration/expected_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "registration/registration.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

std::vector<ExpectedError> expected_of(const ZoneMeasures& zone, const WholeMeasures& whole = {}) {
    return expect_errors(whole, {zone, zone}, learned_error_tables());
}

// More of a trouble must never look better: a table of many numbers could learn that by chance.
TEST(ExpectedError, NeverFallsWhenTroubleGrows) {
    for (const ErrorTable* table : {&learned_error_tables().face, &learned_error_tables().zone})
        for (const ErrorCurve& curve : table->curves) {
            ASSERT_EQ(curve.at.size(), curve.value.size());
            EXPECT_TRUE(std::is_sorted(curve.at.begin(), curve.at.end()));
            if (curve.measure == FitMeasure::is_trained || curve.measure == FitMeasure::color_hold)
                EXPECT_TRUE(std::is_sorted(curve.value.rbegin(), curve.value.rend()));
            else
                EXPECT_TRUE(std::is_sorted(curve.value.begin(), curve.value.end()));
        }
}

TEST(ExpectedError, LiesWithinItsRange) {
    for (const double open_mm : {0.0, 0.2, 0.5, 1.0, 5.0}) {
        ZoneMeasures zone;
        zone.open_mm = open_mm;
        for (const ExpectedError& error : expected_of(zone)) {
            EXPECT_LE(error.low_mm, error.expected_mm);
            EXPECT_GE(error.high_mm, error.expected_mm);
        }
    }
}

TEST(ExpectedError, NamesTheMeasureThatRaisesItMost) {
    ErrorTables tables;
    tables.face = {0,
                   {{FitMeasure::unseen, 0, {0, 1}, {0, 1}}, {FitMeasure::turn, 0, {0, 1}, {0, 2}}},
                   {1},
                   {-0.5},
                   {0.5}};
    tables.zone = tables.face;
    tables.face_doubtful_mm = tables.zone_doubtful_mm = 2;
    tables.face_failed_mm = tables.zone_failed_mm = 6;
    ZoneMeasures face, nose;
    face.name = "face";
    face.unseen = 0.5;
    nose.name = "nose";
    nose.unseen = nose.turn = 1;
    const std::vector<ExpectedError> errors = expect_errors({}, {face, nose}, tables);
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_NEAR(errors[0].expected_mm, std::exp(0.5), 1e-12);
    EXPECT_EQ(errors[0].quality, FitQuality::good);
    EXPECT_EQ(errors[1].cause, FitMeasure::turn);
    EXPECT_EQ(errors[1].quality, FitQuality::failed);
    EXPECT_NE(reason_of(errors[1]).find("nose"), std::string::npos);
}

// Half a face is fitted somewhere, 60 mm off and more, with a score between those of faces and of
// no faces: it was called doubtful.
TEST(Verdict, ADoubtfulPoseOfABadFitHasFailed) {
    Verdict v;
    v.coverage = v.inlier_share = v.size_ratio = 1;
    v.mean_residual_mm = 0.2;
    v.searched = true;
    ZoneMeasures face;
    face.name = "face";
    for (const bool bad : {false, true}) {
        if (bad) {
            face.open_mm = face.stretch = face.deviation_mm = 8;
            face.unseen = 0.7;
            face.turn = 0.6;
            v.whole.kernel_deviation = v.whole.kernel_mm = 8;
            v.whole.size = 0.2;
            v.whole.folds = 0.01;
            v.whole.is_free = v.whole.search_miss = 1;
        }
        v.zones = {face};
        for (const double score : {0.54, 0.8}) {
            v.search_score = score;
            judge(v, VerdictLimits());
            const double expected_mm = v.expected.front().expected_mm;
            if (bad)
                EXPECT_GT(expected_mm, VerdictLimits().failed_search_mm);
            else
                EXPECT_LT(expected_mm, VerdictLimits().failed_search_mm);
            const bool lies_anywhere =
                v.reasons.size() > 1 && v.reasons.back().find("half a face") != std::string::npos;
            EXPECT_EQ(lies_anywhere, bad && score < 0.56);
            EXPECT_TRUE(!lies_anywhere || v.quality == FitQuality::failed);
            EXPECT_TRUE(bad || score > 0.56 || v.quality == FitQuality::doubtful);
        }
    }
}

// Trained modes once won on faces of another family, three times as far off as the kernel alone.
TEST(Priors, LandmarksSpeakAgainstTrainedModesThatDoNotSpanTheFace) {
    const SmallFace face = small_face();
    DeformationModel model = face.model;
    const Index n = model.num_vertices();
    struct Modes {
        std::shared_ptr<const void> kernel;
        Eigen::MatrixXf trained;
    };
    auto modes = std::make_shared<Modes>(Modes{model.storage, Eigen::MatrixXf::Zero(3 * n, 1)});
    for (Index i = 0; i < n; ++i) modes->trained(3 * i + 2, 0) = 0.5f;  // all to the front
    model.pca_modes = {modes->trained.data(), 3 * n, 1};
    model.storage = modes;
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult weighed = register_scan(model, scan, landmarks, {}, {});
    RegistrationSettings settings;
    settings.prior.weigh_trained = false;
    const RegistrationResult trusting = register_scan(model, scan, landmarks, settings, {});
    settings.prior.max_pca_modes = 0;
    const RegistrationResult kernel = register_scan(model, scan, landmarks, settings, {});
    EXPECT_EQ(weighed.verdict.whole.is_trained, 0);
    EXPECT_EQ(trusting.verdict.whole.is_trained, 1);
    EXPECT_EQ(weighed.fitted.vertices, kernel.fitted.vertices);
    EXPECT_FALSE(weighed.verdict.notes.empty());
}

}  // namespace
}  // namespace mien
