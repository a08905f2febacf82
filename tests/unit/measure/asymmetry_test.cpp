#include "measure/asymmetry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>

#include "measure/area.hpp"
#include "measure/random.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

/// An ellipsoid in the place of a head: symmetric about x = 0 as the icosphere is.
struct Head {
    TriMesh face = test::sphere(1, 4);
    MirrorMap map;
    Head() {
        face.vertices.col(0) *= 75;
        face.vertices.col(1) *= 110;
        face.vertices.col(2) *= 95;
        std::vector<std::uint32_t> partner(static_cast<std::size_t>(face.vertices.rows()));
        for (Index v = 0; v < face.vertices.rows(); ++v) {
            const Eigen::RowVector3d image(-face.vertices(v, 0), face.vertices(v, 1),
                                           face.vertices(v, 2));
            Index best = 0;
            (face.vertices.rowwise() - image).rowwise().squaredNorm().minCoeff(&best);
            partner[static_cast<std::size_t>(v)] = static_cast<std::uint32_t>(best);
        }
        map = mirror_sides(partner, face.vertices);
    }
    /// A hill of so many mm outwards, a Gaussian of `width` mm about a place.
    void add_hill(const Vector3& centre, double height, double width) {
        const Points before = face.vertices;
        for (Index v = 0; v < before.rows(); ++v) {
            const Vector3 x = before.row(v).transpose();
            const double d = (x - centre).norm();
            face.vertices.row(v) +=
                height * std::exp(-d * d / (2 * width * width)) * x.normalized().transpose();
        }
    }
    std::vector<std::uint32_t> within(const Vector3& centre, double radius) const {
        std::vector<std::uint32_t> inside;
        for (Index v = 0; v < face.vertices.rows(); ++v)
            if ((face.vertices.row(v).transpose() - centre).norm() < radius)
                inside.push_back(static_cast<std::uint32_t>(v));
        return inside;
    }
};

const Vector3 kLeftCheek(52, -20, 60), kRightCheek(-52, -20, 60);

TEST(MirrorPlane, OfASymmetricFaceIsItsOwnWhateverThePose) {
    Head head;
    Similarity pose;
    pose.rotation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    pose.translation = Vector3(300, 20, -800);
    head.face.vertices = pose.apply(head.face.vertices);
    const MirrorPlane plane = find_mirror_plane(head.face.vertices, head.map,
                                                Vector::Ones(head.face.vertices.rows()), {});
    EXPECT_NEAR((plane.normal - pose.rotation.col(0)).norm(), 0, 1e-9);
    EXPECT_NEAR(plane.offset_mm(), plane.normal.dot(pose.translation), 1e-6);
    EXPECT_LT(plane.rms_mm, 1e-6);
}

TEST(MirrorPlane, IsNotTurnedByASwollenCheek) {
    Head head;
    head.add_hill(kLeftCheek, 12, 15);
    const MirrorPlane plane = find_mirror_plane(head.face.vertices, head.map,
                                                Vector::Ones(head.face.vertices.rows()), {});
    EXPECT_LT(std::acos(std::min(1.0, plane.normal.x())), 0.001);
    EXPECT_NEAR(plane.offset_mm(), 0, 0.02);
}

/// Squares of tilt and offset, stated and true, over faces whose errors go together over a length,
/// in any direction: errors away from the head's middle alone would not turn the plane.
struct PlaneErrors {
    double tilts = 0, offsets = 0, stated_tilts = 0, stated_offsets = 0;
};
PlaneErrors errors_of_planes(double length_mm, const MirrorPlaneSettings& settings) {
    PlaneErrors errors;
    constexpr int kFaces = 30;
    for (int k = 0; k < kFaces; ++k) {
        Head head;
        SplitMix chance(100 + static_cast<std::uint64_t>(k));
        for (int hill = 0; hill < 300; ++hill) {
            const auto v = static_cast<Index>(
                chance.below(static_cast<std::size_t>(head.face.vertices.rows())));
            const Vector3 centre = head.face.vertices.row(v).transpose(),
                          way = 0.3 * Vector3(chance.normal(), chance.normal(), chance.normal());
            for (Index i = 0; i < head.face.vertices.rows(); ++i) {
                const double d2 = (head.face.vertices.row(i).transpose() - centre).squaredNorm();
                head.face.vertices.row(i) +=
                    std::exp(-d2 / (length_mm * length_mm)) * way.transpose();
            }
        }
        const MirrorPlane plane =
            find_mirror_plane(head.face.vertices, head.map,
                              vertex_areas(head.face.vertices, head.face.triangles), settings);
        errors.tilts += plane.normal.tail<2>().squaredNorm() / 2;
        errors.offsets += plane.normal.dot(plane.centre) * plane.normal.dot(plane.centre);
        errors.stated_tilts += plane.tilt_sd_rad() * plane.tilt_sd_rad();
        errors.stated_offsets += plane.offset_sd_mm() * plane.offset_sd_mm();
    }
    return errors;
}

TEST(MirrorPlane, DeviationsHoldTheTruth) {
    MirrorPlaneSettings settings;
    settings.correlation_length_mm = 12;
    const PlaneErrors errors = errors_of_planes(12, settings);
    EXPECT_GT(errors.stated_tilts / errors.tilts, 0.5);
    EXPECT_LT(errors.stated_tilts / errors.tilts, 4.0);
    EXPECT_GT(errors.stated_offsets / errors.offsets, 0.5);
    EXPECT_LT(errors.stated_offsets / errors.offsets, 4.0);
}

TEST(MirrorPlane, DefaultDeviationsHoldTemplatesThatSlideByWideStretches) {
    const PlaneErrors errors = errors_of_planes(30, {});
    EXPECT_GT(errors.stated_tilts / errors.tilts, 0.7);
    EXPECT_GT(errors.stated_offsets / errors.offsets, 0.7);
}

TEST(MirrorPlane, PairsThatGoTogetherCountAsOne) {
    Head head;
    head.add_hill(kLeftCheek, 4, 10);
    MirrorPlaneSettings settings;
    settings.correlation_length_mm = 0;
    const Vector areas = vertex_areas(head.face.vertices, head.face.triangles);
    const MirrorPlane each = find_mirror_plane(head.face.vertices, head.map, areas, settings);
    settings.pairs_together = 9;
    const MirrorPlane together = find_mirror_plane(head.face.vertices, head.map, areas, settings);
    EXPECT_NEAR(together.tilt_sd_rad(), 3 * each.tilt_sd_rad(), 1e-9);
    EXPECT_NEAR(together.offset_sd_mm(), 3 * each.offset_sd_mm(), 1e-9);
    settings.pairs_together = 0.5;
    EXPECT_EQ(test::status_of(
                  [&] { (void)find_mirror_plane(head.face.vertices, head.map, areas, settings); }),
              Status::invalid_argument);
}

TEST(MirrorPlane, RefusesMapsAndPairsThatGiveNone) {
    Head head;
    const Vector ones = Vector::Ones(head.face.vertices.rows());
    const auto status = [&](const MirrorMap& map, const Vector& weights) {
        return test::status_of(
            [&] { (void)find_mirror_plane(head.face.vertices, map, weights, {}); });
    };
    MirrorMap broken = head.map;
    broken.partner[0] = broken.partner[1];
    EXPECT_EQ(status(broken, ones), Status::invalid_argument);
    EXPECT_EQ(status(head.map, Vector::Ones(3)), Status::mismatch);
    EXPECT_EQ(status(head.map, Vector::Zero(ones.size())), Status::no_solution);
}

TEST(Asymmetry, HillOnOneSideIsItsVolumeAndTheOtherSideReadsTheOpposite) {
    for (const double sign : {1.0, -1.0}) {
        Head head;
        const Points before = head.face.vertices;
        head.add_hill(sign > 0 ? kLeftCheek : kRightCheek, 4, 10);
        const double grown = measure_volume(before, head.face.vertices, head.face.triangles, {}, {})
                                 .whole.volume.signed_ml;
        AsymmetryOptions options;
        options.zones = {{"cheek_left", head.within(kLeftCheek, 45)},
                         {"cheek_right", head.within(kRightCheek, 45)},
                         {"nose", head.within(Vector3(0, 0, 95), 12)}};
        const Asymmetry result = measure_asymmetry(head.face, head.map, options, {});
        const VolumeReport& volume = *result.measurement.volume;
        ASSERT_EQ(volume.zones.size(), 2u);
        EXPECT_EQ(volume.zones[0].name, "cheek");
        EXPECT_NEAR(volume.zones[0].volume.signed_ml, sign * grown, 0.02 * grown);
        EXPECT_NEAR(volume.zones[1].volume.signed_ml, 0, 0.01);
        EXPECT_NEAR(volume.whole.volume.signed_ml, sign * grown, 0.03 * grown);
        EXPECT_GT(sign * result.measurement.distance->zones[0].mean_signed_mm, 0.3);
        // The field of either side is the other's with the other sign, and greatest at the hill.
        const Vector& field = result.measurement.distance->signed_mm;
        const auto top = head.within(kLeftCheek, 15).front();
        EXPECT_GT(sign * field[top], 0.5);
        EXPECT_LT(sign * field[head.map.partner[top]], -0.5);
    }
}

TEST(Asymmetry, IntervalCountsBothSidesErrorsAndThePlanes) {
    Head head;
    head.add_hill(kLeftCheek, 4, 10);
    AsymmetryOptions options;
    options.zones = {{"cheek_left", head.within(kLeftCheek, 45)}};
    const Asymmetry none = measure_asymmetry(head.face, head.map, options, {});
    EXPECT_TRUE(std::isnan(none.measurement.zone_verdicts[0].uncertainty.sd_ml));
    options.normal_sd_mm = Vector::Constant(head.face.vertices.rows(), 0.2);
    const Asymmetry alike = measure_asymmetry(head.face, head.map, options, {});
    const VolumeUncertainty both = alike.measurement.zone_verdicts[0].uncertainty;
    EXPECT_GT(both.noise_ml, 0.01);
    EXPECT_GT(both.alignment_ml, 0);
    // Errors of the right side alone are half of the variance.
    for (Index v = 0; v < options.normal_sd_mm.size(); ++v)
        if (head.map.side[static_cast<std::size_t>(v)] >= 0) options.normal_sd_mm[v] = 0;
    const Asymmetry right = measure_asymmetry(head.face, head.map, options, {});
    EXPECT_NEAR(right.measurement.zone_verdicts[0].uncertainty.noise_ml,
                both.noise_ml / std::sqrt(2.0), 0.02 * both.noise_ml);
}

TEST(Asymmetry, PlaneByLandmarksStandsBesideTheSurfaces) {
    Head head;
    head.add_hill(kLeftCheek, 4, 10);
    AsymmetryOptions options;
    options.landmarks = {head.within(Vector3(30, 40, 70), 25).front(),
                         head.within(Vector3(25, -60, 65), 25).front(),
                         head.within(Vector3(60, 30, 40), 25).front()};
    options.by = MirrorBy::landmarks;
    const Asymmetry result = measure_asymmetry(head.face, head.map, options, {});
    ASSERT_TRUE(result.planes.other.has_value());
    EXPECT_EQ(result.planes.used.pairs, 3);
    EXPECT_LT(result.planes.between_rad, 0.02);
    options.landmarks.clear();
    EXPECT_EQ(test::status_of([&] { (void)measure_asymmetry(head.face, head.map, options, {}); }),
              Status::invalid_argument);
}

TEST(Asymmetry, ZonesLoseTheirSideAndOnlyThat) {
    Head head;
    const std::uint32_t left = head.within(kLeftCheek, 30).front(), right = head.map.partner[left];
    const auto zones = compared_zones({{"Left cheek", {left}},
                                       {"cheek-right", {right}},
                                       {"leftover", {right}},
                                       {"left", {left, right}}},
                                      head.map);
    ASSERT_EQ(zones.size(), 3u);
    EXPECT_EQ(zones[0].name, "cheek");
    EXPECT_EQ(zones[0].vertices, std::vector<std::uint32_t>{left});
    EXPECT_EQ(zones[1].name, "leftover");
    EXPECT_EQ(zones[1].vertices, std::vector<std::uint32_t>{left});
    EXPECT_EQ(zones[2].name, "left");
    EXPECT_EQ(zones[2].vertices, std::vector<std::uint32_t>{left});
}

}  // namespace
}  // namespace mien
