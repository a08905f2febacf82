#include "expression/training.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "expression/neutralize.hpp"
#include "study.hpp"

namespace mien {
namespace {

using test::Study;

TrainOptions small_options() {
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    return options;
}

TEST(Training, FindsOrthonormalModesThatExplainTheStudy) {
    const Study study;
    TrainReport report;
    const auto model = train_expression_model(study.dataset(0, study.subjects, "ortho"),
                                              small_options(), Context(), &report);
    const Matrix p = model->identity_modes.map().cast<double>();
    const Matrix q = model->expression_modes.map().cast<double>();
    EXPECT_LT((p.transpose() * p - Matrix::Identity(p.cols(), p.cols())).cwiseAbs().maxCoeff(),
              1e-5);
    EXPECT_LT((q.transpose() * q - Matrix::Identity(q.cols(), q.cols())).cwiseAbs().maxCoeff(),
              1e-5);
    EXPECT_GT(report.identity_explained, 0.98);
    EXPECT_GT(report.expression_explained, 0.99);
    for (Index k = 1; k < model->num_people_modes(); ++k)
        EXPECT_LE(model->identity_deviations[k], model->identity_deviations[k - 1] * (1 + 1e-9));
    EXPECT_EQ(model->components.front().name, "neutral");
    EXPECT_EQ(model->components.back().name, "any");
    EXPECT_EQ(model->components.size(), study.names.size() + 1);
}

TEST(Training, MeanOfMoreSubjectsThanOneBlockHolds) {
    const Study study;
    constexpr int kSubjects =
        400;  // three blocks of columns; the running sum used to be taken off the later ones
    const auto model =
        train_expression_model(study.dataset(0, kSubjects, "many"), small_options(), Context());
    Points mean = Points::Zero(study.rest.rows(), 3);
    for (int subject = 0; subject < kSubjects; ++subject)
        mean += study.neutral(subject) / kSubjects;
    EXPECT_LT((model->mean - mean).cwiseAbs().maxCoeff(), 1e-4);  // the file holds floats
    const Points face = study.face(kSubjects + 1, 1), neutral = study.neutral(kSubjects + 1);
    const NeutralizationResult result = neutralize(Context(), *model, face, Vector(), {});
    EXPECT_LT((result.neutral_vertices - neutral).norm(), 0.2 * (face - neutral).norm());
    EXPECT_LT(model->identity_deviations.maxCoeff(), 200.0);
}

/// Expressions that grow with the person: a wide face smiles widely.
Points growing_face(const Study& study, int subject, int expression) {
    const Points neutral = study.neutral(subject);
    if (expression == 0) return neutral;
    const double width = (neutral - study.rest).col(2).mean();  // of either sign, some mm
    return neutral + study.bump(40, 20 + 20 * expression, 16, Vector3(0, -8 - 2 * width, 3));
}

double growing_error(const ExpressionModel& model, const Study& study) {
    double error = 0;
    for (int subject = 60; subject < 80; ++subject) {
        const Points face = growing_face(study, subject, 1 + subject % 4);
        error +=
            test::mean_distance(neutralize(Context(), model, face, Vector(), {}).neutral_vertices,
                                study.neutral(subject));
    }
    return error / 20;
}

std::shared_ptr<const FaceDataset> growing_people(const Study& study, const char* name) {
    FaceDatasetWriter writer(study.triangles, study.rest.rows(), study.names);
    for (int subject = 0; subject < 40; ++subject)
        for (int expression = 0; expression < 5; ++expression)
            writer.add(growing_face(study, subject, expression), subject, expression);
    return Study::written(writer, name);
}

TEST(Training, AnExpressionsMeanFollowsThePerson) {
    const Study study;
    const auto data = growing_people(study, "growing");
    TrainOptions options = small_options();
    options.prior.min_followers = 20;
    const auto follows = train_expression_model(data, options, Context());
    options.prior.identity_directions = 0;
    const auto rigid = train_expression_model(data, options, Context());
    EXPECT_EQ(rigid->components[1].follows.size(), 0);
    EXPECT_EQ(follows->components[1].follows.cols(), 10);
    options = small_options();
    EXPECT_EQ(train_expression_model(data, options, Context())->components[1].follows.size(), 0)
        << "40 people do not determine it";
    EXPECT_LT(growing_error(*follows, study), 0.8 * growing_error(*rigid, study));
}

TEST(Training, AnExpressionThatIsTheSameForAllFollowsNobody) {
    const Study study;
    FaceDatasetWriter writer(study.triangles, study.rest.rows(), study.names);
    for (int subject = 0; subject < 40; ++subject)
        for (int expression = 0; expression < 5; ++expression)
            writer.add(study.neutral(subject) + study.face(0, expression) - study.neutral(0),
                       subject, expression);
    TrainOptions options = small_options();
    options.prior.min_followers = 20;
    const auto model =
        train_expression_model(Study::written(writer, "constant"), options, Context());
    EXPECT_EQ(model->components[1].follows.size(), 0) << "people left out are no better for it";
}

TEST(Training, AWeakExpressionIsTakenOffToo) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "weak");
    TrainOptions options = small_options();
    options.prior.min_followers = 10;
    options.prior.intensities = {0.25, 0.5, 0.75, 1.0};
    const auto graded = train_expression_model(data, options, Context());
    options.prior.intensities = {1.0};
    const auto full = train_expression_model(data, options, Context());
    EXPECT_EQ(full->plan->components.size(), full->components.size());
    double with = 0, without = 0, intensity = 0;
    for (int subject = 60; subject < 80; ++subject) {
        const Points neutral = study.neutral(subject);
        const Points weak = neutral + 0.3 * (study.face(subject, 1 + subject % 4) - neutral);
        const NeutralizationResult result = neutralize(Context(), *graded, weak, Vector(), {});
        with += test::mean_distance(result.neutral_vertices, neutral);
        without += test::mean_distance(
            neutralize(Context(), *full, weak, Vector(), {}).neutral_vertices, neutral);
        intensity += result.intensity / 20;
        EXPECT_EQ(result.component_probabilities.size(), graded->components.size());
    }
    EXPECT_LT(with, 0.8 * without);
    EXPECT_LT(intensity, 0.7);
    const Points strong = study.face(81, 2);
    EXPECT_GT(neutralize(Context(), *graded, strong, Vector(), {}).intensity, 0.7);
}

TEST(Training, WhatFollowsThePersonSurvivesTheFile) {
    const Study study;
    TrainOptions options = small_options();
    options.prior.min_followers = 10;
    const auto model = train_expression_model(growing_people(study, "follows"), options, Context());
    ASSERT_EQ(model->components[1].follows.cols(), 10);
    const std::string path = Study::path("follows_model");
    save_expression_model(path, *model, Context());
    const auto loaded = load_expression_model(path, {}, Context());
    std::remove(path.c_str());
    ASSERT_EQ(loaded->components.size(), model->components.size());
    for (std::size_t k = 1; k + 1 < model->components.size(); ++k)
        EXPECT_EQ(loaded->components[k].follows, model->components[k].follows) << k;
    EXPECT_EQ(loaded->intensities, model->intensities);
    EXPECT_TRUE(loaded->components.front().follows.isZero(0.0)) << "neutral is the same for all";
    const Points face = study.face(60, 2);
    EXPECT_EQ(neutralize(Context(), *loaded, face, Vector(), {}).expression,
              neutralize(Context(), *model, face, Vector(), {}).expression);
}

TEST(Training, TakesTheFewestModesThatServePeopleLeftOut) {
    const Study study;
    TrainOptions options;
    options.subspaces.identity_modes = options.subspaces.expression_modes = 0;
    options.search.counts = {1, 4, 10, 20};
    TrainReport report;
    const auto dataset = study.dataset(0, study.subjects, "counts");
    const auto model = train_expression_model(dataset, options, Context(), &report);
    ASSERT_GE(report.tried_modes.size(), 3u);
    const TriedModes* chosen = nullptr;
    double least = report.tried_modes.front().held_out_mm;
    for (const TriedModes& pair : report.tried_modes) {
        EXPECT_GT(pair.held_out_mm, 0);
        least = std::min(least, pair.held_out_mm);
        if (pair.identity == model->num_people_modes() &&
            pair.expression == model->num_expression_modes())
            chosen = &pair;
    }
    ASSERT_NE(chosen, nullptr);
    EXPECT_GT(chosen->identity, 1);  // one direction does not serve anybody
    EXPECT_LE(chosen->held_out_mm * (1 - options.search.least_gain), least);
    for (const TriedModes* fewer = report.tried_modes.data(); fewer != chosen; ++fewer)
        EXPECT_GT(fewer->held_out_mm * (1 - options.search.least_gain), least);

    // A count that is given stays; the other one is searched. Any thread count finds the same.
    options.subspaces.identity_modes = 10;
    ThreadPool pool(3);
    Context threads;
    threads.pool = &pool;
    TrainReport again;
    const auto fixed = train_expression_model(dataset, options, threads, &again);
    EXPECT_EQ(fixed->num_people_modes(), 10);
    TrainReport alone;
    (void)train_expression_model(dataset, options, Context(), &alone);
    ASSERT_EQ(again.tried_modes.size(), alone.tried_modes.size());
    for (std::size_t k = 0; k < alone.tried_modes.size(); ++k)
        EXPECT_EQ(again.tried_modes[k].held_out_mm, alone.tried_modes[k].held_out_mm);
}

TEST(Training, RefusesASearchForModesWithoutSense) {
    const Study study;
    const auto dataset = study.dataset(0, 8, "senseless");
    const auto status_of = [&](const TrainOptions& options) {
        try {
            (void)train_expression_model(dataset, options, Context());
        } catch (const Error& failure) {
            return failure.status();
        }
        return Status::ok;
    };
    TrainOptions options;
    options.subspaces.identity_modes = 0;
    options.search.counts = {20, 10};
    EXPECT_EQ(status_of(options), Status::invalid_argument);
    options.search.counts = {};
    EXPECT_EQ(status_of(options), Status::invalid_argument);
    options.search.counts = {10};
    options.search.least_gain = 2;
    EXPECT_EQ(status_of(options), Status::invalid_argument);
    options.search.least_gain = 0;
    options.subspaces.expression_modes = -1;
    EXPECT_EQ(status_of(options), Status::invalid_argument);
}

TEST(Training, QuasiOrthogonalSubspacesAreMoreOrthogonal) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "quasi");
    TrainOptions options = small_options();
    TrainReport joint, quasi;
    train_expression_model(data, options, Context(), &joint);
    options.subspaces.method = TrainMethod::quasi_orthogonal;
    train_expression_model(data, options, Context(), &quasi);
    const Index last = std::min(joint.orthogonality.size(), quasi.orthogonality.size()) - 1;
    EXPECT_LT(quasi.orthogonality[last], 0.3 * joint.orthogonality[last]);
    EXPECT_EQ(joint.joint_pca_orthogonality, joint.orthogonality);
    EXPECT_EQ(quasi.joint_pca_orthogonality, joint.orthogonality);
    EXPECT_NEAR(quasi.k, 4.0, 1e-12);
    EXPECT_TRUE(quasi.converged);
}

TEST(Training, SameBitsForAnyThreadCount) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "threads");
    const auto one = train_expression_model(data, small_options(), Context());
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const auto three = train_expression_model(data, small_options(), context);
    EXPECT_TRUE(one->identity_modes.map() == three->identity_modes.map());
    EXPECT_TRUE(one->expression_modes.map() == three->expression_modes.map());
    EXPECT_TRUE(one->gram == three->gram);
    EXPECT_EQ(one->mixture_noise_mm2, three->mixture_noise_mm2);
}

TEST(Training, ModelComesBackFromItsFileBitForBit) {
    const Study study;
    const auto data = study.dataset(0, study.subjects, "save");
    for (TrainMethod method : {TrainMethod::joint_pca, TrainMethod::quasi_orthogonal}) {
        TrainOptions train = small_options();
        train.subspaces.method = method;
        const auto model = train_expression_model(data, train, Context());
        const std::string path = Study::path("model");
        save_expression_model(path, *model, Context());
        const auto loaded = load_expression_model(path, {}, Context());
        EXPECT_TRUE(model->mean == loaded->mean);
        EXPECT_TRUE(model->triangles == loaded->triangles);
        EXPECT_TRUE(model->spill.identity == loaded->spill.identity);
        EXPECT_TRUE(model->spill.expression == loaded->spill.expression);
        EXPECT_EQ(loaded->info.at("method"), method == TrainMethod::joint_pca ? "jpca" : "qojpca");
        const Points face = study.face(101, 2);
        NeutralizeOptions options;
        EXPECT_TRUE(neutralize(Context(), *model, face, Vector(), options).neutral_vertices ==
                    neutralize(Context(), *loaded, face, Vector(), options).neutral_vertices);
        std::remove(path.c_str());
    }
}

TEST(Training, RefusesDataWithoutNeutralFaces) {
    Study study;
    study.names[0] = "rest";
    try {
        train_expression_model(study.dataset(0, 4, "rest"), small_options(), Context());
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::invalid_argument);
        EXPECT_NE(std::string(error.what()).find("neutral"), std::string::npos);
    }
}

TEST(Training, SkipsFacesWhoseSubjectHasNoNeutralAndTakesMissingExpressions) {
    const Study study;
    FaceDatasetWriter writer(study.triangles, study.rest.rows(), study.names);
    for (int subject = 0; subject < 12; ++subject)
        for (int expression = 0; expression < 5; ++expression) {
            if (subject == 3 && expression == 0) continue;  // no neutral: 4 faces skipped
            if (subject == 5 && expression == 2) continue;  // missing expression
            writer.add(study.face(subject, expression), subject, expression);
            if (subject == 7) writer.add(study.face(subject, expression, 1), subject, expression);
        }
    TrainReport report;
    train_expression_model(Study::written(writer, "missing"), small_options(), Context(), &report);
    EXPECT_EQ(report.subjects, 11);
    EXPECT_EQ(report.skipped_faces, 4);
    EXPECT_EQ(report.faces, 11 + 11 * 4 - 1 + 4);
}

TEST(Training, CanBeCancelled) {
    const Study study;
    const auto data = study.dataset(0, 6, "cancel");
    Context context;
    context.progress_function = [](void*, std::int32_t, double fraction) -> std::int32_t {
        return fraction > 0.3;
    };
    try {
        train_expression_model(data, small_options(), context);
        FAIL() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::cancelled);
    }
}

TEST(Training, HonoursTheMemoryBudget) {
    const Study study;
    Context context;
    context.max_bytes = 1000;
    try {
        train_expression_model(study.dataset(0, 6, "budget"), small_options(), context);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::memory_budget);
    }
}

}  // namespace
}  // namespace mien
