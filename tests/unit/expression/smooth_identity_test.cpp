#include "expression/smooth_identity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "expression/visits.hpp"
#include "study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::Study;

TrainOptions few_modes() {
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    return options;
}

/// Mean distance from the neutral face after neutralization, of people who trained nothing.
double left_on_new_people(const ExpressionModel& model, const Study& study, bool neutral_faces) {
    double left = 0;
    for (int subject = 60; subject < 80; ++subject) {
        const Points truth = study.neutral(subject);
        const Points face = neutral_faces ? truth : study.face(subject, 1 + subject % 4);
        left +=
            mean_distance(neutralize(Context(), model, face, Vector(), {}).neutral_vertices, truth);
    }
    return left / 20;
}

TEST(SmoothIdentity, WhatFewPeopleDoNotShowIsNotTakenForAnExpression) {
    const Study study;
    const auto data = study.dataset(0, 6, "few_people");
    TrainOptions options = few_modes();
    TrainReport report;
    const auto smooth = train_expression_model(data, options, Context(), &report);
    options.smooth.modes = 0;
    const auto plain = train_expression_model(data, options, Context());
    EXPECT_GT(report.smooth_variance_mm2, 0);
    EXPECT_EQ(report.smooth_modes, smooth->smooth_modes);
    EXPECT_EQ(plain->smooth_modes, 0);
    EXPECT_LT(left_on_new_people(*smooth, study, true),
              0.7 * left_on_new_people(*plain, study, true));
    EXPECT_LT(left_on_new_people(*smooth, study, false),
              0.7 * left_on_new_people(*plain, study, false));
}

TEST(SmoothIdentity, TheVarianceIsTheSmallestThatServesPeopleLeftOut) {
    const Study study;
    TrainOptions options = few_modes();
    TrainReport report;
    (void)train_expression_model(study.dataset(0, 8, "variance"), options, Context(), &report);
    ASSERT_EQ(report.tried_smoothness.size(), options.smooth.variances_mm2.size());
    double least = report.tried_smoothness.front().held_out_mm;
    for (const TriedSmoothness& tried : report.tried_smoothness)
        least = std::min(least, tried.held_out_mm);
    for (const TriedSmoothness& tried : report.tried_smoothness) {
        EXPECT_GT(tried.held_out_mm, 0);
        const bool serves = tried.held_out_mm * (1 - options.smooth.least_gain) <= least;
        EXPECT_FALSE(serves && tried.variance_mm2 < report.smooth_variance_mm2);
        EXPECT_TRUE(serves || tried.variance_mm2 != report.smooth_variance_mm2);
    }
}

TEST(SmoothIdentity, TheThesisFitsDoNotKnowIt) {
    const Study study;
    const auto data = study.dataset(0, 8, "thesis_fits");
    TrainOptions options = few_modes();
    options.subspaces.expression_modes = 4;  // as many as there are; others would be rounding
    const auto smooth = train_expression_model(data, options, Context());
    ASSERT_GT(smooth->smooth_modes, 0);
    options.smooth.modes = 0;
    const auto plain = train_expression_model(data, options, Context());
    const ExpressionModel& people = people_of(*smooth);
    EXPECT_TRUE(people.identity_modes.map() == plain->identity_modes.map());
    EXPECT_TRUE(people.expression_modes.map() == plain->expression_modes.map());
    EXPECT_LT((people.gram - plain->gram).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(people.mixture_noise_mm2, plain->mixture_noise_mm2);
    EXPECT_EQ(people.map_noise_mm2, plain->map_noise_mm2);
    EXPECT_EQ(people.expected_residual_mm, plain->expected_residual_mm);
    const Points face = study.face(60, 2);
    for (const FitMethod method : {FitMethod::exact, FitMethod::alternating}) {
        NeutralizeOptions fit;
        fit.fit.method = method;
        const NeutralizationResult a = neutralize(Context(), *smooth, face, Vector(), fit),
                                   b = neutralize(Context(), people_of(*smooth), face, Vector(),
                                                  fit);
        EXPECT_EQ(a.neutral_vertices, b.neutral_vertices);
        EXPECT_TRUE(a.identity.tail(smooth->smooth_modes).isZero(0.0));
    }
}

TEST(SmoothIdentity, SeveralFacesOfOnePersonAreFittedWithoutIt) {
    const Study study;
    const auto data = study.dataset(0, 8, "several_faces");
    TrainOptions options = few_modes();
    const auto smooth = train_expression_model(data, options, Context());
    ASSERT_GT(smooth->smooth_modes, 0);
    const std::vector<VisitFace> faces{{study.face(60, 2), Vector()},
                                       {study.neutral(60), Vector()}};
    const VisitsResult a = neutralize_visits(Context(), *smooth, faces, {}),
                       b = neutralize_visits(Context(), people_of(*smooth), faces, {});
    EXPECT_EQ(a.neutral_vertices[0], b.neutral_vertices[0]);
    EXPECT_EQ(a.identity.size(), smooth->num_identity_modes());
    EXPECT_EQ(visit_warnings(*smooth, a, 0), visit_warnings(people_of(*smooth), b, 0));
}

TEST(SmoothIdentity, QuasiOrthogonalModelsTakeItToo) {
    const Study study;
    const auto data = study.dataset(0, 6, "smooth_qo");
    TrainOptions options = few_modes();
    options.subspaces.method = TrainMethod::quasi_orthogonal;
    const auto smooth = train_expression_model(data, options, Context());
    options.smooth.modes = 0;
    const auto plain = train_expression_model(data, options, Context());
    ASSERT_GT(smooth->smooth_modes, 0);
    EXPECT_EQ(smooth->spill.identity.cols(), smooth->num_identity_modes());
    EXPECT_LT(left_on_new_people(*smooth, study, true),
              0.7 * left_on_new_people(*plain, study, true));
}

TEST(SmoothIdentity, SurvivesTheFile) {
    const Study study;
    const auto model =
        train_expression_model(study.dataset(0, 6, "smooth_file"), few_modes(), Context());
    ASSERT_GT(model->smooth_modes, 0);
    const std::string path = Study::path("smooth_model");
    save_expression_model(path, *model, Context());
    const auto loaded = load_expression_model(path, {}, Context());
    std::remove(path.c_str());
    EXPECT_EQ(loaded->smooth_modes, model->smooth_modes);
    EXPECT_TRUE(loaded->identity_covariance == model->identity_covariance);
    EXPECT_EQ(people_of(*loaded).mixture_noise_mm2, people_of(*model).mixture_noise_mm2);
    EXPECT_EQ(people_of(*loaded).expected_residual_mm, people_of(*model).expected_residual_mm);
    EXPECT_TRUE(people_of(*loaded).gram == people_of(*model).gram);
    const Points face = study.face(61, 3);
    EXPECT_EQ(neutralize(Context(), *loaded, face, Vector(), {}).expression,
              neutralize(Context(), *model, face, Vector(), {}).expression);
}

TEST(SmoothIdentity, RefusesOptionsWithoutSense) {
    const Study study;
    const auto data = study.dataset(0, 6, "smooth_senseless");
    const auto refused = [&](const SmoothIdentityOptions& smooth) {
        TrainOptions options = few_modes();
        options.smooth = smooth;
        try {
            (void)train_expression_model(data, options, Context());
        } catch (const Error& failure) {
            return failure.status() == Status::invalid_argument;
        }
        return false;
    };
    SmoothIdentityOptions smooth;
    smooth.scales_mm = {0.0};
    EXPECT_TRUE(refused(smooth));
    smooth = {};
    smooth.variances_mm2 = {-1.0};
    EXPECT_TRUE(refused(smooth));
    smooth = {};
    smooth.centres = 0;
    EXPECT_TRUE(refused(smooth));
    smooth = {};
    smooth.least_gain = 2.0;
    EXPECT_TRUE(refused(smooth));
}

}  // namespace
}  // namespace mien
