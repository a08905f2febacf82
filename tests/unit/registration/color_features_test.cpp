#include "registration/color_features.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <functional>

#include "geometry/normals.hpp"
#include "registration/shut_lids.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

constexpr int kSkin[3] = {205, 158, 130}, kLip[3] = {190, 96, 90}, kHair[3] = {60, 42, 30};
using Paint = std::function<const int*(double x, double y)>;

// A gently curved plate of 120 x 120 mm, a vertex every 2 mm.
TriMesh plate() {
    TriMesh mesh = face_sheet(60);
    for (Index i = 0; i < mesh.vertices.rows(); ++i) {
        mesh.vertices(i, 0) *= 60.0 / 70;
        mesh.vertices(i, 1) *= 60.0 / 90;
        mesh.vertices(i, 2) = -0.002 * mesh.vertices.row(i).head<2>().squaredNorm();
    }
    return mesh;
}

bool is_brow(double x, double y) {
    return std::abs(y - 40) < 3.5 && std::abs(std::abs(x) - 30) < 20;
}
bool is_lip(double x, double y) {
    return x * x / 625 + (y + 30) * (y + 30) / 81 < 1;
}
const int* face_paint(double x, double y) {
    return is_brow(x, y) ? kHair : is_lip(x, y) ? kLip : kSkin;
}

struct PaintedFace {
    DeformationModel model;
    std::vector<std::uint8_t> inner;
    Points normals;
};

PaintedFace painted_face() {
    PaintedFace face;
    face.model.template_mesh = plate();
    const Points& v = face.model.template_mesh.vertices;
    const auto add = [&](const std::string& name, double x, double y) {
        Index nearest;
        ((v.col(0).array() - x).square() + (v.col(1).array() - y).square()).minCoeff(&nearest);
        face.model.landmarks.push_back({name, static_cast<std::uint32_t>(nearest)});
    };
    for (int k = 0; k < 5; ++k) {
        add("brow_right_" + std::to_string(k), -48 + 9 * k, 40);
        add("brow_left_" + std::to_string(k), 12 + 9 * k, 40);
    }
    for (int k = 0; k < 12; ++k) {
        const double turn = 3.14159265358979 * (1 - k / 6.0);
        add("mouth_outer_" + std::string(k < 10 ? "0" : "") + std::to_string(k),
            25 * std::cos(turn), -30 + 9 * std::sin(turn));
    }
    for (const double side : {-1.0, 1.0}) {
        const std::string name = side < 0 ? "eye_right_" : "eye_left_";
        const double x[6] = {-14, -6, 6, 14, 6, -6}, y[6] = {15, 20, 20, 15, 10, 10};
        for (int k = 0; k < 6; ++k) add(name + std::to_string(k), side * 30 + x[k], y[k]);
    }
    face.inner.assign(static_cast<std::size_t>(v.rows()), 0);
    face.normals = vertex_normals(v, face.model.template_mesh.triangles);
    return face;
}

Colors painted(const Points& places, const Paint& paint) {
    Colors colors(places.rows(), 3);
    for (Index i = 0; i < places.rows(); ++i) {
        const int* color = paint(places(i, 0), places(i, 1));
        for (int c = 0; c < 3; ++c) colors(i, c) = static_cast<std::uint8_t>(color[c]);
    }
    return colors;
}

struct Sight {
    ScanSurface scan;
    ColorFeatures colors;
    Sight(const PaintedFace& face, const Paint& paint, const Similarity& motion = {}) {
        TriMesh mesh = plate();
        const Colors seen = painted(mesh.vertices, paint);
        mesh.vertices = motion.apply(PointsRef(mesh.vertices));
        scan = build_scan_surface(mesh, {}, {});
        scan.colors = color_signals(seen, {});
        colors = ColorFeatures(face.model, face.inner, {}, {});
    }
    std::vector<ColorAgreement> agreements(const Points& places, const Points& normals) const {
        return colors.agreements(scan, places, normals, {}, {});
    }
};

std::vector<ColorPull> pulls_of(const Sight& sight, const Points& places, const Points& normals,
                                double blur_mm) {
    std::vector<Correspondences> matches;
    return sight.colors.pulls(sight.scan, places, normals, {}, blur_mm, matches, {});
}

// The shift in the plate that the pulls ask for together.
Eigen::Vector2d shift_of(const std::vector<ColorPull>& pulls) {
    Eigen::Matrix2d a = 1e-9 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (const ColorPull& pull : pulls) {
        const Eigen::Vector2d gradient = pull.gradient.head<2>();
        a += pull.weight * gradient * gradient.transpose();
        b += pull.weight * pull.difference * gradient;
    }
    return a.ldlt().solve(b);
}

TEST(ColorFeatures, PullTowardsWhereTheFeaturesAre) {
    const PaintedFace face = painted_face();
    const Points& rest = face.model.template_mesh.vertices;
    for (const Vector3& shift : {Vector3(0, 3, 0), Vector3(0, -3, 0), Vector3(1.5, 1, 0)}) {
        const Sight sight(
            face, [&](double x, double y) { return face_paint(x - shift[0], y - shift[1]); });
        const Eigen::Vector2d found = shift_of(pulls_of(sight, rest, face.normals, 1.5));
        EXPECT_LT((found - shift.head<2>()).norm(), 0.35 * shift.norm()) << found.transpose();
    }
}

TEST(ColorFeatures, ABlurredLookFeelsFromAfar) {
    const PaintedFace face = painted_face();
    const Sight sight(face, [&](double x, double y) { return face_paint(x, y - 9); });
    EXPECT_GT(shift_of(pulls_of(sight, face.model.template_mesh.vertices, face.normals, 8))[1], 2);
}

TEST(ColorFeatures, InPlaceDoNotPullAndAgree) {
    const PaintedFace face = painted_face();
    const Sight sight(face, face_paint);
    const Points& rest = face.model.template_mesh.vertices;
    EXPECT_LT(shift_of(pulls_of(sight, rest, face.normals, 1.5)).norm(),
              0.4);  // brows painted as boxes
    const std::vector<ColorAgreement> agreements = sight.agreements(rest, face.normals);
    ASSERT_EQ(agreements.size(), 3u);
    for (const ColorAgreement& feature : agreements) {
        ASSERT_GE(feature.centre, 0);
        EXPECT_EQ(feature.name == "lips", rest(feature.centre, 1) < 0);
    }
    for (const ColorAgreement& feature : agreements)
        EXPECT_GT(feature.correlation, 0.8) << feature.name;
}

TEST(ColorFeatures, TurnWithTheScan) {
    const PaintedFace face = painted_face();
    const Similarity motion = motion_of(50, Vector3(1, 2, 3), Vector3(100, -50, 20));
    const Paint paint = [](double x, double y) { return face_paint(x, y - 2); };
    const Sight here(face, paint), there(face, paint, motion);
    const Points& rest = face.model.template_mesh.vertices;
    const Points moved = motion.apply(PointsRef(rest)),
                 turned = face.normals * motion.rotation.transpose();
    const auto a = pulls_of(here, rest, face.normals, 2), b = pulls_of(there, moved, turned, 2);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_LT((motion.rotation * a[k].gradient - b[k].gradient).norm(), 1e-6);
        EXPECT_NEAR(a[k].difference, b[k].difference, 1e-6);
        EXPECT_NEAR(a[k].weight, b[k].weight, 1e-6 * a[k].weight);
    }
}

TEST(ColorFeatures, SayNothingOfAPlainScanNorOfFeaturesElsewhere) {
    const PaintedFace face = painted_face();
    const Points& rest = face.model.template_mesh.vertices;
    const Sight plain(face, [](double, double) { return kSkin; });
    EXPECT_TRUE(pulls_of(plain, rest, face.normals, 2).empty());
    for (const ColorAgreement& feature : plain.agreements(rest, face.normals))
        EXPECT_EQ(feature.correlation, 0);
    const Sight upside_down(face, [](double x, double y) {
        return std::abs(y - 40) > 6 && y > 20 ? kHair : is_lip(x, y + 18) ? kLip : kSkin;
    });
    EXPECT_TRUE(pulls_of(upside_down, rest, face.normals, 2).empty());
}

TEST(ColorFeatures, NeedColorsAndNames) {
    PaintedFace face = painted_face();
    const Points& rest = face.model.template_mesh.vertices;
    Sight bare(face, face_paint);
    bare.scan.colors.resize(0, 2);
    EXPECT_TRUE(pulls_of(bare, rest, face.normals, 2).empty());
    EXPECT_TRUE(bare.agreements(rest, face.normals).empty());
    face.model.landmarks.resize(9);  // one brow left
    EXPECT_LE(Sight(face, face_paint).agreements(rest, face.normals).size(), 1u);
    face.model.landmarks.clear();
    EXPECT_TRUE(ColorFeatures(face.model, face.inner, {}, {}).empty());
    ColorFeatureSettings off;
    off.enabled = false;
    EXPECT_TRUE(ColorFeatures(painted_face().model, face.inner, off, {}).empty());
}

TEST(ColorFeatures, TheZoneOfTheLipsOutranksTheLandmarks) {
    PaintedFace face = painted_face();
    const Points& rest = face.model.template_mesh.vertices;
    Zone lips{"lips", {}};
    for (Index i = 0; i < rest.rows(); ++i)
        if (is_lip(rest(i, 0), rest(i, 1) - 4))
            lips.vertices.push_back(static_cast<std::uint32_t>(i));
    face.model.zones.push_back(lips);
    const Sight sight(face, [](double x, double y) { return is_lip(x, y - 4) ? kLip : kSkin; });
    EXPECT_LT(shift_of(pulls_of(sight, rest, face.normals, 1.5)).norm(), 0.1);
}

TEST(ShutLids, AreSeenByTheirColor) {
    const PaintedFace face = painted_face();
    FitState state;
    state.places = face.model.template_mesh.vertices;
    // The right eye is open: white, brown and black.
    static const int kWhite[3] = {232, 226, 220}, kBlack[3] = {15, 15, 15};
    Sight sight(face, [](double x, double y) -> const int* {
        if (std::abs(x + 30) < 14 && std::abs(y - 15) < 5)
            return std::abs(x + 30) < 4 ? kBlack : kWhite;
        return face_paint(x, y);
    });
    const std::vector<Pin> pins = shut_lids(face.model, sight.scan, state, 1.5, {}, {});
    sight.scan.colors.resize(0, 2);
    EXPECT_TRUE(shut_lids(face.model, sight.scan, state, 1.5, {}, {}).empty())
        << "no colours, no opinion";
    ASSERT_EQ(pins.size(), 6u);
    for (const Pin& pin : pins) {
        const Vector3 place = state.places.row(pin.vertex).transpose();
        EXPECT_GT(place[0], 0) << "of the left eye";
        EXPECT_LT(pin.place[1], 16);
        EXPECT_LT((pin.place - place).norm(), place[1] > 16 ? 12 : 1e-9);
    }
}

// Make-up and redrawn brows once led fits that were called good.
TEST(ColorFeatures, NameWhatTheScanShowsElsewhere) {
    const PaintedFace face = painted_face();
    const Points& rest = face.model.template_mesh.vertices;
    const Paint redrawn = [](double x, double y) {
        return is_brow(x, y - 9) ? kHair : is_lip(x, y) ? kLip : kSkin;
    };
    const Sight honest(face, face_paint), lying(face, redrawn);
    EXPECT_TRUE(honest.colors.lying(honest.agreements(rest, face.normals)).empty());
    const std::vector<std::string> names = lying.colors.lying(lying.agreements(rest, face.normals));
    EXPECT_EQ(names, (std::vector<std::string>{"brow_right", "brow_left"}));
    const ColorFeatures others = lying.colors.without(names);
    const std::vector<ColorAgreement> left =
        others.agreements(lying.scan, rest, face.normals, {}, {});
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].name, "lips");
}

// A grey scan once shut the eyes: its eyeballs look like the skin beside them.
TEST(ColorFeatures, TrustNothingOnAScanOfOneColour) {
    const PaintedFace face = painted_face();
    const Sight grey(face, [](double, double) { return kSkin; });
    for (const ColorAgreement& feature :
         grey.agreements(face.model.template_mesh.vertices, face.normals))
        EXPECT_EQ(feature.trust, 0) << feature.name;
}

}  // namespace
}  // namespace mien
