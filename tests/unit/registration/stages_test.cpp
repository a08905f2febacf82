// The stages one by one: what each takes from those before, and that nothing else passes between
// them.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.hpp"
#include "registration/output.hpp"
#include "registration/registration.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

Status status_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.status();
    }
    return Status::ok;
}

PriorState prior_of(const DeformationModel& model, const RegistrationSettings& settings = {}) {
    return choose_prior(model, settings.prior, settings.inner, settings.colors, {});
}

TEST(Stages, ByHandInTheirOrderGiveTheFitOfRegisterScan) {
    const SmallFace face = small_face();
    const RegistrationSettings settings;
    const auto landmarks = landmarks_of(face, Similarity());
    const LoopSettings& loop = settings.fit.loop;
    const PreparedScan scan = prepare_scan(scan_of(face, Similarity()), settings.intake, {});
    const PriorState prior = prior_of(face.model);
    const StartState start =
        find_start(face.model, scan, prior, landmarks, settings.start, loop, {});
    const FitOutcome fit = fit_surface(face.model, prior, start, settings.fit, {});
    const VertexRings rings =
        build_rings(face.model.num_vertices(), face.model.template_mesh.triangles);
    const GapState gap = close_gap(face.model, start.scan, prior, fit.state, rings, loop.match,
                                   loop.sigma_end_mm, settings.gap, {});
    const InnerPartsState inner = settle_inner_parts(
        face.model, prior, fit.state, rings, gap.places, settings.inner, settings.folds, {});
    const RegistrationResult by_hand =
        make_result({face.model, scan, prior, start, fit, gap, inner}, settings, {});
    const RegistrationResult whole =
        register_scan(face.model, scan_of(face, Similarity()), landmarks, settings, {});
    EXPECT_EQ(by_hand.fitted.vertices, whole.fitted.vertices);
    EXPECT_EQ(by_hand.confidence_mm, whole.confidence_mm);
    EXPECT_EQ(by_hand.energy, whole.energy);
}

TEST(Stages, OnePreparedScanAndOnePriorServeManyFits) {
    const SmallFace face = small_face();
    const Similarity motion = motion_of(30, Vector3(1, 1, 0), Vector3(50, 20, -10));
    TriMesh raw = scan_of(face, motion);
    raw.triangles.col(0).swap(raw.triangles.col(1));  // facing inwards: each fit turns its own view
    const auto landmarks = landmarks_of(face, motion);
    const RegistrationResult alone = register_scan(face.model, raw, landmarks, {}, {});
    const PreparedScan scan = prepare_scan(raw, {}, {});
    const PriorState prior = prior_of(face.model);
    for (int turn = 0; turn < 2; ++turn) {
        const RegistrationResult fit =
            register_prepared(face.model, scan, prior, landmarks, {}, {});
        EXPECT_EQ(fit.fitted.vertices, alone.fitted.vertices);
        EXPECT_EQ(fit.residual_mm, alone.residual_mm);
    }
}

TEST(Stages, AScanTurnedOverShowsItsOtherSideAndStaysAsItWas) {
    const ScanSurface surface = build_scan_surface(face_sheet(20), {}, {});
    ScanView view(surface);
    const SurfaceHit hit = surface.tree.closest(Vector3(10, 20, 60));
    const Vector3 normal = view.normal_at(hit);
    const Matrix3 bending = view.bending_at(hit);
    view.turn_over();
    EXPECT_TRUE(view.turned_over());
    EXPECT_EQ(view.normal_at(hit), -normal);
    EXPECT_EQ(view.bending_at(hit), -bending);
    EXPECT_EQ(surface.normal_at(hit), normal);
    view.turn_over();
    EXPECT_EQ(view.normal_at(hit), normal);
}

TEST(Stages, IntakeGivesMillimetresWeightsAndTheNumbersOfTheRawScan) {
    const SmallFace face = small_face(20);
    TriMesh raw = scan_of(face, Similarity());
    raw.vertices /= 10;
    raw.vertices.conservativeResize(raw.vertices.rows() + 1, 3);
    raw.vertices.bottomRows(1).setConstant(std::numeric_limits<double>::quiet_NaN());
    IntakeSettings settings;
    settings.weight_per_vertex = Vector::LinSpaced(raw.vertices.rows(), 0, 1);
    const PreparedScan scan = prepare_scan(raw, settings, {});
    EXPECT_EQ(scan.unit_to_mm, 10);
    ASSERT_EQ(scan.surface.vertices.rows(), raw.vertices.rows() - 1);
    for (Index i = 0; i < scan.surface.vertices.rows(); ++i) {
        const std::uint32_t old = scan.vertex_to_raw[static_cast<std::size_t>(i)];
        EXPECT_EQ(scan.surface.vertices.row(i), 10 * raw.vertices.row(old));
        EXPECT_EQ(scan.surface.weight[i], settings.weight_per_vertex[old]);
    }
    EXPECT_FALSE(scan.surface.has_colors());
}

TEST(Stages, TheStartSaysWhichLandmarksHoldAndWhichDoNot) {
    const SmallFace face = small_face();
    auto landmarks = landmarks_of(face, Similarity());
    landmarks[3].point += Vector3(50, 40, -20);
    landmarks.push_back({"tail", Vector3::Zero()});
    const PreparedScan scan = prepare_scan(scan_of(face, Similarity()), {}, {});
    const RegistrationSettings settings;
    const StartState start = find_start(face.model, scan, prior_of(face.model), landmarks,
                                        settings.start, settings.fit.loop, {});
    EXPECT_EQ(start.pins.size(), face.model.landmarks.size() - 1);
    EXPECT_EQ(start.unknown, std::vector<std::string>{"tail"});
    EXPECT_EQ(start.rejected, std::vector<std::string>{landmarks[3].name});
    EXPECT_FALSE(start.is_free());
    EXPECT_FALSE(start.scan.turned_over());
}

TEST(Stages, AFreeFitDerivesItsOwnWeights) {
    const FitSettings settings;
    EXPECT_EQ(loop_for(settings, false).evidence.surface.weight,
              settings.loop.evidence.surface.weight);
    EXPECT_EQ(loop_for(settings, true).evidence.surface.weight, settings.free.surface_weight);
    EXPECT_EQ(loop_for(settings, true).evidence.color.weight, settings.free.color_weight);
}

TEST(Stages, SwitchedOffGapAndInnerPartsLeaveThePlacesAlone) {
    const SmallFace face = small_face();
    RegistrationSettings settings;
    settings.gap.enabled = settings.folds.straighten = settings.inner.carry = false;
    const PreparedScan scan = prepare_scan(scan_of(face, Similarity()), {}, {});
    const PriorState prior = prior_of(face.model);
    FitState state = prior.state_at_rest();
    state.places = face.model.template_mesh.vertices;
    const VertexRings rings =
        build_rings(face.model.num_vertices(), face.model.template_mesh.triangles);
    const GapState gap =
        close_gap(face.model, scan.surface, prior, state, rings, {}, 0.5, settings.gap, {});
    EXPECT_EQ(gap.places, state.places);
    EXPECT_EQ(gap.weight.size(), 0);
    const InnerPartsState inner = settle_inner_parts(face.model, prior, state, rings, gap.places,
                                                     settings.inner, settings.folds, {});
    EXPECT_EQ(inner.places, state.places);
}

TEST(Stages, ThePriorNeedsNoScanAndFollowsItsSettings) {
    const SmallFace face = small_face(20);
    RegistrationSettings settings;
    settings.prior.max_scalar_modes = 7;
    const PriorState few = prior_of(face.model, settings);
    EXPECT_EQ(few.scalar_modes, 7);
    EXPECT_EQ(few.state_at_rest().coefficients.kernel.rows(), 7);
    EXPECT_TRUE(few.freedom.scale) << "no trained mode knows sizes";
    EXPECT_EQ(few.pin_pca_amplitude(), 0);
    EXPECT_FALSE(few.amplitude_given);
}

// It once returned 10 mm everywhere after a failed factorisation.
TEST(Confidence, RefusesEquationsThatHaveNoFactor) {
    const SmallFace face = small_face(20);
    const FitState state = prior_of(face.model).state_at_rest();
    const Index n = face.model.num_vertices();
    const Points normals = Points::Constant(n, 3, 0.5);
    const auto call = [&](double sigma_mm) {
        const std::vector<Pin> pins{{3, Vector3::Zero(), sigma_mm}};
        return place_deviation(face.model, state, {}, Vector::Ones(n), normals, pins, 0.5, {}, {});
    };
    EXPECT_EQ(status_of([&] { call(1e-30); }), Status::no_solution);
    EXPECT_GT(call(2).minCoeff(), 0);
}

// An eigenproblem or factorisation without a solution passed for landmarks without a contradiction.
TEST(Pins, RefuseACovarianceThatHasNoFactor) {
    const SmallFace face = small_face(20);
    std::vector<Pin> pins;
    for (const Landmark& l : face.model.landmarks)
        pins.push_back({static_cast<Index>(l.vertex), face.truth.row(l.vertex).transpose(), 1.0});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status_of([&] { contradicting_pins(face.model, pins, {}, nan, 1, {}, {}); }),
              Status::no_solution);
    EXPECT_EQ(status_of([&] { weigh_pins(face.model, pins, {}, nan, 1, {}, {}); }),
              Status::no_solution);
}

}  // namespace
}  // namespace mien
