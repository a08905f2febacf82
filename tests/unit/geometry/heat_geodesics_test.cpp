#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <filesystem>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "geometry/distance_field.hpp"
#include "geometry/heat_method.hpp"
#include "geometry/intrinsic_mesh.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/geometry/sphere.hpp"

namespace mien {
namespace {

using test::sheet;
using test::sphere;
using test::Surface;

HeatGeodesics heat(const Surface& s, const HeatOptions& options = {}) {
    return HeatGeodesics(s.vertices, s.triangles, options, {});
}

TEST(HeatGeodesics, SphereOf26000VerticesIsWithinOnePercent) {
    const Surface s = sphere(51);
    ASSERT_EQ(s.vertices.rows(), 26012);
    const HeatGeodesics geodesics = heat(s);
    for (const std::uint32_t source : {0u, 7001u, 25000u}) {
        const Vector d = geodesics.distances_from(source);
        double sum = 0, most = 0;
        for (Index v = 0; v < d.size(); ++v) {
            const double cosine = s.vertices.row(v).dot(s.vertices.row(source));
            const double error = std::abs(d[v] - std::acos(std::clamp(cosine, -1.0, 1.0)));
            sum += error;
            most = std::max(most, error);
        }
        EXPECT_LT(sum / static_cast<double>(d.size()), 0.010) << "source " << source;
        EXPECT_LT(most, 0.024) << "source " << source;
    }
}

TEST(HeatGeodesics, FlatSheetGivesStraightLines) {
    const Surface s = sheet(60, 60);
    for (const HeatBoundary boundary :
         {HeatBoundary::neumann, HeatBoundary::dirichlet, HeatBoundary::average}) {
        HeatOptions options;
        options.boundary = boundary;
        const Vector d = heat(s, options).distances_from(30 * 61 + 30);
        double most = 0;
        for (Index v = 0; v < d.size(); ++v)
            most = std::max(
                most, std::abs(d[v] - (s.vertices.row(v) - s.vertices.row(30 * 61 + 30)).norm()));
        // Only heat that is cooled at the border bends noticeably there.
        EXPECT_LT(most, boundary == HeatBoundary::dirichlet ? 3.5 : 2.0)
            << static_cast<int>(boundary);
    }
}

TEST(HeatGeodesics, DistanceAcrossASlitGoesAroundIt) {
    // The squares right and left of x = 20 share no vertex for y < 30.
    Surface s = sheet(40, 40);
    const Index first_copy = s.vertices.rows();
    Points vertices(first_copy + 30, 3);
    vertices.topRows(first_copy) = s.vertices;
    for (Index y = 0; y < 30; ++y) vertices.row(first_copy + y) = s.vertices.row(y * 41 + 20);
    for (Index t = 0; t < s.triangles.rows(); ++t) {
        double x = 0;
        for (int k = 0; k < 3; ++k) x += s.vertices(s.triangles(t, k), 0) / 3;
        if (x > 20)
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t v = s.triangles(t, k);
                if (v % 41 == 20 && v / 41 < 30)
                    s.triangles(t, k) = static_cast<std::uint32_t>(first_copy) + v / 41;
            }
    }
    s.vertices = vertices;
    const HeatGeodesics geodesics = heat(s);
    const Vector d = geodesics.distances_from(0 * 41 + 18);
    // From (18, 0) round the end of the slit at (20, 30) to (22, 0).
    const double around = 2 * std::hypot(2.0, 30.0);
    EXPECT_NEAR(d[22], around, 0.06 * around);
    EXPECT_GT(d[22], 50.0);
    EXPECT_NEAR(d[10], 8.0, 0.5);
}

TEST(HeatGeodesics, BatchesAgreeWithSingleSourcesForAnyNumberOfThreads) {
    const Surface s = sphere(12);
    const HeatGeodesics geodesics = heat(s);
    std::vector<std::uint32_t> sources;
    for (std::uint32_t v = 0; v < 21; ++v) sources.push_back(v * 61);
    Eigen::MatrixXf one(s.vertices.rows(), 21), three(s.vertices.rows(), 21);
    geodesics.distances(sources, one, {});
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    geodesics.distances(sources, three, context);
    EXPECT_EQ(one, three);
    for (const Index k : {0, 7, 8, 20}) {
        const Vector alone = geodesics.distances_from(sources[static_cast<std::size_t>(k)]);
        EXPECT_EQ(one.col(k), alone.cast<float>());
    }
}

TEST(HeatGeodesics, MovingAndScalingTheSurfaceMovesAndScalesDistances) {
    Surface s = sphere(10);
    const Vector before = heat(s).distances_from(5);
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    motion.translation = Vector3(100, -3, 7);
    motion.scale = 1000;
    s.vertices = motion.apply(s.vertices);
    const Vector after = heat(s).distances_from(5);
    EXPECT_LT((after / 1000 - before).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HeatGeodesics, OtherComponentsAreInfinitelyFar) {
    Surface s = sheet(5, 5);
    Surface two = s;
    two.vertices.resize(73, 3);
    two.vertices << s.vertices, s.vertices.rowwise() + Eigen::RowVector3d(0, 0, 1),
        Eigen::RowVector3d(9, 9, 9);
    two.triangles.resize(100, 3);
    two.triangles << s.triangles, (s.triangles.array() + 36).matrix();
    const Vector d = heat(two).distances_from(40);
    for (Index v = 0; v < 73; ++v) EXPECT_EQ(std::isfinite(d[v]), v >= 36 && v < 72) << v;
    const Vector lonely = heat(two).distances_from(72);
    EXPECT_EQ(lonely[72], 0.0);
    EXPECT_EQ(lonely[0], std::numeric_limits<double>::infinity());
}

TEST(HeatGeodesics, NeedlesDuplicatesAndFoldsStayFinite) {
    Surface s = sheet(20, 20);
    // A needle: one vertex almost on its neighbour's edge; a duplicate: two neighbours in one
    // place.
    s.vertices.row(10 * 21 + 10) = s.vertices.row(10 * 21 + 11) + Eigen::RowVector3d(-1e-9, 0, 0);
    s.vertices.row(5 * 21 + 5) = s.vertices.row(5 * 21 + 6);
    // A third sheet on an interior edge, a repeated triangle, one with a repeated corner.
    const Index t = s.triangles.rows();
    s.vertices.conservativeResize(s.vertices.rows() + 1, 3);
    s.vertices.bottomRows(1) << 15.5, 15.5, 3.0;
    s.triangles.conservativeResize(t + 3, 3);
    s.triangles.row(t) << 15 * 21 + 15, 15 * 21 + 16,
        static_cast<std::uint32_t>(s.vertices.rows() - 1);
    s.triangles.row(t + 1) = s.triangles.row(0);
    s.triangles.row(t + 2) << 3, 3, 4;
    const HeatGeodesics geodesics = heat(s);
    for (const std::uint32_t source : {0u, 10u * 21 + 10, 5u * 21 + 5, 441u}) {
        const Vector d = geodesics.distances_from(source);
        ASSERT_TRUE(d.allFinite()) << source;
        EXPECT_EQ(d[source], 0.0);
        for (Index v = 0; v < d.size(); ++v)
            EXPECT_GT(d[v], 0.75 * (s.vertices.row(v) - s.vertices.row(source)).norm() - 1.0)
                << source << " " << v;
    }
}

TEST(HeatGeodesics, HeatThatUnderflowsStillReachesFar) {
    // A ribbon of 3000 squares: exp(-distance / sqrt t) is 1e-1300 at its end.
    const Surface s = sheet(3000, 2);
    const Vector d = heat(s).distances_from(0);
    ASSERT_TRUE(d.allFinite());
    EXPECT_NEAR(d[3000], 3000, 60);
    for (Index x = 1; x <= 3000; ++x) ASSERT_GT(d[x], d[x - 1]) << x;
}

TEST(HeatGeodesics, TemplateDistancesAreFiniteAndSymmetric) {
    const std::string path = std::string(MIEN_SHARED_DATA) + "/ict/template.ply";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs the shared data";
    const TriMesh mesh = read_mesh_file(path, {});
    const HeatGeodesics geodesics(mesh.vertices, mesh.triangles, {}, {});
    std::vector<std::uint32_t> sources;
    for (std::uint32_t v = 0; v < mesh.vertices.rows(); v += 61) sources.push_back(v);
    Eigen::MatrixXf d(mesh.vertices.rows(), static_cast<Index>(sources.size()));
    geodesics.distances(sources, d, {});
    EXPECT_TRUE(d.allFinite());
    make_symmetric(sources, d);
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double there = d(sources[i], static_cast<Index>(j)),
                         back = d(sources[j], static_cast<Index>(i));
            ASSERT_LE(std::abs(there - back), 1e-6);
            ASSERT_GT(there, 0);
            // Along the surface is never much shorter than straight.
            ASSERT_GT(
                there,
                0.9 * (mesh.vertices.row(sources[i]) - mesh.vertices.row(sources[j])).norm() - 2);
        }
}

TEST(HeatGeodesics, RefusesWhatItCannotUse) {
    const Surface s = sheet(3, 3);
    HeatOptions options;
    options.time_factor = 0;
    EXPECT_THROW(heat(s, options), Error);
    Surface broken = s;
    broken.vertices(4, 1) = std::nan("");
    EXPECT_THROW(heat(broken), Error);
    broken = s;
    broken.triangles(2, 0) = 99;
    EXPECT_THROW(heat(broken), Error);
    EXPECT_THROW(heat(s).distances_from(16), Error);
    broken = s;
    broken.vertices.setZero();
    EXPECT_THROW(heat(broken), Error);
}

TEST(HeatGeodesics, CancelsBetweenBlocks) {
    const Surface s = sheet(10, 10);
    const HeatGeodesics geodesics = heat(s);
    CancelToken token;
    token.request();
    Context context;
    context.cancel = &token;
    Eigen::MatrixXf d(121, 1);
    try {
        geodesics.distances({0}, d, context);
        FAIL() << "went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::cancelled);
    }
}

TEST(IntrinsicMesh, KeepsAreaAndHasNoNegativeWeight) {
    // A sheet sheared until its triangles are slivers.
    Surface s = sheet(12, 12);
    for (Index v = 0; v < s.vertices.rows(); ++v) s.vertices(v, 0) += 4.3 * s.vertices(v, 1);
    const IntrinsicMesh mesh = build_intrinsic_mesh(s.vertices, s.triangles);
    EXPECT_GT(mesh.num_flips, 100);
    double area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> weight;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        area += 0.5 * mesh.weights[t] * mesh.double_area(t);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles(t, (k + 1) % 3),
                                b = mesh.triangles(t, (k + 2) % 3);
            weight[{std::min(a, b), std::max(a, b)}] += mesh.weights[t] * mesh.cotangent(t, k);
        }
    }
    EXPECT_NEAR(area, 144, 1e-6);
    for (const auto& [edge, w] : weight)
        if (edge.first != edge.second) {
            EXPECT_GT(w, -1e-6) << edge.first << " " << edge.second;
        }
}

TEST(DistanceField, IsTheNearestOfItsSourcesFields) {
    const Surface s = sphere(12);
    std::vector<std::uint32_t> sources;
    for (std::uint32_t k = 0; k < 70; ++k) sources.push_back(20 * k);  // more than one block
    const HeatGeodesics one = heat(s);
    Vector expected = one.distances_from(sources[0]);
    for (const std::uint32_t source : sources)
        expected = expected.cwiseMin(one.distances_from(source));
    ThreadPool pool(3);
    Context threads;
    threads.pool = &pool;
    const Vector field = distance_field(s.vertices, s.triangles, sources, {}, threads);
    EXPECT_LT((field - expected).cwiseAbs().maxCoeff(), 1e-6);
    for (const std::uint32_t source : sources) EXPECT_EQ(field[source], 0.0);
    EXPECT_EQ(field, distance_field(s.vertices, s.triangles, sources, {}, {}));
    EXPECT_THROW(distance_field(s.vertices, s.triangles, {}, {}, {}), Error);
    EXPECT_THROW(distance_field(s.vertices, s.triangles, {1u << 20}, {}, {}), Error);
}

}  // namespace
}  // namespace mien
