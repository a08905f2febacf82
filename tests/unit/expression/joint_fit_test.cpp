#include "expression/joint_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::study;
using test::trained_model;

JointFitOptions by_vertex() {
    JointFitOptions options;
    options.noise = JointNoise::isotropic;
    return options;
}

TEST(JointFit, OneFaceIsNeutralize) {
    const Points face = study().face(60, 2);
    const NeutralizationResult single =
        neutralize(Context(), trained_model<8>(), face, Vector(), {});
    const JointFit joint =
        fit_faces(Context(), trained_model<8>(), {{face, Vector()}}, by_vertex());
    EXPECT_EQ(joint.identity, single.identity);
    EXPECT_EQ(joint.expressions.at(0), single.expression);
    EXPECT_EQ(joint.covariance.rows(), single.expression.size());
    EXPECT_EQ(trained_model<8>().components[joint.chosen.at(0)].name, "smile");
}

TEST(JointFit, TheOrderOfTheFacesDoesNotMatter) {
    std::vector<JointFace> faces;
    for (int expression = 0; expression < 4; ++expression)
        faces.push_back({study().face(61, expression), Vector()});
    const JointFit there = fit_faces(Context(), trained_model<8>(), faces, by_vertex());
    std::reverse(faces.begin(), faces.end());
    const JointFit back = fit_faces(Context(), trained_model<8>(), faces, by_vertex());
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_LT((there.expressions[k] - back.expressions[3 - k]).norm(), 1e-6) << k;
    EXPECT_LT((there.identity - back.identity).norm(), 1e-6);
}

TEST(JointFit, MoreFacesLeaveLessDoubt) {
    const JointFace smiling{study().face(62, 2), Vector()};
    const JointFit two = fit_faces(Context(), trained_model<8>(),
                                   {smiling, {study().face(62, 1), Vector()}}, by_vertex());
    const JointFit three = fit_faces(
        Context(), trained_model<8>(),
        {smiling, {study().face(62, 1), Vector()}, {study().neutral(62), Vector()}}, by_vertex());
    EXPECT_LT(three.covariance.topLeftCorner(8, 8).trace(),
              two.covariance.topLeftCorner(8, 8).trace());
}

/// A filler where the smile moves the face: told of the zone, a fit must not see a smile in it.
TEST(JointFit, ATreatedZoneIsNoWitnessOfASingleFace) {
    const Points filler = study().face(63, 2) - study().neutral(63);
    const Points before = study().neutral(63), after = before + filler;
    NeutralizeOptions options;
    const Points taken =
        neutralize(Context(), trained_model<8>(), after, Vector(), options).neutral_vertices;
    for (Index v = 0; v < filler.rows(); ++v)
        if (filler.row(v).norm() > 0.02) options.treated.push_back(static_cast<std::uint32_t>(v));
    const NeutralizationResult kept =
        neutralize(Context(), trained_model<8>(), after, Vector(), options);
    EXPECT_LT(mean_distance(kept.neutral_vertices, after), 0.25 * mean_distance(taken, after));
    EXPECT_EQ(kept.unseen_share, 0) << "a treated vertex was seen";
    options.treated = {100000};
    EXPECT_THROW(neutralize(Context(), trained_model<8>(), after, Vector(), options), Error);
}

TEST(JointFit, RefusesSettingsOutOfRange) {
    const std::vector<JointFace> faces(2, {study().face(60, 1), Vector()});
    const auto refused = [&](const JointFitOptions& options) {
        try {
            fit_faces(Context(), trained_model<8>(), faces, options);
        } catch (const Error& error) {
            return error.status() == Status::invalid_argument;
        }
        return false;
    };
    EXPECT_FALSE(refused(by_vertex()));
    JointFitOptions options = by_vertex();
    options.face_noise_share = 0;
    EXPECT_TRUE(refused(options));
    options = by_vertex();
    options.search.candidates = 0;
    EXPECT_TRUE(refused(options));
    options = by_vertex();
    options.search.pose_steps = 21;
    EXPECT_TRUE(refused(options));
    options = by_vertex();
    options.fit.method = FitMethod::alternating;
    EXPECT_TRUE(refused(options));
}

}  // namespace
}  // namespace mien
