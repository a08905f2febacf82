#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <random>

#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::Study;

Similarity small_motion(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Similarity motion;
    const Vector3 axis(normal(random), normal(random), normal(random));
    motion.rotation = Eigen::AngleAxisd(0.03, axis.normalized()).toRotationMatrix();
    motion.translation = Vector3(normal(random), normal(random), normal(random));
    return motion;
}

TEST(Posture, AlignmentOnAStableZoneTakesRigidMotionOutOfTrainingAndFit) {
    const Study study;
    FaceDatasetWriter posed(study.triangles, study.rest.rows(), study.names);
    for (int subject = 0; subject < study.subjects; ++subject)
        for (int expression = 0; expression < 5; ++expression)
            posed.add(small_motion(static_cast<unsigned>(100 * subject + expression))
                          .apply(PointsRef(study.face(subject, expression))),
                      subject, expression);
    TrainOptions options;
    options.subspaces.identity_modes = 10;
    options.subspaces.expression_modes = 8;
    const auto data = Study::written(posed, "posture");
    const auto loose = train_expression_model(data, options, Context());
    for (Index i = 0; i < study.rest.rows(); ++i)
        if (study.rest(i, 1) > 70) options.stable_vertices.push_back(static_cast<std::uint32_t>(i));
    const auto aligned = train_expression_model(data, options, Context());
    const std::string path = Study::path("posture_model");
    save_expression_model(path, *aligned, Context());
    EXPECT_EQ(load_expression_model(path, {}, Context())->stable_vertices, options.stable_vertices);
    std::remove(path.c_str());

    double error_loose = 0, error_aligned = 0;
    for (int subject = 40; subject < 48; ++subject) {
        const Similarity motion = small_motion(static_cast<unsigned>(subject));
        const Points face = motion.apply(PointsRef(study.face(subject, 1)));
        const Points truth = motion.apply(PointsRef(study.neutral(subject)));
        error_loose += mean_distance(
            neutralize(Context(), *loose, face, Vector(), {}).neutral_vertices, truth);
        error_aligned += mean_distance(
            neutralize(Context(), *aligned, face, Vector(), {}).neutral_vertices, truth);
    }
    EXPECT_LT(error_aligned, 0.8 * error_loose);
}

}  // namespace
}  // namespace mien
