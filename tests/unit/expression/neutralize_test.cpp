#include "expression/neutralize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "expression/training.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::study;
using test::trained_model;

Points neutralized(const Points& face, FitMethod method, const Vector& weights = Vector()) {
    NeutralizeOptions options;
    options.fit.method = method;
    return neutralize(Context(), trained_model<10>(), face, weights, options).neutral_vertices;
}

TEST(Neutralize, BringsUnseenFacesBackToTheirNeutral) {
    double before = 0, mixture = 0, map = 0;
    for (int subject = 50; subject < 60; ++subject)
        for (int expression = 1; expression < 5; ++expression) {
            const Points face = study().face(subject, expression), truth = study().neutral(subject);
            before += mean_distance(face, truth);
            mixture += mean_distance(neutralized(face, FitMethod::mixture), truth);
            map += mean_distance(neutralized(face, FitMethod::map), truth);
        }
    EXPECT_LT(mixture, 0.35 * before);
    EXPECT_LT(map, 0.7 * before);
    EXPECT_LE(mixture, map);
}

TEST(Neutralize, WhatOrthogonalityTookFromTheExpressionComesBackInFitsWithAPrior) {
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    options.subspaces.method = TrainMethod::quasi_orthogonal;
    const auto quasi =
        train_expression_model(study().dataset(0, study().subjects, "spill"), options, Context());
    ASSERT_FALSE(quasi->spill.empty());
    ASSERT_TRUE(trained_model<10>().spill.empty());
    double before = 0, joint = 0, orthogonal = 0, changed = 0;
    for (int subject = 50; subject < 60; ++subject) {
        const Points truth = study().neutral(subject);
        changed += mean_distance(
            neutralize(Context(), *quasi, truth, Vector(), {}).neutral_vertices, truth);
        for (int expression = 1; expression < 5; ++expression) {
            const Points face = study().face(subject, expression);
            before += mean_distance(face, truth);
            joint += mean_distance(neutralized(face, FitMethod::mixture), truth);
            orthogonal += mean_distance(
                neutralize(Context(), *quasi, face, Vector(), {}).neutral_vertices, truth);
        }
    }
    EXPECT_LT(orthogonal, 0.35 * before);
    EXPECT_LT(orthogonal, 1.3 * joint);
    EXPECT_LT(changed / 10, 0.1);
}

TEST(Neutralize, TheExactFitOfAQuasiOrthogonalModelTakesItsExpressionModesOffAndNothingElse) {
    TrainOptions train;
    train.subspaces.identity_modes = 10;
    train.subspaces.expression_modes = 8;
    train.subspaces.method = TrainMethod::quasi_orthogonal;
    const auto quasi =
        train_expression_model(study().dataset(0, study().subjects, "plain"), train, Context());
    NeutralizeOptions options;
    options.fit.method = FitMethod::exact;
    const Points face = study().face(57, 1);
    const NeutralizationResult result = neutralize(Context(), *quasi, face, Vector(), options);
    Vector moved = Vector::Zero(3 * face.rows());
    add_modes(Context(), quasi->expression_modes, -result.expression, moved);
    EXPECT_LT(mean_distance(result.neutral_vertices,
                            face + Eigen::Map<const Points>(moved.data(), face.rows(), 3)),
              1e-9);
}

TEST(Neutralize, LeavesANeutralFaceAsItIs) {
    for (int subject = 50; subject < 60; ++subject) {
        const Points face = study().neutral(subject);
        EXPECT_LT(mean_distance(neutralized(face, FitMethod::mixture), face), 0.1);
    }
}

TEST(Neutralize, KeepsDetailThatTheModelDoesNotExplain) {
    const Points face = study().face(50, 1);
    Points spiky = face;
    // A pattern that alternates from vertex to vertex is outside of every smooth mode.
    for (Index i = 0; i < spiky.rows(); ++i) spiky(i, 2) += (i % 2 == 0 ? 0.5 : -0.5);
    const Points difference =
        neutralized(spiky, FitMethod::mixture) - neutralized(face, FitMethod::mixture);
    EXPECT_LT((difference - (spiky - face)).cwiseAbs().maxCoeff(), 0.05);
}

TEST(Neutralize, AlternationConvergesToTheExactFit) {
    const Points face = study().face(51, 2);
    NeutralizeOptions options;
    options.fit.method = FitMethod::alternating;
    options.fit.max_sweeps = 20000;
    options.fit.tolerance = 1e-12;
    const NeutralizationResult result =
        neutralize(Context(), trained_model<10>(), face, Vector(), options);
    EXPECT_LT(mean_distance(result.neutral_vertices, neutralized(face, FitMethod::exact)), 1e-3);
    options.fit.max_sweeps = 3;
    EXPECT_EQ(neutralize(Context(), trained_model<10>(), face, Vector(), options).sweeps, 3);
}

TEST(Neutralize, WeightsOfOneChangeNothing) {
    const Points face = study().face(52, 3);
    const Vector ones = Vector::Ones(face.rows());
    for (FitMethod method : {FitMethod::mixture, FitMethod::map, FitMethod::exact})
        EXPECT_LT(mean_distance(neutralized(face, method), neutralized(face, method, ones)), 1e-3);
}

TEST(Neutralize, VerticesWithoutDataMayHoldAnything) {
    Points face = study().face(53, 1);
    Vector weights = Vector::Ones(face.rows());
    const Points whole = neutralized(face, FitMethod::mixture);
    for (Index i = 0; i < 40; ++i) weights[face.rows() - 1 - i] = 0.0;
    Points damaged = face;
    for (Index i = 0; i < 40; ++i) damaged.row(face.rows() - 1 - i).setConstant(1e6);
    const Points partial = neutralized(damaged, FitMethod::mixture, weights);
    double apart = 0;
    for (Index i = 0; i + 40 < face.rows(); ++i)
        apart = std::max(apart, (partial.row(i) - whole.row(i)).norm());
    EXPECT_LT(apart, 1.0);
}

TEST(Neutralize, SameBitsForAnyThreadCount) {
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const Points face = study().face(54, 4);
    const Vector weights = Vector::LinSpaced(face.rows(), 0.0, 1.0);
    EXPECT_TRUE(neutralize(Context(), trained_model<10>(), face, weights, {}).neutral_vertices ==
                neutralize(context, trained_model<10>(), face, weights, {}).neutral_vertices);
}

TEST(Neutralize, UncertaintyIsLargerWhereTheFaceIsUnseen) {
    const Points face = study().face(55, 1);
    NeutralizeOptions options;
    options.uncertainty = true;
    Vector weights = Vector::Ones(face.rows());
    const Vector seen =
        neutralize(Context(), trained_model<10>(), face, weights, options).uncertainty_mm;
    ASSERT_EQ(seen.size(), face.rows());
    for (Index i = 0; i < face.rows() / 2; ++i) weights[i] = 0.0;
    const Vector half =
        neutralize(Context(), trained_model<10>(), face, weights, options).uncertainty_mm;
    EXPECT_GT(half.mean(), 1.2 * seen.mean());
    EXPECT_GE(seen.minCoeff(), 0.0);
}

TEST(Neutralize, StatedUncertaintyHoldsTheErrorOfSeenAndOfUnseenVertices) {
    NeutralizeOptions options;
    options.uncertainty = true;
    Index held[2] = {0, 0}, count[2] = {0, 0};
    double error[2] = {0, 0}, stated[2] = {0, 0};
    for (int subject = 50; subject < 60; ++subject)
        for (int expression = 1; expression < 5; ++expression) {
            Points face = study().face(subject, expression);
            Vector weights = Vector::Ones(face.rows());
            for (Index i = 0; i < face.rows() / 2; ++i) {
                weights[i] = 0.0;
                face.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
            }
            const NeutralizationResult result =
                neutralize(Context(), trained_model<10>(), face, weights, options);
            EXPECT_EQ(neutralization_warnings(trained_model<10>(), result).empty(), false);
            const Points truth = study().neutral(subject);
            for (Index i = 0; i < face.rows(); ++i) {
                const int seen = weights[i] > 0.0;
                const double distance = (result.neutral_vertices.row(i) - truth.row(i)).norm();
                held[seen] += distance <= 2.0 * result.uncertainty_mm[i];
                error[seen] += distance;
                stated[seen] += result.uncertainty_mm[i];
                ++count[seen];
            }
        }
    for (int seen : {0, 1}) {
        EXPECT_GT(static_cast<double>(held[seen]), 0.85 * static_cast<double>(count[seen]))
            << "seen " << seen;
        EXPECT_LT(stated[seen], 5.0 * error[seen]) << "seen " << seen;  // and says something
    }
    EXPECT_TRUE(neutralization_warnings(
                    trained_model<10>(),
                    neutralize(Context(), trained_model<10>(), study().face(51, 1), Vector(), {}))
                    .empty());
}

TEST(Neutralize, ABadlyMeasuredNeutralFaceIsNotGivenAnExpression) {
    ASSERT_GT(trained_model<10>().expected_residual_mm, 0.0);
    // An error that varies smoothly over the face, far above what the training faces have.
    const Points truth = study().neutral(56);
    Points face = truth;
    for (Index i = 0; i < face.rows(); ++i)
        face(i, 2) += 2.0 * std::sin(0.09 * face(i, 0)) * std::cos(0.11 * face(i, 1));
    const NeutralizationResult careful =
        neutralize(Context(), trained_model<10>(), face, Vector(), {});
    EXPECT_GT(careful.doubted_share, 0.2);
    EXPECT_LT(careful.mean_displacement_mm, 0.2 * mean_distance(face, truth));
    EXPECT_EQ(careful.component_probabilities.size(), trained_model<10>().components.size());
    EXPECT_GT(careful.component_probabilities.front(), 0.5);
    // A face that was measured well is not treated with suspicion.
    EXPECT_EQ(neutralize(Context(), trained_model<10>(), truth, Vector(), {}).doubted_share, 0.0);
}

TEST(Neutralize, WhatNoFaceExplainsIsDoubtedAndMisleadsTheRestNoMore) {
    double before = 0, doubted = 0, believed = 0;
    for (int subject = 50; subject < 60; ++subject) {
        const Points truth = study().neutral(subject);
        Points face = study().face(subject, 1);
        const Points whole = face;
        // Hair: a lump over the upper rim, as high as nothing in the study.
        const Index first = face.rows() - 3 * study().side;
        for (Index i = first; i < face.rows(); ++i) face(i, 2) += 25.0;
        NeutralizeOptions trusting;
        trusting.fit.noise_mm2 =
            trained_model<10>().mixture_noise_mm2;  // a noise that is given is not questioned
        const NeutralizationResult careful =
            neutralize(Context(), trained_model<10>(), face, Vector(), {});
        EXPECT_GT(careful.doubted_share, 0.1);
        before += mean_distance(whole.topRows(first), truth.topRows(first));
        doubted += mean_distance(careful.neutral_vertices.topRows(first), truth.topRows(first));
        believed +=
            mean_distance(neutralize(Context(), trained_model<10>(), face, Vector(), trusting)
                              .neutral_vertices.topRows(first),
                          truth.topRows(first));
    }
    EXPECT_LT(doubted, 0.5 * before);
    EXPECT_LT(doubted, 0.7 * believed);
}

TEST(Neutralize, ADroppedJawIsNotTakenForANod) {
    NeutralizeOptions rigid;
    rigid.pose = Pose::rigid;
    double angle = 0;
    for (int subject = 50; subject < 60; ++subject) {
        const Similarity pose =
            neutralize(Context(), trained_model<10>(), study().face(subject, 1), Vector(), rigid)
                .pose;
        angle += std::acos(std::min(1.0, 0.5 * (pose.rotation.trace() - 1.0))) * 18.0 / 3.14159265;
    }
    EXPECT_LT(angle, 1.0);  // degrees, mean over the faces, which lie straight
}

TEST(Neutralize, RefusesWhatDoesNotFit) {
    auto status_of = [](auto&& action) {
        try {
            action();
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    Points face = study().face(50, 1);
    EXPECT_EQ(status_of([&] { neutralized(face.topRows(10), FitMethod::map); }), Status::mismatch);
    EXPECT_EQ(status_of([&] { neutralized(face, FitMethod::map, Vector::Ones(3)); }),
              Status::mismatch);
    EXPECT_EQ(status_of([&] { neutralized(face, FitMethod::map, -Vector::Ones(face.rows())); }),
              Status::invalid_argument);
    EXPECT_EQ(status_of([&] { neutralized(face, FitMethod::exact, Vector::Zero(face.rows())); }),
              Status::no_solution);
    face(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status_of([&] { neutralized(face, FitMethod::map); }), Status::invalid_mesh);
    Triangles other = study().triangles;
    std::swap(other(0, 0), other(0, 1));
    EXPECT_EQ(status_of([&] { check_topology(trained_model<10>(), face.rows(), other); }),
              Status::mismatch);
    EXPECT_EQ(
        status_of([&] { check_topology(trained_model<10>(), face.rows(), study().triangles); }),
        Status::ok);
}

}  // namespace
}  // namespace mien
