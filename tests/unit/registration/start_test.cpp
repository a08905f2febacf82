#include "registration/start.hpp"

#include <gtest/gtest.h>

#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

// Picks of the true face's landmarks with a Gaussian error, said to be `stated_mm`.
std::vector<Pin> noisy_pins(const SmallFace& face, double noise_mm, double stated_mm) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, noise_mm);
    std::vector<Pin> pins;
    for (const Landmark& l : face.model.landmarks) {
        const Vector3 noise(normal(random), normal(random), normal(random));
        pins.push_back({static_cast<Index>(l.vertex), face.truth.row(l.vertex).transpose() + noise,
                        stated_mm});
    }
    return pins;
}

TEST(Pins, ExactPicksAreFoundExact) {
    const SmallFace face = small_face();
    EXPECT_LT(weigh_pins(face.model, noisy_pins(face, 0.05, 1.5), Similarity(), 1, 1, {}, {}).noise,
              0.7);
    EXPECT_GT(weigh_pins(face.model, noisy_pins(face, 1.5, 1.5), Similarity(), 1, 1, {}, {}).noise,
              0.8);
}

// The face lies half a deviation off along each mode.
TEST(Pins, TheKernelsAmplitudeFollowsTheFace) {
    const SmallFace face = small_face();
    EXPECT_GT(weigh_pins(face.model, noisy_pins(face, 0.05, 1.5), Similarity(), 0.25, 1, {}, {})
                  .amplitude,
              1.4);
    EXPECT_LT(
        weigh_pins(face.model, noisy_pins(face, 0.05, 1.5), Similarity(), 4, 1, {}, {}).amplitude,
        0.5);
}

TEST(Pins, TrainedModesKeepTheirAmplitude) {
    SmallFace face = small_face();
    // The same modes as trained ones that know faces half as different as this one is.
    const Index n = face.truth.rows(), r = face.model.basis.cols;
    auto trained = std::make_shared<Eigen::MatrixXf>(Eigen::MatrixXf::Zero(3 * n, 3 * r));
    for (Index i = 0; i < n; ++i)
        for (Index axis = 0; axis < 3; ++axis)
            trained->row(3 * i + axis).segment(axis * r, r) = 0.5f * face.model.basis.map().row(i);
    face.model.pca_modes = {trained->data(), 3 * n, 3 * r};
    const PinFactors evidence =
        weigh_pins(face.model, noisy_pins(face, 0.05, 1.5), Similarity(), 1e-3, 1, {}, {});
    EXPECT_EQ(evidence.amplitude, 1);
    EXPECT_LT(evidence.noise, 0.7);
    // Left out of the fit they leave the amplitude to the landmarks.
    EXPECT_GT(weigh_pins(face.model, noisy_pins(face, 0.05, 1.5), Similarity(), 0.25, 0, {}, {})
                  .amplitude,
              1.4);
}

}  // namespace
}  // namespace mien
