#include "study/study.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "expression/neutralize.hpp"
#include "measure/repeatability.hpp"
#include "measure/volume.hpp"
#include "sheets.hpp"
#include "study/study_json.hpp"

namespace mien {
namespace {

using test::grown;
using test::mean_distance;
using test::seen;
using test::settings_with_zones;
using test::study;
using test::trained_model;

std::shared_ptr<const ExpressionModel> model() {
    return {std::shared_ptr<void>(), &trained_model<8>()};
}

Status status_of(const std::vector<StudyFace>& faces, const StudySettings& settings) {
    try {
        const Study made(Context(), nullptr, faces, settings);
    } catch (const Error& failure) {
        return failure.status();
    }
    return Status::ok;
}

TEST(StudyErrors, IntervalsOfUnchangedFacesHoldZeroAsOftenAsTheySay) {
    int held[6] = {}, all = 0, absolute_without_bias = 0;
    for (unsigned take = 0; take < 60; ++take) {
        const Points face = study().neutral(static_cast<int>(take));
        StudySettings settings = settings_with_zones();
        settings.surface.common_bias_mm = 0;
        const Study made(Context(), nullptr,
                         {seen(face, 0.1, 2 * take + 1, 0), seen(face, 0.1, 2 * take + 2, 1)},
                         settings);
        for (const ZoneChange& zone : made.change(0, 1).zones) {
            const StudyValue* values[] = {&zone.signed_ml, &zone.gained_ml,
                                          &zone.lost_ml,   &zone.absolute_ml,
                                          &zone.area_mm2,  &zone.mean_distance_mm};
            for (int i = 0; i < 6; ++i) held[i] += values[i]->low <= 0 && values[i]->high >= 0;
            absolute_without_bias += zone.absolute_ml.value - 2 * zone.absolute_ml.sd <= 0;
            ++all;
        }
    }
    for (const int count : held) EXPECT_GE(count, 0.9 * all);
    // Noise alone makes an absolute volume: without its share taken off no interval would hold 0.
    EXPECT_LT(absolute_without_bias, 0.2 * all);
}

TEST(StudyErrors, AGrownSpotIsMeasuredAndDetected) {
    const Points face = study().neutral(3);
    const Study made(Context(), nullptr, {seen(face, 0.02, 1, 0), seen(grown(face, 3), 0.02, 2, 1)},
                     settings_with_zones());
    const double truth = measure_volume(face, grown(face, 3), study().triangles,
                                        settings_with_zones().zones.zones, Context())
                             .zones[2]
                             .volume.signed_ml;
    const ZoneChange& spot = made.change(0, 1).zones[2];
    EXPECT_EQ(spot.reason, WhyUnknown::nothing);
    EXPECT_NEAR(spot.signed_ml.value, truth, 3 * spot.signed_ml.sd);
    EXPECT_GT(spot.signed_ml.low, 0.5 * truth);
    EXPECT_EQ(spot.detected, 1);
    EXPECT_GT(spot.gained_ml.low, 0.5 * truth);
    EXPECT_EQ(made.change(0, 1).zones[0].detected, 0);
    // Backwards the same was lost.
    const ZoneChange& back = made.change(1, 0).zones[2];
    EXPECT_NEAR(back.signed_ml.value, -spot.signed_ml.value, 2 * spot.signed_ml.sd);
    EXPECT_LT(back.lost_ml.high, -0.5 * truth);
}

/// A limit of 3.3 deviations called changes undetected whose intervals left zero out.
TEST(StudyErrors, AChangeIsDetectedWhenItsIntervalLeavesZeroOut) {
    const Points face = study().neutral(3);
    int detected = 0, between = 0, all = 0;
    for (const double height : {0.0, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
        const Study made(Context(), nullptr,
                         {seen(face, 0.1, 1, 0), seen(grown(face, height), 0.1, 2, 1)},
                         settings_with_zones());
        for (const ZoneChange& zone : made.change(0, 1).zones) {
            const StudyValue& ml = zone.signed_ml;
            EXPECT_EQ(zone.detected == 1, ml.low > 0 || ml.high < 0) << height;
            EXPECT_NEAR(ml.limit_of_detection, 1.959964 * ml.sd, 1e-6 * ml.sd);
            detected += zone.detected;
            between += zone.detected == 1 && std::fabs(ml.value) < 3.29 * ml.sd;
            ++all;
        }
    }
    EXPECT_GT(detected, 0);
    EXPECT_LT(detected, all);
    EXPECT_GT(between, 0);
}

TEST(StudyErrors, WithoutDeviationsThereAreValuesAndNoIntervals) {
    const Points face = study().neutral(3);
    StudyFace bare = seen(face, 0.1, 1, 1);
    bare.normal_sd_mm.resize(0);
    const Study made(Context(), nullptr, {seen(face, 0.1, 2, 0), bare}, settings_with_zones());
    for (const ZoneChange& zone : made.change(0, 1).zones) {
        EXPECT_EQ(zone.reason, WhyUnknown::no_surface_errors);
        EXPECT_TRUE(std::isfinite(zone.signed_ml.value));
        for (const double none : {zone.signed_ml.sd, zone.signed_ml.low, zone.area_mm2.sd,
                                  zone.signed_ml.limit_of_detection, zone.alignment_sd_ml})
            EXPECT_TRUE(std::isnan(none));
        EXPECT_EQ(zone.detected, -1);
    }
    EXPECT_NE(study_json(made).find("the surfaces' errors are unknown"), std::string::npos);
}

TEST(StudyErrors, AFailedFitHasNoInterval) {
    const Points face = study().neutral(3);
    StudyFace failed = seen(face, 0.1, 1, 1);
    failed.failed = true;
    const Study made(Context(), nullptr, {seen(face, 0.1, 2, 0), failed}, settings_with_zones());
    EXPECT_EQ(made.change(0, 1).zones[0].reason, WhyUnknown::failed_fit);
    EXPECT_TRUE(std::isnan(made.change(0, 1).zones[0].signed_ml.low));
}

TEST(StudyErrors, NothingIsToldOfAZoneThatWasNotSeen) {
    const Points face = study().neutral(3);
    StudyFace half = seen(face, 0.1, 1, 1);
    const StudySettings settings = settings_with_zones();
    for (const std::uint32_t v : settings.zones.zones[1].vertices) half.weights[v] = 0;
    const Study made(Context(), nullptr, {seen(face, 0.1, 2, 0), half}, settings_with_zones());
    const ZoneChange& high = made.change(0, 1).zones[1];
    EXPECT_EQ(high.reason, WhyUnknown::unseen);
    EXPECT_EQ(high.seen_share, 0);
    EXPECT_TRUE(std::isnan(high.signed_ml.value));
    EXPECT_EQ(made.change(0, 1).zones[0].seen_share, 1);
}

TEST(StudyErrors, AnUnknownSlideLeavesTheAreaWithoutADeviation) {
    const Points face = study().neutral(3);
    StudyFace bare = seen(face, 0.1, 1, 1);
    bare.place_sd_mm.resize(0);
    const Study made(Context(), nullptr, {seen(face, 0.1, 2, 0), bare}, settings_with_zones());
    const ZoneChange& zone = made.change(0, 1).zones[2];
    EXPECT_TRUE(std::isfinite(zone.signed_ml.low));
    EXPECT_TRUE(std::isfinite(zone.area_mm2.value));
    EXPECT_TRUE(std::isnan(zone.area_mm2.low));
}

TEST(StudyBlanks, RepeatedCapturesGiveTheLimitOfDetection) {
    const Points face = study().neutral(5);
    std::vector<StudyFace> faces;
    for (unsigned k = 0; k < 3; ++k) faces.push_back(seen(face, 0.1, 10 + k, 0));
    faces.push_back(seen(face, 0.1, 20, 1));
    const Study made(Context(), nullptr, faces, settings_with_zones());
    EXPECT_EQ(made.num_visits(), 2u);
    EXPECT_EQ(made.num_captures(0), 3u);
    EXPECT_EQ(made.num_blanks(), 3u);
    std::vector<double> blanks;
    for (const auto& [a, b] : {std::pair<int, int>{0, 1}, {0, 2}, {1, 2}})
        blanks.push_back(compare_faces(Context(), made.data(), static_cast<std::size_t>(a),
                                       static_cast<std::size_t>(b))
                             .zones[1]
                             .signed_ml.value);
    EXPECT_EQ(made.change(0, 1).zones[1].signed_ml.limit_of_detection,
              detection_limit(blanks).minimal_detectable_change);
}

TEST(StudyExpressions, ASmileIsTakenOffAndATreatmentStays) {
    const int person = 60;
    const Points before = study().neutral(person), after = grown(study().face(person, 2), 2);
    StudySettings settings = settings_with_zones();
    settings.zones.treated = {"spot"};
    settings.zones.stable.clear();  // all that was not treated
    const Study made(Context(), model(), {seen(before, 0.05, 1, 0), seen(after, 0.05, 2, 1)},
                     settings);
    EXPECT_TRUE(made.data().zones.stable_is_untreated);
    ASSERT_EQ(made.zones().size(), 4u);
    EXPECT_EQ(made.zones()[3].name, "spot and 10 mm around");
    EXPECT_GT(made.zones()[3].vertices.size(), made.zones()[2].vertices.size());
    const Points truth = grown(before, 2);
    const double volume =
        measure_volume(before, truth, study().triangles, settings.zones.zones, Context())
            .zones[2]
            .volume.signed_ml;
    const ZoneChange& spot = made.change(0, 1).zones[2];
    EXPECT_LE(spot.signed_ml.low, volume);
    EXPECT_GE(spot.signed_ml.high, volume);
    EXPECT_GT(spot.expression_sd_ml, 0);
    // The smile moves the low half; left on, it is a change there.
    const double left_on = mean_distance(before, after);
    EXPECT_LT(mean_distance(made.neutral(0, 0).vertices, made.neutral(1, 0).vertices),
              0.6 * left_on);
}

TEST(StudyExpressions, OneVisitIsPlainNeutralizationWithItsUncertainty) {
    const Points smile = study().face(61, 2);
    const Study made(Context(), model(), {seen(smile, 0.0, 1, 0)}, settings_with_zones());
    NeutralizeOptions options;
    options.uncertainty = true;
    const NeutralizationResult plain =
        neutralize(Context(), trained_model<8>(), smile, Vector::Ones(smile.rows()), options);
    EXPECT_EQ(made.neutral(0, 0).vertices, plain.neutral_vertices);
    EXPECT_EQ(made.data().neutral.expression_sd_mm[0], plain.uncertainty_mm);
    EXPECT_EQ(made.num_visits(), 1u);
}

TEST(StudyZones, DefaultsAndMistakes) {
    const Points face = study().neutral(1);
    const std::vector<StudyFace> faces{seen(face, 0.1, 1, 0), seen(face, 0.1, 2, 1)};
    StudySettings settings = settings_with_zones();
    settings.zones.stable = {"elbow"};
    EXPECT_EQ(status_of(faces, settings), Status::not_found);
    settings.zones.stable.clear();  // no "forehead" here
    EXPECT_EQ(status_of(faces, settings), Status::not_found);
    settings.zones.zones.clear();  // then the whole face
    EXPECT_EQ(status_of(faces, settings), Status::ok);
    settings = settings_with_zones();
    settings.zones.zones[0].vertices.push_back(100000);
    EXPECT_EQ(status_of(faces, settings), Status::mismatch);
    settings = settings_with_zones();
    settings.reporting.level = 1;
    EXPECT_EQ(status_of(faces, settings), Status::invalid_argument);
    std::vector<StudyFace> wrong = faces;
    wrong[1].visit = 2;
    EXPECT_EQ(status_of(wrong, settings_with_zones()), Status::invalid_argument);
    wrong = faces;
    wrong[1].weights[3] = 2;
    EXPECT_EQ(status_of(wrong, settings_with_zones()), Status::invalid_argument);
    EXPECT_EQ(status_of({}, settings_with_zones()), Status::invalid_argument);
}

TEST(StudyZones, APairOfOneVisitOrOfNoneIsRefused) {
    const Points face = study().neutral(1);
    const Study made(Context(), nullptr, {seen(face, 0.1, 1, 0), seen(face, 0.1, 2, 1)},
                     settings_with_zones());
    EXPECT_THROW(made.change(1, 1), Error);
    EXPECT_THROW(made.change(0, 2), Error);
}

TEST(StudyFaces, TheNormalDeviationIsTheResidualWhereTheScanWasSeen) {
    Vector place(3), weights(3), residual(3);
    place << 1.0, 1.0, 0.05;
    weights << 1, 0, 1;
    residual << 0.3, 0.3, 0.3;
    const Vector sd = normal_deviation_mm(place, weights, residual, 0.4);
    EXPECT_DOUBLE_EQ(sd[0], 0.5);
    EXPECT_DOUBLE_EQ(sd[1], 1.0);   // not seen: what the model leaves open
    EXPECT_DOUBLE_EQ(sd[2], 0.05);  // never more than that
    EXPECT_EQ(normal_deviation_mm({}, weights, residual, 0.4).size(), 0);
    EXPECT_THROW(normal_deviation_mm(place, Vector::Ones(2), residual, 0.4), Error);
}

TEST(StudyFaces, VisitsGuessAlikeWhatNeitherSaw) {
    StudyFace first, second;
    first.normal_sd_mm = second.normal_sd_mm = first.place_sd_mm = Vector::Constant(4, 2.0);
    second.place_sd_mm = Vector::Constant(4, 1.5);
    first.normal_sd_mm[0] = first.normal_sd_mm[3] = 0.1;
    first.weights = Vector(4);
    second.weights = Vector(4);
    first.weights << 1, 0, 0, 1;
    second.weights << 1, 1, 0, 0;
    const Vector sd = change_deviation_mm(first, second, 0.2);
    EXPECT_NEAR(sd[0], 0.1, 1e-12);  // seen by both
    EXPECT_NEAR(sd[1], 2.0, 1e-12);  // seen by the other alone: this one's guess errs whole
    EXPECT_NEAR(sd[2], 0.4, 1e-12);  // by neither
    EXPECT_NEAR(sd[3], 0.1, 1e-12);
    EXPECT_EQ(change_deviation_mm(first, second, 1.0), first.normal_sd_mm);
    second.weights.resize(0);
    EXPECT_EQ(change_deviation_mm(first, second, 0.2), first.normal_sd_mm);
}

TEST(StudyErrors, UnseenSkinOfOneZoneMakesItsChangeLessUnsureThanItsPlace) {
    const Points face = study().neutral(3);
    StudyFace before = seen(face, 0.1, 1, 0), after = seen(face, 0.1, 2, 1);
    StudySettings settings = settings_with_zones();
    settings.zones.unseen = true;
    const std::vector<std::uint32_t>& high = settings.zones.zones[1].vertices;
    for (std::size_t k = 0; k < high.size(); k += 2)
        for (StudyFace* one : {&before, &after}) {
            one->weights[high[k]] = 0;
            one->normal_sd_mm[high[k]] = one->place_sd_mm[high[k]] = 1.5;
        }
    const auto sd_of = [&](double share) {
        settings.surface.unseen_apart_share = share;
        return Study(Context(), nullptr, {before, after}, settings)
            .change(0, 1)
            .zones[1]
            .surface_sd_ml;
    };
    EXPECT_LT(sd_of(0.2), 0.3 * sd_of(1.0));
    EXPECT_GT(sd_of(0.2), sd_of(0.0));
    settings.surface.unseen_apart_share = 1.5;
    EXPECT_EQ(status_of({before, after}, settings), Status::invalid_argument);
}

TEST(StudyThreads, SameBitsForAnyNumber) {
    const Points face = study().neutral(7);
    const std::vector<StudyFace> faces{seen(face, 0.1, 1, 0),
                                       seen(grown(study().face(7, 2), 2), 0.1, 2, 1)};
    ThreadPool pool(4);
    Context many;
    many.pool = &pool;
    EXPECT_EQ(study_json(Study(Context(), model(), faces, settings_with_zones())),
              study_json(Study(many, model(), faces, settings_with_zones())));
}

TEST(StudyCancel, StopsTheWork) {
    const Points face = study().neutral(7);
    CancelToken token;
    token.request();
    Context context;
    context.cancel = &token;
    EXPECT_THROW(Study(context, model(), {seen(face, 0.1, 1, 0), seen(face, 0.1, 2, 1)},
                       settings_with_zones()),
                 Error);
}

}  // namespace
}  // namespace mien
