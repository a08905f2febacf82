#include "expression/evaluation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "base/error.hpp"
#include "expression/training.hpp"
#include "study.hpp"

namespace mien {
namespace {

using test::Study;

TEST(Evaluation, EffectSizesAreTheTextbookForms) {
    // means 3 and 1, variances 1 and 1
    const Effect effect = effect_size({2, 3, 4}, {0, 1, 2});
    EXPECT_NEAR(effect.cohens_d, 2.0, 1e-12);
    EXPECT_NEAR(effect.superiority, 0.92135039647, 1e-9);  // Phi(2 / sqrt 2)
    const Effect reversed = effect_size({0, 1, 2}, {2, 3, 4});
    EXPECT_NEAR(reversed.cohens_d, -2.0, 1e-12);
    EXPECT_NEAR(reversed.superiority + effect.superiority, 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(effect_size({1, 1}, {1, 1}).cohens_d));
}

TEST(Evaluation, BaselineIsTheDistanceToTheSubjectsNeutral) {
    const Study study;
    const auto data = study.dataset(0, 3, "evaluate");
    const EvaluatedFaces errors = evaluate_faces(Context(), *data, {}, nullptr);
    ASSERT_EQ(errors.face.size(), 15u);
    Points face, neutral;
    data->face(0, neutral);
    data->face(2, face);
    EXPECT_NEAR(errors.mean_mm[2], test::mean_distance(face, neutral), 1e-12);
    EXPECT_EQ(errors.mean_mm[0], 0.0);
    const ErrorSummary moved = summarize_moved(errors, 0);
    EXPECT_EQ(moved.count, 12);
    EXPECT_GT(moved.mean_mm, 0.3);
    EXPECT_EQ(summarize(errors, data->expression_names()).size(), 5u);
}

TEST(Evaluation, ZoneAndAlignmentAreHeeded) {
    const Study study;
    FaceDatasetWriter writer(study.triangles, study.rest.rows(), study.names);
    writer.add(study.neutral(1), 1, 0);
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.1, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    motion.translation = Vector3(3, -2, 1);
    writer.add(motion.apply(PointsRef(study.face(1, 1))), 1, 1);
    const auto data = Study::written(writer, "posed");
    EvaluationOptions options;
    const double posed = evaluate_faces(Context(), *data, options, nullptr).mean_mm[1];
    for (Index i = 0; i < study.rest.rows(); ++i)
        if (study.rest(i, 1) > 95) options.stable.push_back(static_cast<std::uint32_t>(i));
    const double aligned = evaluate_faces(Context(), *data, options, nullptr).mean_mm[1];
    EXPECT_LT(aligned, 0.5 * posed);
    options.zone = options.stable;  // "open" does not move the stable zone
    EXPECT_LT(evaluate_faces(Context(), *data, options, nullptr).mean_mm[1], 0.1 * aligned);
    options.zone = {1000000};
    EXPECT_THROW(evaluate_faces(Context(), *data, options, nullptr), Error);
}

TEST(Evaluation, ModelLowersTheErrors) {
    const Study study;
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    const auto model =
        train_expression_model(study.dataset(0, study.subjects, "evaltrain"), options, Context());
    const auto test_set = study.dataset(40, 44, "evaltest");
    const EvaluatedFaces before = evaluate_faces(Context(), *test_set, {}, nullptr);
    const EvaluatedFaces after = evaluate_model(Context(), *test_set, *model, {});
    EXPECT_LT(summarize_moved(after, 0).mean_mm, 0.5 * summarize_moved(before, 0).mean_mm);
    EXPECT_GT(effect_size(before.mean_mm, after.mean_mm).cohens_d, 0.5);
}

}  // namespace
}  // namespace mien
