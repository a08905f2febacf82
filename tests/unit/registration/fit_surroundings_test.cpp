#include <gtest/gtest.h>

#include <algorithm>

#include "registration/registration.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

// A symmetric face with zones: the whole, a cheek, and the forehead.
SmallFace zoned_face() {
    SmallFace face = small_face();
    const Points& rest = face.model.template_mesh.vertices;
    face.truth = rest;
    Zone whole{"face", {}}, cheek{"cheek", {}}, forehead{"forehead", {}};
    for (Index i = 0; i < rest.rows(); ++i) {
        const auto v = static_cast<std::uint32_t>(i);
        whole.vertices.push_back(v);
        if (rest(i, 0) > 20 && rest(i, 1) < 0 && rest(i, 1) > -50) cheek.vertices.push_back(v);
        if (rest(i, 1) > 50) forehead.vertices.push_back(v);
    }
    face.model.zones = {cheek, whole, forehead};
    return face;
}

std::vector<ZoneMeasures> zones_of(const SmallFace& face, std::vector<LandmarkPoint> landmarks,
                                   const Similarity& motion = {}) {
    return register_scan(face.model, scan_of(face, motion), landmarks, {}, {}).verdict.zones;
}

const ZoneMeasures& zone(const std::vector<ZoneMeasures>& zones, const std::string& name) {
    return *std::find_if(zones.begin(), zones.end(),
                         [&](const ZoneMeasures& z) { return z.name == name; });
}

TEST(FitSurroundings, AHillOnOneSideIsAsymmetric) {
    const Similarity motion = motion_of(25, Vector3(1, 2, 0.5), Vector3(40, -10, 300));
    SmallFace face = zoned_face();
    const ZoneMeasures even = zone(zones_of(face, landmarks_of(face, motion), motion), "cheek");
    for (Index i = 0; i < face.truth.rows(); ++i)
        face.truth(i, 2) += 6 * gauss(face.truth(i, 0) - 40, 14) * gauss(face.truth(i, 1) + 25, 14);
    const auto zones = zones_of(face, landmarks_of(face, motion), motion);
    EXPECT_LT(even.asymmetry_mm, 0.3);
    EXPECT_GT(zone(zones, "cheek").asymmetry_mm, 1.5);
    EXPECT_LT(zone(zones, "forehead").asymmetry_mm, 0.7);
    EXPECT_GT(zone(zones, "cheek").shape_deviation, even.shape_deviation);
}

TEST(FitSurroundings, LandmarksElsewhereAreFar) {
    const SmallFace face = zoned_face();
    std::vector<LandmarkPoint> landmarks = landmarks_of(face, {});
    const auto near = zones_of(face, landmarks);
    landmarks.erase(std::remove_if(landmarks.begin(), landmarks.end(),
                                   [](const LandmarkPoint& l) { return l.point[1] > 0; }),
                    landmarks.end());
    const auto far = zones_of(face, landmarks);
    EXPECT_GT(zone(far, "forehead").pin_far_mm, zone(near, "forehead").pin_far_mm + 30);
    EXPECT_NEAR(zone(far, "cheek").pin_far_mm, zone(near, "cheek").pin_far_mm, 10);
    EXPECT_EQ(zone(far, "forehead").landmarks, 0);
}

TEST(FitSurroundings, AMisplacedLandmarkIsFeltAround) {
    const SmallFace face = zoned_face();
    std::vector<LandmarkPoint> landmarks = landmarks_of(face, {});
    const auto right = zones_of(face, landmarks);
    const auto at =
        std::min_element(landmarks.begin(), landmarks.end(), [](const auto& a, const auto& b) {
            const Vector3 cheek(40, -25, 45);
            return (a.point - cheek).norm() < (b.point - cheek).norm();
        });
    at->point += Vector3(0, 5, 0);
    const auto wrong = zones_of(face, landmarks);
    EXPECT_GT(zone(wrong, "cheek").pin_misfit_mm, zone(right, "cheek").pin_misfit_mm + 1);
    EXPECT_LT(zone(wrong, "forehead").pin_misfit_mm, zone(right, "forehead").pin_misfit_mm + 0.7);
}

// A template that is no mirror image of itself is as good as any other.
TEST(FitSurroundings, WithoutAMirrorImageThereIsNoAsymmetry) {
    SmallFace face = zoned_face();
    Points& rest = face.model.template_mesh.vertices;
    for (Index i = 0; i < rest.rows(); ++i)
        if (rest(i, 0) > 0) rest(i, 0) += 30 * (rest(i, 0) / 70);
    face.truth = rest;
    for (const ZoneMeasures& z : zones_of(face, landmarks_of(face, {})))
        EXPECT_EQ(z.asymmetry_mm, 0);
}

}  // namespace
}  // namespace mien
