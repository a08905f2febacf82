// The jaw of a face without landmarks: how it turns, and how far it is found open.
#include "registration/jaw_search.hpp"

#include <gtest/gtest.h>

#include "registration/free_start.hpp"
#include "registration/registration.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

// Ears and jaw of a face 140 mm wide, chin forward and below, lips at the middle.
SmallFace jawed_face() {
    SmallFace face = small_face();
    face.model.landmarks.clear();
    const auto add = [&](const char* name, double x, double y) {
        Index nearest;
        const Points& v = face.model.template_mesh.vertices;
        ((v.col(0).array() - x).square() + (v.col(1).array() - y).square()).minCoeff(&nearest);
        face.model.landmarks.push_back({name, static_cast<std::uint32_t>(nearest)});
    };
    add("jaw_00", -66, 20), add("jaw_16", 66, 20), add("jaw_03", -60, -30), add("jaw_08", 0, -70);
    add("mouth_outer_03", 0, -30), add("mouth_outer_09", 0, -42);
    return face;
}

TEST(Jaw, OpensDownwardsAndLeavesTheUpperFace) {
    const SmallFace face = jawed_face();
    FitState state;
    state.motion = motion_of(30, Vector3(1, 1, 0), Vector3(10, 20, 30));
    JawSettings settings;
    settings.axis_back = 0.12;  // the sheet ends before the ears
    for (const Pin& pin : open_jaw(face.model, state, 0.4, settings)) {
        const Vector3 place = face.model.template_mesh.vertices.row(pin.vertex).transpose();
        const Vector3 moved = state.motion.inverse().apply(pin.place) - place;
        std::string name;
        for (const Landmark& l : face.model.landmarks)
            if (l.vertex == static_cast<std::uint32_t>(pin.vertex)) name = l.name;
        if (name == "jaw_08" || name == "mouth_outer_09")
            EXPECT_LT(moved[1], -8) << name;
        else
            EXPECT_LT(moved.norm(), 1e-9) << name;
    }
    for (const Pin& pin : open_jaw(face.model, state, 0, {}))
        EXPECT_LT((state.motion.inverse().apply(pin.place) -
                   Vector3(face.model.template_mesh.vertices.row(pin.vertex).transpose()))
                      .norm(),
                  1e-9);
}

TEST(Jaw, WithoutItsLandmarksThereIsNone) {
    EXPECT_TRUE(open_jaw(small_face().model, FitState(), 0.4, {}).empty());
    EXPECT_FALSE(open_jaw(jawed_face().model, FitState(), 0.4, {}).empty());
}

// A first fit of `face` scanned as its truth says, and what the search of the jaw makes of it.
struct FoundJaw {
    FitState approach, found;
};

FoundJaw find_jaw(const SmallFace& face) {
    const RegistrationSettings settings;
    const PreparedScan scan = prepare_scan(scan_of(face, Similarity()), settings.intake, {});
    const PriorState prior =
        choose_prior(face.model, settings.prior, settings.inner, settings.colors, {});
    const ScanView view(scan.surface);
    const std::vector<Pin> no_pins;
    const FitProblem problem{face.model, view, prior.inner, prior.colors, no_pins};
    FoundJaw jaw;
    jaw.approach = jaw.found = prior.state_at_rest();
    OpeningSettings shut;
    shut.enabled = false;
    start_freely(problem, prior, settings.fit.loop, settings.start.approach, shut, jaw.approach,
                 {});
    start_freely(problem, prior, settings.fit.loop, settings.start.approach, {}, jaw.found, {});
    return jaw;
}

double off(const SmallFace& face, const FitState& state, const char* name) {
    for (const Landmark& l : face.model.landmarks)
        if (l.name == name) return (state.places.row(l.vertex) - face.truth.row(l.vertex)).norm();
    ADD_FAILURE() << name;
    return 0;
}

TEST(Jaw, AnOpenOneIsWhatThePriorExpectsAndTheChinGoesWithIt) {
    SmallFace face = jawed_face();
    FitState open;
    open.coefficients.kernel.setZero(face.model.basis.cols, 3);
    open.kernel_amplitude = 2;
    fit_pins(face.model, open_jaw(face.model, open, 0.35, {}), {}, {}, open, {});
    face.truth = face.model.template_mesh.vertices + open.displacement;
    const FoundJaw jaw = find_jaw(face);
    ASSERT_EQ(jaw.found.kernel_mean.rows(), jaw.found.coefficients.kernel.rows());
    EXPECT_GT(jaw.found.kernel_mean.norm(), 0.5 * open.coefficients.kernel.norm());
    EXPECT_LT(off(face, jaw.found, "jaw_08"), 0.5 * off(face, jaw.approach, "jaw_08"));
}

TEST(Jaw, AShutOneIsLeftShut) {
    SmallFace face = jawed_face();
    face.truth = face.model.template_mesh.vertices;
    const FoundJaw jaw = find_jaw(face);
    EXPECT_EQ(jaw.found.kernel_mean.rows(), 0);
    EXPECT_LT(off(face, jaw.found, "jaw_08"), 0.5);
}

}  // namespace
}  // namespace mien
