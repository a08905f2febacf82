// What is settled before a fit: units, frames, sides, windings, wrong landmarks, any pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/winding.hpp"
#include "registration/registration.hpp"
#include "registration/report.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

double mean_error_of(const RegistrationResult& fit, const SmallFace& face,
                     const Similarity& motion) {
    return (fit.fitted.vertices - motion.apply(PointsRef(face.truth))).rowwise().norm().mean();
}

std::string message_of(const SmallFace& face, const TriMesh& scan,
                       const std::vector<LandmarkPoint>& landmarks) {
    try {
        register_scan(face.model, scan, landmarks, {}, {});
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::mismatch) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "was not refused";
    return "";
}

/// Landmarks with every name given to the one across the face: p0 .. p4 and p10 .. p14.
std::vector<LandmarkPoint> exchanged(std::vector<LandmarkPoint> landmarks, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) std::swap(landmarks[k].point, landmarks[10 + k].point);
    return landmarks;
}

TEST(LandmarkFrame, LandmarksInAnotherUnitThanTheScanAreBroughtToIt) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult mm = register_scan(face.model, scan, landmarks, {}, {});
    EXPECT_TRUE(mm.verdict.notes.empty());
    for (const double unit : {1000.0, 25.4, 10.0}) {
        TriMesh other = scan;
        other.vertices /= unit;
        const RegistrationResult fit = register_scan(face.model, other, landmarks, {}, {});
        EXPECT_EQ(fit.verdict.unit_to_mm, unit);
        EXPECT_LT((fit.fitted.vertices - mm.fitted.vertices).rowwise().norm().maxCoeff(), 0.01);
        ASSERT_EQ(fit.verdict.notes.size(), 1u);
        EXPECT_NE(fit.verdict.notes[0].find("another unit"), std::string::npos);
    }
}

// One landmark at 1e30 had all the say in sums of places: "alignment points lie on one line".
TEST(Landmarks, OneFarBeyondTheScanIsLeftOutBeforeAnythingIsAligned) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    std::vector<LandmarkPoint> landmarks = landmarks_of(face, Similarity());
    const std::string name = landmarks[4].name;
    std::vector<LandmarkPoint> others = landmarks;
    others.erase(others.begin() + 4);
    const RegistrationResult without = register_scan(face.model, scan, others, {}, {});
    for (const double place : {1e30, -1e9, 1e300}) {
        landmarks[4].point = Vector3(0, place, 0);
        const RegistrationResult fit = register_scan(face.model, scan, landmarks, {}, {});
        EXPECT_EQ(fit.verdict.landmarks_rejected, std::vector<std::string>{name});
        EXPECT_EQ(fit.fitted.vertices, without.fitted.vertices) << place;
    }
}

TriMesh joined(const TriMesh& a, const TriMesh& b, const Vector3& moved_by) {
    TriMesh both;
    both.vertices.resize(a.vertices.rows() + b.vertices.rows(), 3);
    both.vertices << a.vertices, b.vertices.rowwise() + moved_by.transpose();
    both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
    both.triangles << a.triangles,
        (b.triangles.array() + static_cast<std::uint32_t>(a.vertices.rows())).matrix();
    return both;
}

// A fit follows one of two surfaces and looks good: 3.8 mm off on two visits in one file.
TEST(ScanPieces, TwoSurfacesOverEachOtherAreDoubtedAndOnesBesideAreNoted) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const PieceSettings settings;
    EXPECT_TRUE(find_pieces(scan, settings).doubt.empty());
    EXPECT_TRUE(find_pieces(scan, settings).note.empty());
    const double extent =
        (scan.vertices.colwise().maxCoeff() - scan.vertices.colwise().minCoeff()).norm();
    const TriMesh merged = joined(scan, scan, Vector3(0, 0.01 * extent, 0.01 * extent));
    PieceFindings found = find_pieces(merged, settings);
    EXPECT_NE(found.doubt.find("over each other"), std::string::npos);
    found = find_pieces(joined(scan, scan, Vector3(2 * extent, 0, 0)), settings);
    EXPECT_TRUE(found.doubt.empty());
    EXPECT_NE(found.note.find("second piece"), std::string::npos);
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult fit = register_scan(face.model, merged, landmarks, {}, {});
    EXPECT_NE(fit.verdict.quality, FitQuality::good);
    TriMesh small = scan;
    small.triangles.conservativeResize(scan.triangles.rows() / 3, 3);
    EXPECT_TRUE(find_pieces(joined(scan, small, Vector3(0, 1, 1)), settings).doubt.empty());
}

std::string reasons_of(const RegistrationResult& fit) {
    std::string text;
    for (const std::string& reason : fit.verdict.reasons) text += reason + "\n";
    return text;
}

TEST(LandmarkFrame, AScanInNoUnitIsTakenToBeOfTheTemplatesSizeAndDoubted) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    auto landmarks = landmarks_of(face, Similarity());
    scan.vertices /= 53;
    for (LandmarkPoint& landmark : landmarks) landmark.point /= 53;
    RegistrationResult fit = register_scan(face.model, scan, landmarks, {}, {});
    EXPECT_NEAR(fit.verdict.unit_to_mm, 53, 4);
    EXPECT_LT(
        (fit.fitted.vertices * (53 / fit.verdict.unit_to_mm) - face.truth).rowwise().norm().mean(),
        1.5);
    EXPECT_EQ(fit.verdict.quality, FitQuality::doubtful);
    EXPECT_NE(reasons_of(fit).find("no known unit"), std::string::npos) << reasons_of(fit);
    // Named by the host, nothing is guessed.
    RegistrationSettings settings;
    settings.intake.unit_to_mm = 53;
    fit = register_scan(face.model, scan, landmarks, settings, {});
    EXPECT_EQ(fit.verdict.unit_to_mm, 53);
    EXPECT_EQ(reasons_of(fit).find("no known unit"), std::string::npos) << reasons_of(fit);
}

TEST(LandmarkFrame, AUnitThatTheHostNamesIsTaken) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    scan.vertices /= 304.8;
    RegistrationSettings settings;
    settings.intake.unit_to_mm = 304.8;
    const RegistrationResult fit =
        register_scan(face.model, scan, landmarks_of(face, Similarity()), settings, {});
    EXPECT_EQ(fit.verdict.unit_to_mm, 304.8);
    EXPECT_LT(mean_error_of(fit, face, Similarity()), 1.1);
}

TEST(LandmarkFrame, LandmarksInTheOtherFrameOfSlicerAreTurned) {
    const SmallFace face = small_face();
    const Similarity moved = motion_of(20, Vector3(1, 0, 0), Vector3(80, 120, -40));
    auto landmarks = landmarks_of(face, moved);
    for (LandmarkPoint& landmark : landmarks) landmark.point.head<2>() *= -1;
    const RegistrationResult fit =
        register_scan(face.model, scan_of(face, moved), landmarks, {}, {});
    EXPECT_LT(mean_error_of(fit, face, moved), 1.1);
    ASSERT_EQ(fit.verdict.notes.size(), 1u);
    EXPECT_NE(fit.verdict.notes[0].find("RAS"), std::string::npos);
}

TEST(LandmarkSides, ExchangedNamesAreRefusedAndNamed) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    EXPECT_NE(message_of(face, scan, exchanged(landmarks, 5)).find("exchanged"), std::string::npos);
}

TEST(LandmarkSides, SomeExchangedNamesAreRefusedAndNamed) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const std::string text = message_of(face, scan, exchanged(landmarks_of(face, Similarity()), 2));
    EXPECT_NE(text.find("p0"), std::string::npos) << text;
    EXPECT_NE(text.find("exchanged"), std::string::npos) << text;
}

TEST(LandmarkSides, AreMendedWhenTheHostAsksForIt) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    RegistrationSettings settings;
    settings.start.sides.rule = SideRule::mend;
    const RegistrationResult right = register_scan(face.model, scan, landmarks, settings, {});
    for (const std::size_t count : {std::size_t{2}, std::size_t{5}}) {
        const RegistrationResult fit =
            register_scan(face.model, scan, exchanged(landmarks, count), settings, {});
        EXPECT_LT((fit.fitted.vertices - right.fitted.vertices).rowwise().norm().maxCoeff(), 1e-6);
        ASSERT_EQ(fit.verdict.notes.size(), 1u);
    }
}

TEST(LandmarkSides, AMirroredScanWithItsLandmarksIsRefused) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    auto landmarks = landmarks_of(face, Similarity());
    scan.vertices.col(0) *= -1;
    for (LandmarkPoint& landmark : landmarks) landmark.point[0] *= -1;
    EXPECT_NE(message_of(face, scan, landmarks).find("mirrored"), std::string::npos);
}

TEST(Windings, AnInsideOutScanIsFittedAndSaidToBe) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    turn_over(scan);
    const RegistrationResult fit =
        register_scan(face.model, scan, landmarks_of(face, Similarity()), {}, {});
    EXPECT_LT(mean_error_of(fit, face, Similarity()), 1.1);
    EXPECT_EQ(fit.verdict.quality, FitQuality::doubtful);
    std::string reasons;
    for (const std::string& reason : fit.verdict.reasons) reasons += reason;
    EXPECT_NE(reasons.find("inside out"), std::string::npos) << reasons;
}

TEST(Windings, AStripWoundTheOtherWayCostsNothing) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    TriMesh strip = scan;
    for (Index t = 300; t < 900; ++t) std::swap(strip.triangles(t, 1), strip.triangles(t, 2));
    const auto landmarks = landmarks_of(face, Similarity());
    const RegistrationResult right = register_scan(face.model, scan, landmarks, {}, {});
    const RegistrationResult fit = register_scan(face.model, strip, landmarks, {}, {});
    EXPECT_EQ(fit.fitted.vertices, right.fitted.vertices);
    EXPECT_EQ(fit.verdict.quality, right.verdict.quality);
    EXPECT_GT(fit.verdict.turned_triangles, 500);
    // The correspondence is told in the raw scan's corners.
    for (std::size_t v = 0; v < fit.correspondence.size(); ++v) {
        const SurfaceHit& hit = fit.correspondence[v];
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += hit.barycentric[k] *
                     strip.vertices.row(strip.triangles(static_cast<Index>(hit.triangle), k))
                         .transpose();
        EXPECT_LT((place - hit.point).norm(), 1e-6);
    }
}

TEST(WrongLandmarks, CostNoMoreThanLeavingThemOut) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    for (const std::vector<std::size_t>& wrong :
         {std::vector<std::size_t>{4}, std::vector<std::size_t>{1, 6, 8, 12, 14}}) {
        auto given = landmarks;
        std::vector<LandmarkPoint> left;
        for (std::size_t k = 0; k < landmarks.size(); ++k) {
            if (std::find(wrong.begin(), wrong.end(), k) == wrong.end())
                left.push_back(landmarks[k]);
            else
                given[k].point = Vector3(17.0 * static_cast<double>(k) - 150, -90,
                                         200 - 3.0 * static_cast<double>(k * k));
        }
        const RegistrationResult without = register_scan(face.model, scan, left, {}, {});
        const RegistrationResult with = register_scan(face.model, scan, given, {}, {});
        EXPECT_EQ(with.verdict.landmarks_rejected.size(), wrong.size());
        EXPECT_EQ(with.fitted.vertices, without.fitted.vertices);
    }
}

// Landmarks that were never picked stand at one place, and neighbours among them moved there alike:
// they must not speak for each other.
TEST(WrongLandmarks, NeighboursAtOnePlaceholderDoNotSpeakForEachOther) {
    const SmallFace face = small_face();
    const Similarity motion = motion_of(20, Vector3(1, 2, 0), Vector3(60, -50, 80));
    const TriMesh scan = scan_of(face, motion);
    const auto landmarks = landmarks_of(face, motion);
    auto given = landmarks;
    std::vector<LandmarkPoint> left;
    for (std::size_t k = 0; k < landmarks.size(); ++k)
        if (k < 5)  // a third, all of one cheek
            given[k].point = Vector3(1e-7 * static_cast<double>(k), 0, 0);
        else
            left.push_back(landmarks[k]);
    const RegistrationResult without = register_scan(face.model, scan, left, {}, {});
    const RegistrationResult with = register_scan(face.model, scan, given, {}, {});
    EXPECT_EQ(with.verdict.landmarks_rejected.size(), 5u);
    EXPECT_EQ(with.fitted.vertices, without.fitted.vertices);
}

TEST(WrongLandmarks, PicksAFingersBreadthOffAreFoundToo) {
    const SmallFace face = small_face();
    const TriMesh scan = scan_of(face, Similarity());
    auto landmarks = landmarks_of(face, Similarity());
    landmarks[3].point += Vector3(14, 10, 4);
    landmarks[9].point += Vector3(-12, 8, -11);
    const RegistrationResult fit = register_scan(face.model, scan, landmarks, {}, {});
    EXPECT_EQ(fit.verdict.landmarks_rejected, (std::vector<std::string>{"p9", "p3"}));
}

// In a country's grid, in metres: 5,400 km are 5.4e9 mm, and all arms of levers would be so long.
TEST(FarScan, AGridsCoordinatesCostNothing) {
    const SmallFace face = small_face();
    TriMesh scan = scan_of(face, Similarity());
    const auto landmarks = landmarks_of(face, Similarity());
    const Vector3 grid(350000, 5400000, 120);
    const auto moved = [&](double unit) {
        TriMesh far = scan;
        far.vertices = (scan.vertices / unit).rowwise() + grid.transpose();
        return far;
    };
    for (const double unit : {1.0, 1000.0}) {
        std::vector<LandmarkPoint> picks = landmarks;
        for (LandmarkPoint& pick : picks) pick.point = pick.point / unit + grid;
        for (const auto& given : {std::vector<LandmarkPoint>(), picks}) {
            const RegistrationResult here =
                register_scan(face.model, scan, given.empty() ? given : landmarks, {}, {});
            const RegistrationResult there = register_scan(face.model, moved(unit), given, {}, {});
            EXPECT_EQ(there.verdict.unit_to_mm, unit);
            EXPECT_EQ(there.verdict.quality, here.verdict.quality);
            const Points back = there.fitted.vertices.rowwise() - (unit * grid).transpose();
            EXPECT_LT((back - here.fitted.vertices).rowwise().norm().maxCoeff(), 0.05);
            EXPECT_LT((there.correspondence[0].point - unit * grid).norm(), 300);
            EXPECT_LT((there.motion.translation - unit * grid).norm(), 300);
        }
    }
    // A given pose is told in the scan's coordinates.
    RegistrationSettings settings;
    settings.start.kind = StartKind::pose;
    settings.start.pose.translation = grid;
    const RegistrationResult fit = register_scan(face.model, moved(1), {}, settings, {});
    EXPECT_LT(fit.residual_mm.cwiseAbs().mean(), 0.3);
}

TEST(AnyPose, UpsideDownAndFacingAwayAreFound) {
    const SmallFace face = small_face();
    for (const Similarity& motion : {motion_of(180, Vector3(0, 0, 1), Vector3(10, 20, 30)),
                                     motion_of(180, Vector3(0, 1, 0), Vector3(0, 0, 500)),
                                     motion_of(180, Vector3(1, 0, 0), Vector3(-80, 0, 0)),
                                     motion_of(137, Vector3(1, -2, 0.5), Vector3(0, 300, 0))}) {
        const RegistrationResult fit = register_scan(face.model, scan_of(face, motion), {}, {}, {});
        EXPECT_LT((fit.motion.rotation - motion.rotation).norm(), 0.3);
        EXPECT_LT(fit.residual_mm.cwiseAbs().mean(), 0.3);
    }
}

TEST(AnyPose, ATurnedScanEndsInTheSameFit) {
    const SmallFace face = small_face();
    const RegistrationResult upright =
        register_scan(face.model, scan_of(face, Similarity()), {}, {}, {});
    for (const Similarity& motion : {motion_of(90, Vector3(0, 0, 1), Vector3(10, 20, 30)),
                                     motion_of(180, Vector3(0, 1, 0), Vector3(0, 0, 500)),
                                     motion_of(137, Vector3(1, -2, 0.5), Vector3(0, 300, 0))}) {
        const RegistrationResult fit = register_scan(face.model, scan_of(face, motion), {}, {}, {});
        EXPECT_NEAR(fit.verdict.search_score, upright.verdict.search_score, 1e-6);
        EXPECT_LT((fit.fitted.vertices - motion.apply(PointsRef(upright.fitted.vertices)))
                      .rowwise()
                      .norm()
                      .maxCoeff(),
                  0.05);
    }
}

TEST(AnyPose, NothingThatLooksLikeAFaceFails) {
    const SmallFace face = small_face();
    TriMesh flat = face_sheet(30);
    flat.vertices.col(2).setZero();
    const RegistrationResult fit = register_scan(face.model, flat, {}, {}, {});
    EXPECT_EQ(fit.verdict.quality, FitQuality::failed) << registration_json(fit);
}

}  // namespace
}  // namespace mien
