#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>

#include "base/thread_pool.hpp"
#include "geometry/curvature.hpp"
#include "geometry/rigid_zone.hpp"
#include "measure/random.hpp"
#include "measure/scan_volume.hpp"
#include "shapes.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Curvature, OfASphereIsOneOverItsRadius) {
    const TriMesh mesh = test::sphere(40, 4);
    CurvatureOptions options;
    options.radius_mm = 9;
    const CurvatureField field = estimate_curvature(mesh.vertices, mesh.triangles, options, {});
    EXPECT_LT((field.maximal.array() - 1 / 40.0).abs().maxCoeff(), 4e-4);
    EXPECT_LT((field.minimal.array() - 1 / 40.0).abs().maxCoeff(), 4e-4);
    EXPECT_LT((field.gaussian.array() - 1 / 1600.0).abs().maxCoeff(), 2e-5);
}

TEST(Curvature, OfACylinderAndASaddleHaveTheirPrincipalDirections) {
    TriMesh mesh = test::grid(60, 60, 60, 60);
    for (Index v = 0; v < mesh.vertices.rows();
         ++v) {  // z = -x^2 / (2 R) + y^2 / (2 S) near the middle
        const double x = mesh.vertices(v, 0) - 30, y = mesh.vertices(v, 1) - 30;
        mesh.vertices(v, 2) = -x * x / (2 * 50.0) + y * y / (2 * 80.0);
    }
    const CurvatureField field = estimate_curvature(mesh.vertices, mesh.triangles, {}, {});
    const Index middle = 30 * 61 + 30;
    EXPECT_NEAR(field.maximal[middle], 1 / 50.0, 1e-6);
    EXPECT_NEAR(field.minimal[middle], -1 / 80.0, 1e-6);
    EXPECT_NEAR(std::fabs(field.direction(middle, 0)), 1.0, 1e-6);
}

TEST(Curvature, IsLittleChangedByNoiseAndSpikes) {
    TriMesh mesh = test::sphere(40, 5);
    SplitMix random(3);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const double spike = random.uniform() < 0.02 ? 1.5 : 0.0;
        mesh.vertices.row(v) *= 1 + (0.05 * random.normal() + spike) / 40;
    }
    CurvatureOptions options;
    options.radius_mm = 8;
    auto mean_error = [&](bool robust) {
        options.robust = robust;
        const CurvatureField field = estimate_curvature(mesh.vertices, mesh.triangles, options, {});
        return (field.mean.array() - 1 / 40.0).abs().mean();
    };
    const double robust = mean_error(true), plain = mean_error(false);
    EXPECT_LT(robust, 0.2 / 40);
    EXPECT_LT(robust, 0.6 * plain);
}

TEST(Curvature, ScalesWithTheUnitAndIgnoresMotion) {
    TriMesh mesh = test::grid(40, 40, 40, 40);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        mesh.vertices(v, 2) =
            2 * std::sin(0.2 * mesh.vertices(v, 0)) * std::cos(0.15 * mesh.vertices(v, 1));
    CurvatureOptions once;
    once.radius_mm = 6.3;  // no grid point lies on the limit
    const CurvatureField here = estimate_curvature(mesh.vertices, mesh.triangles, once, {});
    Similarity motion;
    motion.scale = 2;
    motion.rotation = Eigen::AngleAxisd(0.8, Vector3(3, -1, 2).normalized()).toRotationMatrix();
    motion.translation = Vector3(100, 20, -3);
    CurvatureOptions twice;
    twice.radius_mm = 12.6;
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const Points moved = motion.apply(PointsRef(mesh.vertices));
    const CurvatureField there = estimate_curvature(moved, mesh.triangles, twice, context);
    EXPECT_LT((2 * there.maximal - here.maximal).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_TRUE(estimate_curvature(moved, mesh.triangles, twice, {}).minimal == there.minimal);
}

TEST(Curvature, OfDegenerateMeshesIsFinite) {
    TriMesh mesh = test::grid(10, 10, 5, 5);
    mesh.vertices.col(1).setZero();  // all on a line
    EXPECT_TRUE(estimate_curvature(mesh.vertices, mesh.triangles, {}, {}).maximal.allFinite());
    mesh.triangles.resize(0, 3);
    EXPECT_EQ(estimate_curvature(mesh.vertices, mesh.triangles, {}, {}).maximal.norm(), 0.0);
    CurvatureOptions wrong;
    wrong.radius_mm = 0;
    EXPECT_EQ(
        test::status_of([&] { estimate_curvature(mesh.vertices, mesh.triangles, wrong, {}); }),
        Status::invalid_argument);
}

Similarity known_motion() {
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.3, Vector3(1, 2, -1).normalized()).toRotationMatrix();
    motion.translation = Vector3(5, -12, 30);
    return motion;
}

double largest_difference(const Similarity& a, const Similarity& b, const Points& points) {
    return (a.apply(points) - b.apply(points)).rowwise().norm().maxCoeff();
}

// An ellipsoid, so that a rotation cannot hide in symmetry.
TriMesh ellipsoid(int subdivisions) {
    TriMesh mesh = test::sphere(1, subdivisions);
    mesh.vertices.col(0) *= 60;
    mesh.vertices.col(1) *= 90;
    mesh.vertices.col(2) *= 75;
    return mesh;
}

TEST(RigidZone, FindsTheMotionOfTheStableZoneAlthoughTheRestChanged) {
    const TriMesh mesh = ellipsoid(4);
    std::vector<std::uint32_t> zone;
    Points changed = mesh.vertices;
    for (Index v = 0; v < changed.rows(); ++v) {
        if (mesh.vertices(v, 1) > 20) zone.push_back(static_cast<std::uint32_t>(v));
        if (mesh.vertices(v, 1) < 20 || v % 17 == 0)
            changed.row(v) *= 1.05;  // also 6 % of the zone
    }
    const Similarity motion = known_motion();
    const Points source = motion.inverse().apply(PointsRef(changed));
    const RigidZoneResult result = align_on_zone(source, mesh.vertices, mesh.triangles, zone, {});
    EXPECT_LT(largest_difference(result.motion, motion, source), 1e-6);
}

TEST(RigidZone, CovarianceMatchesTheSpreadOfRepeatedAlignments) {
    const TriMesh mesh = ellipsoid(4);
    std::vector<std::uint32_t> zone;
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        if (mesh.vertices(v, 1) > 30) zone.push_back(static_cast<std::uint32_t>(v));
    RigidZoneOptions options;
    options.correlation_length_mm = 0;  // independent noise
    options.tangential = 1;
    SplitMix random(9);
    double spread = 0, predicted = 0;
    const int rounds = 100;
    for (int r = 0; r < rounds; ++r) {
        Points noisy = mesh.vertices;
        for (Index v = 0; v < noisy.rows(); ++v)
            for (int k = 0; k < 3; ++k) noisy(v, k) += 0.3 * random.normal();
        const RigidZoneResult a =
            align_on_zone(noisy, mesh.vertices, mesh.triangles, zone, options);
        const Vector3 shift = a.motion.apply(a.centre) - a.centre;
        spread += shift.squaredNorm() / rounds;
        predicted += a.covariance.diagonal().tail<3>().sum() / rounds;
    }
    EXPECT_NEAR(std::sqrt(predicted / spread), 1.0, 0.2);
}

TEST(RigidZone, RefusesZonesThatFixNothing) {
    const TriMesh mesh = ellipsoid(3);
    EXPECT_EQ(test::status_of([&] {
                  align_on_zone(mesh.vertices, mesh.vertices, mesh.triangles, {1, 2, 3}, {});
              }),
              Status::no_solution);
    EXPECT_EQ(test::status_of([&] {
                  align_on_zone(mesh.vertices, mesh.vertices, mesh.triangles, {100000}, {});
              }),
              Status::mismatch);
    Points line = Points::Zero(mesh.vertices.rows(), 3);
    line.col(0) = mesh.vertices.col(0);
    EXPECT_EQ(test::status_of([&] { align_on_zone(line, line, mesh.triangles, {}, {}); }),
              Status::no_solution);
}

TEST(FitAlignment, ASlideOfTheFitOverTheZoneDoesNotTiltTheFace) {
    TriMesh mesh = ellipsoid(5);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)  // a nose
        if (mesh.vertices(v, 2) > 0)
            mesh.vertices(v, 2) +=
                25 * std::exp(-mesh.vertices.row(v).head<2>().squaredNorm() / 400);
    std::vector<std::uint32_t> zone;
    Points slid = mesh.vertices;
    const TriangleTree tree(mesh.vertices, mesh.triangles, Context());
    for (Index v = 0; v < slid.rows(); ++v) {
        const Vector3 p = mesh.vertices.row(v).transpose();
        if (p[2] > 40) zone.push_back(static_cast<std::uint32_t>(v));
        // Up to 4 mm along the surface, another way on each side: the surface itself stays.
        const Vector3 slide(0, p[0] > 0 ? 4 : -1, 0);
        slid.row(v) = tree.closest(p + slide).point.transpose();
    }
    const Similarity motion = known_motion();
    const Points source = motion.inverse().apply(PointsRef(slid));
    const Similarity by_pairs =
        align_on_zone(source, mesh.vertices, mesh.triangles, zone, {}).motion;
    const Similarity by_surface = align_fits_on_zone(source, mesh, zone, Context()).motion;
    EXPECT_GT(largest_difference(by_pairs, motion, source), 0.5);
    EXPECT_LT(largest_difference(by_surface, motion, source),
              0.1 * largest_difference(by_pairs, motion, source));
}

TEST(ScanVolume, AlongADirectionIsTheHeightFieldIntegral) {
    const TriMesh plane = test::grid(80, 50, 90, 60);
    TriMesh bump = test::grid(80, 50, 211, 133);
    for (Index v = 0; v < bump.vertices.rows(); ++v)
        bump.vertices(v, 2) = 2 * std::sin(2 * kPi * bump.vertices(v, 0) / 40);
    ScanVolumeOptions options;
    options.carry = Carry::direction;
    const double truth = 2.0 * (2.0 * 40.0 / kPi) * 50.0 * 1e-3;
    const ScanVolumeReport report = measure_scan_volume(plane, bump, options, {});
    EXPECT_NEAR(report.volume.whole.volume.positive_ml, truth, 2e-3 * truth);
    EXPECT_NEAR(report.volume.whole.volume.negative_ml, -truth, 2e-3 * truth);
    EXPECT_NEAR(report.whole_coverage, 1.0, 1e-12);
}

TEST(ScanVolume, ByClosestPointOrNormalOfSpheresIsTheShell) {
    const TriMesh inner = test::sphere(50, 5), outer = test::sphere(51, 6);
    ScanVolumeOptions options;
    const double truth = 32.048;
    for (Carry carry : {Carry::closest_point, Carry::vertex_normal}) {
        options.carry = carry;
        EXPECT_NEAR(measure_scan_volume(inner, outer, options, {}).volume.whole.volume.signed_ml,
                    truth, 0.01 * truth);
    }
}

// "Align the surfaces first" was said of a scan in metres, which no alignment brings near.
TEST(ScanVolume, NamesTheUnitWhereThereIsNoPartner) {
    const TriMesh before = test::sphere(50, 2);
    TriMesh after = before;
    after.vertices /= 1000;
    ScanVolumeOptions options;
    options.max_distance_mm = 5;
    EXPECT_EQ(test::status_of([&] { measure_scan_volume(before, after, options, {}); }),
              Status::mismatch);
    after.vertices = before.vertices.rowwise() + Vector3(500, 0, 0).transpose();
    EXPECT_EQ(test::status_of([&] { measure_scan_volume(before, after, options, {}); }),
              Status::no_solution);
}

TEST(ScanVolume, SaysHowMuchOfAZoneHadAPartner) {
    const TriMesh wide = test::grid(40, 20, 80, 40);
    TriMesh narrow = test::grid(20, 20, 20, 20);
    narrow.vertices.col(2).array() += 1;
    std::vector<std::uint32_t> all;
    for (std::uint32_t v = 0; v < 81 * 41; ++v) all.push_back(v);
    ScanVolumeOptions options;
    options.carry = Carry::direction;
    options.zones = {{"all", all}};
    const ScanVolumeReport report = measure_scan_volume(wide, narrow, options, {});
    EXPECT_NEAR(report.zone_coverage[0], 0.5, 0.02);
    EXPECT_NEAR(report.volume.zones[0].volume.signed_ml, 0.4, 0.01);
    narrow.vertices.col(2).array() += 100;
    EXPECT_EQ(test::status_of([&] { measure_scan_volume(wide, narrow, options, {}); }),
              Status::no_solution);
}

TEST(ScanAlignment, BringsAScanOfOtherTopologyBack) {
    const TriMesh target = ellipsoid(5);
    TriMesh source = ellipsoid(4);
    // The lower half has changed; another connectivity, seen from elsewhere.
    for (Index v = 0; v < source.vertices.rows(); ++v)
        if (source.vertices(v, 1) < -10) source.vertices.row(v) *= 1.04;
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.06, Vector3(1, 2, -1).normalized()).toRotationMatrix();
    motion.translation = Vector3(3, -2, 4);
    source.vertices = motion.inverse().apply(PointsRef(source.vertices));
    std::vector<std::uint32_t> zone;
    for (Index v = 0; v < target.vertices.rows(); ++v)
        if (target.vertices(v, 1) > 0) zone.push_back(static_cast<std::uint32_t>(v));
    const RigidZoneResult result = align_scans_on_zone(source, target, zone, Similarity(), {}, {});
    EXPECT_LT(largest_difference(result.motion, motion, source.vertices), 0.15);
    EXPECT_LT(result.rms_mm, 0.15);  // chords of the coarse ellipsoid
}

}  // namespace
}  // namespace mien
