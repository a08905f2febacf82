#include "registration/registration.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "registration/report.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

double mean_error(const RegistrationResult& fit, const SmallFace& face, const Similarity& motion) {
    const Points truth = motion.apply(PointsRef(face.truth));
    return (fit.fitted.vertices - truth).rowwise().norm().mean();
}

TEST(Registration, RecoversAKnownDeformation) {
    const SmallFace face = small_face();
    const Similarity motion = motion_of(25, Vector3(1, 2, 0.5), Vector3(120, -60, 200));
    RegistrationSettings settings;
    settings.start.landmark_sigma_mm = 0.3;  // they are exact here
    const RegistrationResult fit =
        register_scan(face.model, scan_of(face, motion), landmarks_of(face, motion), settings, {});
    EXPECT_LT(mean_error(fit, face, motion), 1.0);
    EXPECT_LT(fit.residual_mm.cwiseAbs().mean(), 0.15);
    EXPECT_EQ(fit.verdict.quality, FitQuality::good) << registration_json(fit);
    EXPECT_EQ(fit.verdict.flipped_triangles, 0);
    EXPECT_LT((fit.motion.rotation - motion.rotation).norm(), 0.15);
    ASSERT_EQ(fit.correspondence.size(), static_cast<std::size_t>(face.truth.rows()));
    EXPECT_LT(fit.energy.back(), fit.energy.front());
}

TEST(Registration, CorrespondenceNamesPlacesOfTheScanAsGiven) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    scan.triangles.conservativeResize(scan.triangles.rows() + 1,
                                      3);  // a triangle that cleaning drops
    scan.triangles.bottomRows(1) << 5, 5, 6;
    scan.triangles.row(0).swap(scan.triangles.row(scan.triangles.rows() - 1));
    const RegistrationResult fit =
        register_scan(face.model, scan, landmarks_of(face, Similarity()), {}, {});
    for (std::size_t i = 0; i < fit.correspondence.size(); i += 17) {
        const SurfaceHit& hit = fit.correspondence[i];
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place +=
                hit.barycentric[k] * scan.vertices.row(scan.triangles(hit.triangle, k)).transpose();
        EXPECT_LT((place - hit.point).norm(), 1e-6);
    }
}

TEST(Registration, RigidMotionAndOrderOfTheScanChangeNothing) {
    const SmallFace face = small_face();
    const Similarity moved = motion_of(40, Vector3(-1, 1, 2), Vector3(-300, 50, 10));
    const RegistrationResult here = register_scan(face.model, scan_of(face, Similarity(), 1),
                                                  landmarks_of(face, Similarity()), {}, {});
    const RegistrationResult there =
        register_scan(face.model, scan_of(face, moved, 2), landmarks_of(face, moved), {}, {});
    const Points back = moved.inverse().apply(PointsRef(there.fitted.vertices));
    EXPECT_LT((back - here.fitted.vertices).rowwise().norm().maxCoeff(), 0.05);
    EXPECT_LT((back - here.fitted.vertices).rowwise().norm().mean(), 0.01);
}

TEST(Registration, ThreadsDoNotChangeABit) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult alone = register_scan(face.model, scan, landmarks, {}, {});
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const RegistrationResult together = register_scan(face.model, scan, landmarks, {}, context);
    EXPECT_EQ(alone.fitted.vertices, together.fitted.vertices);
    EXPECT_EQ(alone.confidence_mm, together.confidence_mm);
}

TEST(Registration, RecognisesMetresDecimetresAndCentimetres) {
    const SmallFace face = small_face();
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult mm =
        register_scan(face.model, scan_of(face, Similarity()), landmarks, {}, {});
    EXPECT_EQ(mm.verdict.unit_to_mm, 1);
    for (const double unit : {1000.0, 100.0, 10.0}) {
        TriMesh scan = scan_of(face, Similarity());
        scan.vertices /= unit;
        auto scaled = landmarks;
        for (LandmarkPoint& point : scaled) point.point /= unit;
        const RegistrationResult fit = register_scan(face.model, scan, scaled, {}, {});
        EXPECT_EQ(fit.verdict.unit_to_mm, unit);
        EXPECT_LT((fit.fitted.vertices - mm.fitted.vertices).rowwise().norm().maxCoeff(), 0.01);
        RegistrationSettings settings;
        settings.intake.units = UnitRule::refuse;
        EXPECT_THROW(register_scan(face.model, scan, scaled, settings, {}), Error);
    }
}

TEST(Registration, OneWrongLandmarkLosesItsSay) {
    const SmallFace face = small_face();
    auto landmarks = landmarks_of(face, Similarity());
    landmarks[4].point += Vector3(60, -45, 20);
    const RegistrationResult fit =
        register_scan(face.model, scan_of(face, Similarity()), landmarks, {}, {});
    ASSERT_EQ(fit.verdict.landmarks_rejected.size(), 1u);
    EXPECT_EQ(fit.verdict.landmarks_rejected[0], landmarks[4].name);
    EXPECT_LT(mean_error(fit, face, Similarity()), 1.1);
}

TEST(Registration, UnknownNamesAreReportedAndTooFewRefused) {
    const SmallFace face = small_face();
    auto landmarks = landmarks_of(face, Similarity());
    landmarks.push_back({"tail", Vector3(0, 0, 0)});
    const TriMesh scan = scan_of(face, Similarity());
    EXPECT_EQ(register_scan(face.model, scan, landmarks, {}, {}).unknown_landmarks,
              std::vector<std::string>{"tail"});
    RegistrationSettings settings;
    settings.start.kind = StartKind::landmarks;
    try {
        register_scan(face.model, scan, {landmarks[0], landmarks[1]}, settings, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::not_found);
    }
}

TEST(Registration, FindsThePoseByItself) {
    const SmallFace face = small_face();
    const Similarity motion = motion_of(45, Vector3(0.3, 1, 0.4), Vector3(80, 200, -150));
    const RegistrationResult fit = register_scan(face.model, scan_of(face, motion), {}, {}, {});
    EXPECT_LT((fit.motion.rotation - motion.rotation).norm(), 0.3);
    EXPECT_LT(fit.residual_mm.cwiseAbs().mean(), 0.3);
}

TEST(Registration, ExpectsALargerErrorWhereNothingHoldsAFitAlongTheSkin) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const RegistrationResult held =
        register_scan(face.model, scan, landmarks_of(face, Similarity()), {}, {});
    const RegistrationResult alone = register_scan(face.model, scan, {}, {}, {});
    ASSERT_FALSE(alone.verdict.expected.empty());
    EXPECT_EQ(alone.verdict.expected[0].zone, "face");
    EXPECT_GT(alone.verdict.expected[0].expected_mm, held.verdict.expected[0].expected_mm);
}

TEST(Registration, ReportsMonotoneProgressWithoutLandmarks) {
    struct Seen {
        std::int32_t stage = -1;
        double fraction = 0;
        bool monotone = true;
        static std::int32_t note(void* user, std::int32_t stage, double fraction) {
            Seen& seen = *static_cast<Seen*>(user);
            if (stage < seen.stage || (stage == seen.stage && fraction < seen.fraction))
                seen.monotone = false;
            seen.stage = stage;
            seen.fraction = fraction;
            return 0;
        }
    } seen;
    Context context;
    context.progress_function = &Seen::note;
    context.progress_user = &seen;
    const SmallFace face = small_face();
    register_scan(face.model, scan_of(face, Similarity()), {}, {}, context);
    EXPECT_TRUE(seen.monotone);
    EXPECT_EQ(seen.fraction, 1);
}

TEST(Registration, StartsFromAGivenPose) {
    const SmallFace face = small_face();
    const Similarity motion =
        motion_of(100, Vector3(0, 1, 0), Vector3(80, 0, -15));  // beyond the search
    RegistrationSettings settings;
    settings.start.kind = StartKind::pose;
    settings.start.pose = motion_of(95, Vector3(0, 1, 0), Vector3(84, 2, -12));
    const RegistrationResult fit =
        register_scan(face.model, scan_of(face, motion), {}, settings, {});
    EXPECT_LT(fit.residual_mm.cwiseAbs().mean(), 0.3);
}

TEST(Registration, TrianglesFacingInwardsAndCloudsAreFitted) {
    const SmallFace face = small_face();
    const auto landmarks = landmarks_of(face, Similarity());
    TriMesh inward = scan_of(face, Similarity());
    inward.triangles.col(0).swap(inward.triangles.col(1));
    EXPECT_LT(mean_error(register_scan(face.model, inward, landmarks, {}, {}), face, Similarity()),
              1.1);
    TriMesh cloud = scan_of(face, Similarity());
    cloud.triangles.resize(0, 3);
    EXPECT_LT(mean_error(register_scan(face.model, cloud, landmarks, {}, {}), face, Similarity()),
              1.5);
}

TEST(Registration, ASphereIsNoFace) {
    const SmallFace face = small_face();
    TriMesh sphere = face_sheet(40);
    for (Index i = 0; i < sphere.vertices.rows(); ++i) {
        const double a = sphere.vertices(i, 0) / 70 * 3.1, b = sphere.vertices(i, 1) / 90 * 1.5;
        sphere.vertices.row(i) << 95 * std::sin(a) * std::cos(b), 95 * std::sin(b),
            95 * std::cos(a) * std::cos(b);
    }
    const RegistrationResult fit = register_scan(face.model, sphere, {}, {}, {});
    EXPECT_NE(fit.verdict.quality, FitQuality::good) << registration_json(fit);
    EXPECT_FALSE(fit.verdict.reasons.empty());
}

// The bare sheet slides: a fit by its form alone ends beside a mouth that has gone up.
TEST(Registration, ColorsHoldTheFitAlongTheSkin) {
    SmallFace face = small_face(60);
    Points& v = face.model.template_mesh.vertices;
    for (Index i = 0; i < v.rows(); ++i) v(i, 2) = -0.002 * v.row(i).head<2>().squaredNorm();
    face.truth = v;
    Zone lips{"lips", {}};
    TriMesh scan;
    scan.vertices = v;
    scan.triangles = face.model.template_mesh.triangles;
    scan.colors.resize(v.rows(), 3);
    for (Index i = 0; i < v.rows(); ++i) {
        const auto inside = [&](double up) {
            return v(i, 0) * v(i, 0) / 900 + (v(i, 1) - up) * (v(i, 1) - up) / 144 < 1;
        };
        if (inside(-40)) lips.vertices.push_back(static_cast<std::uint32_t>(i));
        const std::uint8_t green = inside(-36) ? 90 : 160;
        scan.colors.row(i) << 200, green, 130;
    }
    face.model.zones.push_back(lips);
    RegistrationSettings settings;
    settings.start.kind = StartKind::pose;
    settings.prior.estimate_motion = false;
    const auto rise = [&](bool colors) {
        settings.colors.enabled = colors;
        const RegistrationResult fit = register_scan(face.model, scan, {}, settings, {});
        EXPECT_EQ(fit.verdict.colors.size(), colors ? 1u : 0u);
        double sum = 0;
        for (const std::uint32_t i : lips.vertices) sum += fit.fitted.vertices(i, 1) - v(i, 1);
        return sum / static_cast<double>(lips.vertices.size());
    };
    EXPECT_NEAR(rise(true), 4, 1);
    EXPECT_LT(std::abs(rise(false)), 0.5);
}

TEST(Registration, RefusesSettingsOutOfRange) {
    const SmallFace face = small_face(12);
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const auto refused = [&](auto change) {
        RegistrationSettings settings;
        change(settings);
        EXPECT_THROW(register_scan(face.model, scan, landmarks, settings, {}), Error);
    };
    refused([](RegistrationSettings& s) { s.fit.loop.sigma_end_mm = 0; });
    refused([](RegistrationSettings& s) { s.start.landmark_sigma_mm = -1; });
    refused([](RegistrationSettings& s) { s.fit.loop.rounds = 0; });
    refused([](RegistrationSettings& s) { s.fit.loop.evidence.surface.tangential = 2; });
    refused([](RegistrationSettings& s) { s.intake.weight_per_vertex = Vector::Ones(3); });
    refused([&](RegistrationSettings& s) {
        s.intake.weight_per_vertex = Vector::Constant(scan.vertices.rows(), -1.0);
    });
    refused([](RegistrationSettings& s) {
        s.start.kind = StartKind::pose;
        s.start.pose.rotation *= 2;
    });
    auto bad = landmarks;
    bad[0].point[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(register_scan(face.model, scan, bad, {}, {}), Error);
}

TEST(Registration, CancelsAtAProgressPoint) {
    const SmallFace face = small_face();
    Context context;
    context.progress_function = [](void*, std::int32_t stage, double) -> std::int32_t {
        return stage == static_cast<std::int32_t>(Stage::fitting) ? 1 : 0;
    };
    try {
        register_scan(face.model, scan_of(face, Similarity()), landmarks_of(face, Similarity()), {},
                      context);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::cancelled);
    }
}

TEST(Registration, EveryGrowthOfModesEndsWithAll) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    for (const ModeGrowth growth :
         {ModeGrowth::constant, ModeGrowth::linear, ModeGrowth::exponential, ModeGrowth::cubic}) {
        RegistrationSettings settings;
        settings.fit.loop.growth = growth;
        EXPECT_LT(mean_error(register_scan(face.model, scan, landmarks, settings, {}), face,
                             Similarity()),
                  1.5);
    }
}

TEST(Registration, LessIsKnownWhereNothingWasScanned) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    Index kept = 0;
    for (Index t = 0; t < scan.triangles.rows(); ++t)
        if (scan.vertices(scan.triangles(t, 0), 0) < 20)
            scan.triangles.row(kept++) = scan.triangles.row(t);
    scan.triangles.conservativeResize(kept, 3);
    std::vector<LandmarkPoint> landmarks;
    for (const LandmarkPoint& point : landmarks_of(face, Similarity()))
        if (point.point[0] < 20) landmarks.push_back(point);
    const RegistrationResult fit = register_scan(face.model, scan, landmarks, {}, {});
    double seen = 0, unseen = 0;
    Index num_seen = 0, num_unseen = 0;
    for (Index i = 0; i < face.truth.rows(); ++i)
        if (face.truth(i, 0) < 10)
            seen += fit.confidence_mm[i], ++num_seen;
        else if (face.truth(i, 0) > 40)
            unseen += fit.confidence_mm[i], ++num_unseen;
    EXPECT_GT(unseen / static_cast<double>(num_unseen), 2 * seen / static_cast<double>(num_seen));
}

}  // namespace
}  // namespace mien
