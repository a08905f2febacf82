#include "registration/expected_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "registration/fit_surroundings.hpp"
#include "registration/registration.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

std::vector<ExpectedError> expected_of(const ZoneMeasures& zone, const WholeMeasures& whole = {}) {
    return expect_errors(whole, {zone, zone}, learned_error_tables());
}

// Plausible measures of a fit, each drawn on its own.
void draw(std::mt19937& chance, ZoneMeasures& zone, WholeMeasures& whole) {
    const auto up_to = [&](double most) {
        return std::uniform_real_distribution<double>(0, most)(chance);
    };
    zone.unseen = up_to(1), zone.residual_mm = up_to(1), zone.open_mm = up_to(3);
    zone.turn = up_to(0.3), zone.deviation_mm = up_to(5), zone.stretch = up_to(0.4);
    zone.landmark_mm = up_to(6), zone.open_most_mm = zone.open_mm + up_to(3);
    zone.asymmetry_mm = up_to(3), zone.shape_deviation = up_to(3), zone.slid_mm = up_to(5);
    zone.pin_far_mm = up_to(100), zone.pin_misfit_mm = up_to(6), zone.color_hold = up_to(1);
    zone.color_doubt = up_to(1);
    whole.search_miss = up_to(0.6), whole.landmark_misfit = up_to(4), whole.kernel_mm = up_to(8);
    whole.color_miss = up_to(1), whole.trained_deviation = up_to(3), whole.size = up_to(0.2);
    whole.kernel_deviation = up_to(1), whole.folds = up_to(0.003), whole.lips_miss = up_to(1);
    whole.brows_miss = up_to(1), whole.worst_open_mm = up_to(4), whole.worst_unseen = up_to(1);
    whole.landmarks_out = up_to(0.5), whole.is_free = up_to(1) > 0.5;
    whole.is_trained = up_to(1) > 0.5, whole.no_colors = up_to(1) > 0.5;
}

// More of a trouble must never look better: a table of many numbers could learn that by chance.
TEST(ExpectedError, NeverFallsWhenTroubleGrows) {
    std::mt19937 chance(7);
    const std::vector<double ZoneMeasures::*> of_zone = {
        &ZoneMeasures::unseen,      &ZoneMeasures::residual_mm,     &ZoneMeasures::open_mm,
        &ZoneMeasures::turn,        &ZoneMeasures::deviation_mm,    &ZoneMeasures::stretch,
        &ZoneMeasures::landmark_mm, &ZoneMeasures::open_most_mm,    &ZoneMeasures::asymmetry_mm,
        &ZoneMeasures::slid_mm,     &ZoneMeasures::shape_deviation, &ZoneMeasures::pin_misfit_mm,
        &ZoneMeasures::color_doubt};
    const std::vector<double WholeMeasures::*> of_whole = {
        &WholeMeasures::search_miss,   &WholeMeasures::landmark_misfit,
        &WholeMeasures::landmarks_out, &WholeMeasures::color_miss,
        &WholeMeasures::size,          &WholeMeasures::trained_deviation,
        &WholeMeasures::folds,         &WholeMeasures::kernel_deviation,
        &WholeMeasures::lips_miss,     &WholeMeasures::brows_miss,
        &WholeMeasures::worst_open_mm, &WholeMeasures::worst_unseen};
    for (int draws = 0; draws < 300; ++draws) {
        ZoneMeasures zone;
        WholeMeasures whole;
        draw(chance, zone, whole);
        const std::vector<ExpectedError> before = expected_of(zone, whole);
        const auto no_better = [&](const ZoneMeasures& worse_zone, const WholeMeasures& worse) {
            const std::vector<ExpectedError> after = expected_of(worse_zone, worse);
            for (std::size_t k = 0; k < after.size(); ++k)
                EXPECT_GE(after[k].expected_mm, before[k].expected_mm * (1 - 1e-12));
        };
        for (const auto measure : of_zone) {
            ZoneMeasures worse = zone;
            worse.*measure = worse.*measure * 1.7 + 0.01;
            no_better(worse, whole);
        }
        for (const auto measure : of_whole) {
            WholeMeasures worse = whole;
            worse.*measure = worse.*measure * 1.7 + 0.01;
            no_better(zone, worse);
        }
    }
}

TEST(ExpectedError, TablesAreWhole) {
    for (const ErrorTable* table : {&learned_error_tables().face, &learned_error_tables().zone}) {
        const std::size_t leaves = std::size_t{1} << table->depth;
        ASSERT_GT(table->leaves.size(), 0u);
        ASSERT_EQ(table->leaves.size() % leaves, 0u);
        ASSERT_EQ(table->splits.size(), table->leaves.size() / leaves * (leaves - 1) * 2);
        for (std::size_t k = 0; k < table->splits.size(); k += 2) {
            ASSERT_LT(table->splits[k], table->inputs.size());
            const std::size_t limits = table->inputs[table->splits[k]].limits.size();
            ASSERT_LT(table->splits[k + 1], std::max<std::size_t>(limits, 1));
        }
        for (const ErrorInput& input : table->inputs)
            EXPECT_TRUE(std::is_sorted(input.limits.begin(), input.limits.end()));
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
    // Two trees of one split: 0.5 for what is not seen, 2 for turned normals.
    tables.face = {0,
                   1,
                   0.5,
                   {{FitMeasure::unseen, 0, {0.2}}, {FitMeasure::turn, 0, {0.1}}},
                   {0, 0, 1, 0},
                   {0, 1, 0, 4},
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

// Two captures over each other were fitted between them, doubtful, and their zones called good.
TEST(Verdict, NoZoneIsGoodWhereTheWholeScanIsDoubted) {
    Verdict v;
    v.coverage = v.inlier_share = v.size_ratio = 1;
    v.mean_residual_mm = 0.2;
    v.zones.resize(2);
    v.zones[0].name = "face";
    v.zones[1].name = "nose";
    const auto qualities = [&] {
        judge(v, VerdictLimits());
        return std::vector<FitQuality>{v.quality, v.expected[0].quality, v.expected[1].quality};
    };
    using Qualities = std::vector<FitQuality>;
    constexpr auto good = FitQuality::good, doubtful = FitQuality::doubtful;
    EXPECT_EQ(qualities(), Qualities({good, good, good}));
    v.two_surfaces = "two pieces lie over each other";
    EXPECT_EQ(qualities(), Qualities({doubtful, doubtful, doubtful}));
    v.two_surfaces.clear();
    v.turned_over = true;
    EXPECT_EQ(qualities(), Qualities({doubtful, doubtful, doubtful}));
    v.turned_over = false;
    v.coverage = 0.01;
    EXPECT_EQ(qualities(), Qualities({FitQuality::failed, doubtful, doubtful}));
}

// The model with one trained mode that moves vertex i to the front by front_mm(i).
template <typename Front>
DeformationModel with_trained_mode(const DeformationModel& kernel, Front&& front_mm) {
    DeformationModel model = kernel;
    const Index n = model.num_vertices();
    struct Modes {
        std::shared_ptr<const void> kernel;
        Eigen::MatrixXf trained;
    };
    auto modes = std::make_shared<Modes>(Modes{model.storage, Eigen::MatrixXf::Zero(3 * n, 1)});
    for (Index i = 0; i < n; ++i) modes->trained(3 * i + 2, 0) = front_mm(i);
    model.pca_modes = {modes->trained.data(), 3 * n, 1};
    model.storage = modes;
    return model;
}

// Trained modes once won on faces of another family, three times as far off as the kernel alone.
TEST(Priors, LandmarksSpeakAgainstTrainedModesThatDoNotSpanTheFace) {
    const SmallFace face = small_face();
    const DeformationModel model = with_trained_mode(face.model, [](Index) { return 0.5f; });
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult weighed = register_scan(model, scan, landmarks, {}, {});
    RegistrationSettings settings;
    settings.span.weigh = false;
    const RegistrationResult trusting = register_scan(model, scan, landmarks, settings, {});
    settings.prior.max_pca_modes = 0;
    const RegistrationResult kernel = register_scan(model, scan, landmarks, settings, {});
    EXPECT_EQ(weighed.verdict.whole.is_trained, 0);
    EXPECT_EQ(trusting.verdict.whole.is_trained, 1);
    EXPECT_EQ(weighed.fitted.vertices, kernel.fitted.vertices);
    EXPECT_FALSE(weighed.verdict.notes.empty());
}

// Without landmarks they once kept the fit to themselves: 4 mm off and "good" on a real face.
TEST(Priors, TheSurfaceSpeaksAgainstTrainedModesThatDoNotSpanTheFace) {
    const SmallFace face = small_face();
    const DeformationModel model = with_trained_mode(face.model, [](Index) { return 0.5f; });
    const TriMesh scan = scan_of(face, Similarity());
    RegistrationSettings settings;
    settings.start.kind = StartKind::pose;
    const RegistrationResult weighed = register_scan(model, scan, {}, settings, {});
    settings.span.weigh = false;
    const RegistrationResult trusting = register_scan(model, scan, {}, settings, {});
    settings.prior.max_pca_modes = 0;
    const RegistrationResult kernel = register_scan(model, scan, {}, settings, {});
    EXPECT_EQ(weighed.verdict.whole.is_trained, 0);
    EXPECT_EQ(trusting.verdict.whole.is_trained, 1);
    EXPECT_EQ(weighed.fitted.vertices, kernel.fitted.vertices);
    const auto& notes = weighed.verdict.notes;
    EXPECT_EQ(std::count_if(notes.begin(), notes.end(),
                            [](const std::string& note) {
                                return note.find("by its surface") != std::string::npos;
                            }),
              1);
}

// Nothing is left open by a fit that sees nothing of the scan.
TEST(Priors, AKernelThatLosesTheScanIsNotPreferred) {
    const TrainedSpanSettings settings;
    EXPECT_TRUE(surface_prefers_kernel({0.5, 1000}, {0.2, 950}, settings));
    EXPECT_FALSE(surface_prefers_kernel({0.5, 1000}, {0.4, 1000}, settings));
    EXPECT_FALSE(surface_prefers_kernel({0.5, 1000}, {0.2, 600}, settings));
    EXPECT_FALSE(surface_prefers_kernel({0.5, 1000}, {}, settings));
    const SmallFace face = small_face();
    const TriMesh mesh = scan_of(face, Similarity());
    const PreparedScan scan = prepare_scan(mesh, {}, {});
    const PriorState prior = choose_prior(face.model, {}, {}, {}, {});
    StartSettings posed;
    posed.kind = StartKind::pose;
    const StartState start = find_start(face.model, scan, prior, {}, posed, {}, {});
    FitOutcome fit;
    const auto open_when_moved = [&](double away_mm) {
        fit.state.places = face.truth.rowwise() + Eigen::RowVector3d(0, 0, away_mm);
        return open_surface(face.model, prior, start, fit, {}, settings, {});
    };
    EXPECT_GT(open_when_moved(0).seen, face.truth.rows() / 2);
    EXPECT_LT(open_when_moved(0).middle_mm, 0.05);
    EXPECT_EQ(open_when_moved(1000).seen, 0);
}

// A face that the trained modes do span is theirs.
TEST(Priors, TrainedModesThatSpanTheFaceAreKept) {
    SmallFace face = small_face();
    const Points& rest = face.model.template_mesh.vertices;
    const DeformationModel model = with_trained_mode(
        face.model, [&](Index i) { return static_cast<float>(4 * std::sin(rest(i, 1) / 30)); });
    face.truth = rest;
    face.truth.col(2) += 4 * (rest.col(1) / 30).array().sin().matrix();
    RegistrationSettings settings;
    settings.start.kind = StartKind::pose;
    const RegistrationResult result =
        register_scan(model, scan_of(face, Similarity()), {}, settings, {});
    EXPECT_EQ(result.verdict.whole.is_trained, 1);
    EXPECT_LT((result.fitted.vertices - face.truth).rowwise().norm().mean(), 1);
}

// What people left out of the training taught of the modes is what the kernel is given beside them.
TEST(Priors, TheKernelMakesUpForWhatTrainedModesLeaveOfOtherPeople) {
    DeformationModel model = with_trained_mode(small_face().model, [](Index) { return 0.5f; });
    const double kernel_mm = kernel_deviation_mm(model, model.basis.cols);
    const auto beside = [&](double left_mm) {
        model.pca_left_out_mm = left_mm;
        return kernel_mm * choose_prior(model, {}, {}, {}, {}).kernel_amplitude;
    };
    EXPECT_NEAR(beside(0), PriorSettings().residual_sd_mm, 1e-9);
    EXPECT_NEAR(beside(1.25), 1.25, 1e-9);
    EXPECT_NEAR(beside(1000), kernel_mm, 1e-9);  // no more than it would do alone
}

// Open mouths once counted as far-fetched shapes, although the prior had been told to expect them.
TEST(Measures, AnExpectedOpeningIsNoDeviation) {
    FitState state;
    state.coefficients.kernel = Eigen::MatrixXf::Random(9, 3);
    EXPECT_EQ(state.kernel_off(), state.coefficients.kernel);
    state.kernel_mean = Eigen::MatrixXf::Zero(12, 3);
    state.kernel_mean.topRows(9) = state.coefficients.kernel;
    EXPECT_EQ(state.kernel_off().norm(), 0);
    const SmallFace face = small_face();
    EXPECT_EQ(expected_opening(face.model, FitState()).norm(), 0);
    FitState open;
    open.kernel_mean = Eigen::MatrixXf::Zero(face.model.basis.cols, 3);
    open.kernel_mean(3, 1) = 2;
    const Points opening = expected_opening(face.model, open);
    EXPECT_NEAR((opening.col(1) - 2 * face.model.basis.map().col(3).cast<double>()).norm(), 0,
                1e-5);
    EXPECT_EQ(opening.col(0).norm() + opening.col(2).norm(), 0);
}

}  // namespace
}  // namespace mien
