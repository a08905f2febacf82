#include "spatial/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "spatial/triangle_distance.hpp"

namespace mien {
namespace {

struct Surface {
    Points vertices;
    Triangles triangles;
};

// A wavy sheet, size x size quads, each cut into two triangles.
Surface sheet(Index size, double shift = 0) {
    Surface s;
    s.vertices.resize((size + 1) * (size + 1), 3);
    s.triangles.resize(2 * size * size, 3);
    for (Index i = 0; i <= size; ++i)
        for (Index j = 0; j <= size; ++j)
            s.vertices.row(i * (size + 1) + j) << i + shift, j,
                4 * std::sin(0.3 * i) * std::cos(0.2 * j);
    for (Index i = 0; i < size; ++i)
        for (Index j = 0; j < size; ++j) {
            const auto a = static_cast<std::uint32_t>(i * (size + 1) + j);
            const auto b = a + static_cast<std::uint32_t>(size + 1);
            s.triangles.row(2 * (i * size + j)) << a, b, b + 1;
            s.triangles.row(2 * (i * size + j) + 1) << a, b + 1, a + 1;
        }
    return s;
}

SurfaceHit brute_force(const Surface& s, const Vector3& p) {
    SurfaceHit best;
    for (Index t = 0; t < s.triangles.rows(); ++t) {
        const TrianglePlace place =
            closest_on_triangle(p, s.vertices.row(s.triangles(t, 0)).transpose(),
                                s.vertices.row(s.triangles(t, 1)).transpose(),
                                s.vertices.row(s.triangles(t, 2)).transpose());
        if (place.squared_distance < best.squared_distance) {
            best.squared_distance = place.squared_distance;
            best.triangle = static_cast<std::uint32_t>(t);
        }
    }
    return best;
}

Points scattered(Index count, double spread, unsigned seed) {
    std::mt19937 generator(seed);
    Points p(count, 3);
    for (Index i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) p(i, k) = spread * (generator() / 4294967296.0 - 0.25);
    return p;
}

TEST(TriangleTree, FindsWhatBruteForceFinds) {
    for (Index size : {1, 2, 3, 7, 20}) {
        const Surface s = sheet(size);
        const TriangleTree tree(s.vertices, s.triangles, {});
        const Points queries = scattered(300, 40, 3);
        for (Index i = 0; i < queries.rows(); ++i) {
            const Vector3 p = queries.row(i).transpose();
            const SurfaceHit hit = tree.closest(p);
            ASSERT_TRUE(hit.valid());
            EXPECT_NEAR(hit.squared_distance, brute_force(s, p).squared_distance, 1e-9);
            Vector3 from_barycentric = Vector3::Zero();
            for (int k = 0; k < 3; ++k)
                from_barycentric +=
                    hit.barycentric[k] * s.vertices.row(s.triangles(hit.triangle, k)).transpose();
            EXPECT_LT((from_barycentric - hit.point).norm(), 1e-9);
            EXPECT_NEAR((hit.point - p).squaredNorm(), hit.squared_distance, 1e-9);
        }
    }
}

TEST(TriangleTree, FarAndFarOffCentreQueriesStayExact) {
    const Surface s = sheet(15, 1e5);
    const TriangleTree tree(s.vertices, s.triangles, {});
    for (double far : {1e2, 1e4, 1e7}) {
        const Vector3 p(1e5 + 3 + far, 7 - far, far);
        EXPECT_NEAR(tree.closest(p).distance(), std::sqrt(brute_force(s, p).squared_distance),
                    1e-9 * far);
    }
}

TEST(TriangleTree, AnswersDoNotDependOnThreadsOrHints) {
    const Surface s = sheet(60);
    const Points queries = scattered(2000, 90, 5);
    const TriangleTree tree(s.vertices, s.triangles, {});
    std::vector<SurfaceHit> alone, together;
    tree.closest(queries, 1e9, alone, {});
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const TriangleTree tree3(s.vertices, s.triangles, context);
    tree3.closest(queries, 1e9, together, context);
    std::vector<SurfaceHit> again(alone.rbegin(), alone.rend());  // useless hints
    tree.closest(queries, 1e9, again, {});
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(alone[i].triangle, together[i].triangle);
        EXPECT_EQ(alone[i].point, together[i].point);
        EXPECT_EQ(alone[i].triangle, again[i].triangle);
        EXPECT_EQ(alone[i].point, again[i].point);
    }
}

TEST(TriangleTree, LowestIndexWinsTies) {
    Surface s;
    s.vertices.resize(3, 3);
    s.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    s.triangles.resize(40, 3);
    for (Index t = 0; t < 40; ++t) s.triangles.row(t) << 0, 1, 2;
    const TriangleTree tree(s.vertices, s.triangles, {});
    EXPECT_EQ(tree.closest(Vector3(0.2, 0.2, 1)).triangle, 0u);
    EXPECT_EQ(tree.closest(Vector3(0.2, 0.2, 1), 10, 31).triangle, 0u);
}

TEST(TriangleTree, MaximalDistanceBoundsTheSearch) {
    const Surface s = sheet(4);
    const TriangleTree tree(s.vertices, s.triangles, {});
    EXPECT_FALSE(tree.closest(Vector3(0, 0, 100), 50).valid());
    EXPECT_TRUE(tree.closest(Vector3(0, 0, 100), 150).valid());
}

TEST(TriangleTree, DegenerateTrianglesAreSegmentsAndPoints) {
    Surface s;
    s.vertices.resize(4, 3);
    s.vertices << 0, 0, 0, 2, 0, 0, 1, 0, 0, 5, 5, 5;
    s.triangles.resize(2, 3);
    s.triangles << 0, 1, 2, 3, 3, 3;
    const TriangleTree tree(s.vertices, s.triangles, {});
    const SurfaceHit on_segment = tree.closest(Vector3(1.5, 1, 0));
    EXPECT_EQ(on_segment.triangle, 0u);
    EXPECT_NEAR(on_segment.squared_distance, 1, 1e-12);
    EXPECT_TRUE(on_segment.barycentric.allFinite());
    EXPECT_EQ(tree.closest(Vector3(6, 5, 5)).triangle, 1u);
}

TEST(TriangleTree, ServesPointClouds) {
    const Points cloud = scattered(777, 10, 9), queries = scattered(100, 12, 10);
    const TriangleTree tree(cloud, Triangles(0, 3), {});
    EXPECT_TRUE(tree.is_point_cloud());
    for (Index i = 0; i < queries.rows(); ++i) {
        Index nearest;
        const double d =
            (cloud.rowwise() - queries.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
        const SurfaceHit hit = tree.closest(queries.row(i).transpose());
        EXPECT_EQ(static_cast<Index>(hit.triangle), nearest);
        EXPECT_NEAR(hit.squared_distance, d, 1e-12);
    }
}

TEST(TriangleTree, RaysHitTheNearestTriangleAndCountAllCrossings) {
    Surface s = sheet(12);
    const Index count = s.triangles.rows();
    const Index vertices = s.vertices.rows();
    s.vertices.conservativeResize(2 * vertices, 3);  // a second sheet 20 mm above
    s.triangles.conservativeResize(2 * count, 3);
    for (Index i = 0; i < vertices; ++i)
        s.vertices.row(vertices + i) = s.vertices.row(i) + Eigen::RowVector3d(0, 0, 20);
    for (Index t = 0; t < count; ++t)
        s.triangles.row(count + t) =
            s.triangles.row(t).array() + static_cast<std::uint32_t>(vertices);
    const TriangleTree tree(s.vertices, s.triangles, {});
    const Points places = scattered(200, 10, 4);
    for (Index i = 0; i < places.rows(); ++i) {
        const double x = 1 + std::abs(places(i, 0)), y = 1 + std::abs(places(i, 1));
        const RayHit hit = tree.first_hit(Vector3(x, y, 100), Vector3(0, 0, -2));
        ASSERT_TRUE(hit.valid());
        EXPECT_GE(static_cast<Index>(hit.triangle), count);
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
            place += hit.barycentric[k] * s.vertices.row(s.triangles(hit.triangle, k)).transpose();
        EXPECT_LT((place - Vector3(x, y, 100 - 2 * hit.t)).norm(), 1e-9);
        EXPECT_EQ(tree.count_crossings(Vector3(x, y, 100), Vector3(0, 0, -2)), 2);
        EXPECT_EQ(tree.count_crossings(Vector3(x, y, 100), Vector3(0, 0, -2), 45), 1);
    }
    EXPECT_FALSE(tree.first_hit(Vector3(-5, -5, 100), Vector3(0, 0, -1)).valid());
}

// Triangles of any shape: large, small, needles and some without area.
Surface jumble(Index count, unsigned seed) {
    const Points corners = scattered(3 * count, 30, seed), shapes = scattered(count, 2, seed + 1);
    Surface s;
    s.vertices = corners;
    s.triangles.resize(count, 3);
    for (Index t = 0; t < count; ++t) {
        const auto a = static_cast<std::uint32_t>(3 * t);
        s.triangles.row(t) << a, a + 1, a + 2;
        const double thin = t % 5 == 0 ? 0 : std::pow(10.0, -static_cast<double>(t % 9));
        const Eigen::RowVector3d along = corners.row(3 * t + 1) - corners.row(3 * t);
        s.vertices.row(3 * t + 1) =
            s.vertices.row(3 * t) + (0.1 + 0.2 * std::abs(shapes(t, 0))) * along;
        s.vertices.row(3 * t + 2) = s.vertices.row(3 * t) + 0.07 * along + thin * shapes.row(t);
    }
    return s;
}

TEST(TriangleTree, AnyShapeOfTriangleIsFound) {
    for (Index count : {1, 9, 65, 700}) {
        const Surface s = jumble(count, 11);
        const TriangleTree tree(s.vertices, s.triangles, {});
        const Points queries = scattered(400, 40, 12);
        for (Index i = 0; i < queries.rows(); ++i) {
            const Vector3 p = queries.row(i).transpose();
            const SurfaceHit truth = brute_force(s, p), hit = tree.closest(p);
            ASSERT_EQ(hit.triangle, truth.triangle) << count << " triangles, query " << i;
            EXPECT_NEAR(hit.squared_distance, truth.squared_distance,
                        1e-7 * (1 + truth.squared_distance));
        }
    }
}

TEST(TriangleTree, RaysMeetEachTriangleOnce) {
    // Also where the last nodes have fewer children than eight.
    for (Index count : {1, 7, 9, 63, 65, 513, 700}) {
        const Surface s = jumble(count, 21);
        const TriangleTree tree(s.vertices, s.triangles, {});
        const Points from = scattered(150, 60, 22), to = scattered(150, 30, 23);
        for (Index i = 0; i < from.rows(); ++i) {
            const Vector3 origin = from.row(i).transpose(),
                          direction = 0.01 * (to.row(i) - from.row(i)).transpose();
            Index crossed = 0;
            double nearest = std::numeric_limits<double>::infinity();
            for (Index t = 0; t < count; ++t) {
                const Vector3 a = s.vertices.row(s.triangles(t, 0)).transpose();
                const Vector3 ab = s.vertices.row(s.triangles(t, 1)).transpose() - a;
                const Vector3 ac = s.vertices.row(s.triangles(t, 2)).transpose() - a,
                              from_a = origin - a;
                const double determinant = ab.dot(direction.cross(ac));
                if (determinant == 0) continue;
                const double v = from_a.dot(direction.cross(ac)) / determinant,
                             w = direction.dot(from_a.cross(ab)) / determinant;
                const double t_hit = ac.dot(from_a.cross(ab)) / determinant;
                if (!(v >= 0 && w >= 0 && v + w <= 1 && t_hit >= 0)) continue;
                ++crossed;
                nearest = std::min(nearest, t_hit);
            }
            EXPECT_EQ(tree.count_crossings(origin, direction), crossed)
                << count << " triangles, ray " << i;
            const RayHit hit = tree.first_hit(origin, direction);
            ASSERT_EQ(hit.valid(), crossed > 0);
            if (hit.valid()) {
                EXPECT_NEAR(hit.t, nearest, 1e-6 * (1 + nearest));
            }
        }
    }
}

TEST(TriangleTree, InstructionSetsGiveTheSameBits) {
    const Surface s = jumble(3000, 31);
    const TriangleTree tree(s.vertices, s.triangles, {});
    const Points queries = scattered(2000, 40, 32);
    std::vector<SurfaceHit> hits[2];
    std::vector<RayHit> rays[2];
    for (int portable = 0; portable < 2; ++portable) {
        dense::use_portable_loops(portable == 1);
        tree.closest(queries, 1e9, hits[portable], {});
        for (Index i = 0; i + 1 < queries.rows(); ++i)
            rays[portable].push_back(tree.first_hit(
                queries.row(i).transpose(), (queries.row(i + 1) - queries.row(i)).transpose()));
    }
    dense::use_portable_loops(false);
    for (std::size_t i = 0; i < hits[0].size(); ++i) {
        EXPECT_EQ(hits[0][i].triangle, hits[1][i].triangle);
        EXPECT_EQ(hits[0][i].point, hits[1][i].point);
    }
    for (std::size_t i = 0; i < rays[0].size(); ++i) {
        EXPECT_EQ(rays[0][i].triangle, rays[1][i].triangle);
        EXPECT_EQ(rays[0][i].t, rays[1][i].t);
    }
}

TEST(TriangleTree, PlacesBeyondSinglePrecisionFindNothing) {
    const Surface s = jumble(9, 41);  // seven places of the last block are missing
    const TriangleTree tree(s.vertices, s.triangles, {});
    const TriangleTree huge(1e200 * s.vertices, s.triangles, {});
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double far : {1e30, 1e60, 1e300, infinity, std::nan("")}) {
        for (const Vector3& p :
             {Vector3(far, 0, 0), Vector3(1, -far, far), Vector3(far, far, far)}) {
            EXPECT_FALSE(tree.closest(p).valid());
            EXPECT_FALSE(huge.closest(p).valid());
            EXPECT_FALSE(tree.first_hit(p, Vector3(-1, -1, -1)).valid());
            EXPECT_FALSE(huge.first_hit(p, Vector3(-1, -1, -1)).valid());
            EXPECT_EQ(tree.count_crossings(Vector3(40, 40, 40), p, 1e-3), 0);
        }
    }
}

/// A bumpy sheet with 20000 triangles; the last vertex, which four triangles share, is put at
/// `far`.
struct SheetWithAFarVertex {
    Points vertices;
    Triangles triangles;
    explicit SheetWithAFarVertex(double far) : vertices(101 * 101, 3), triangles(20000, 3) {
        for (Index i = 0; i < vertices.rows(); ++i) {
            const double x = static_cast<double>(i % 101), y = static_cast<double>(i / 101);
            vertices.row(i) << x, y, 3 * std::sin(0.2 * x) * std::cos(0.3 * y);
        }
        for (Index t = 0; t < 10000; ++t) {
            const auto a = static_cast<std::uint32_t>(t / 100 * 101 + t % 100);
            triangles.row(2 * t) << a, a + 1, a + 102;
            triangles.row(2 * t + 1) << a, a + 102, a + 101;
        }
        if (far != 0) vertices.row(vertices.rows() - 1) << far, -far, far;
    }
};

double seconds_of_queries(const SheetWithAFarVertex& sheet) {
    const TriangleTree tree(sheet.vertices, sheet.triangles, Context());
    const std::clock_t begin = std::clock();
    for (Index i = 0; i < 3000; ++i) {
        const Vector3 query(0.03 * static_cast<double>(i), 50, 2);
        tree.closest(query);
        tree.count_crossings(query + Vector3(0, 0, 20), Vector3(0.1, 0.2, -1));
    }
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Boxes were widened by a share of the whole extent, so one spike made every box as large as the
// mesh.
TEST(TriangleTree, OneFarVertexDoesNotSlowTheOthers) {
    const double plain = seconds_of_queries(SheetWithAFarVertex(0));
    for (const double far : {1e6, 1e9, 1e12})
        EXPECT_LT(seconds_of_queries(SheetWithAFarVertex(far)), 8 * plain + 0.05) << far;
}

TEST(TriangleTree, AnswersBesideAFarVertexAreExact) {
    for (const double far : {1e6, 1e9, 1e12}) {
        const SheetWithAFarVertex sheet(far);
        const TriangleTree tree(sheet.vertices, sheet.triangles, Context());
        for (int i = 0; i < 60; ++i) {
            const Vector3 query(1.7 * i, 100 - 1.3 * i, i % 7);
            double best = std::numeric_limits<double>::infinity();
            for (Index t = 0; t < sheet.triangles.rows(); ++t)
                best =
                    std::min(best, closest_on_triangle(
                                       query, sheet.vertices.row(sheet.triangles(t, 0)).transpose(),
                                       sheet.vertices.row(sheet.triangles(t, 1)).transpose(),
                                       sheet.vertices.row(sheet.triangles(t, 2)).transpose())
                                       .squared_distance);
            EXPECT_NEAR(std::sqrt(tree.closest(query).squared_distance), std::sqrt(best),
                        1e-15 * far + 1e-12)
                << far;
            const Index crossings =
                tree.count_crossings(Vector3(0.5 + i, 40.3, 50), Vector3(0, 0, -1), 100);
            EXPECT_EQ(crossings, 1) << far;
        }
    }
}

TEST(TriangleTree, EmptyMeshIsATypedError) {
    try {
        TriangleTree tree(Points(0, 3), Triangles(0, 3), {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::invalid_mesh);
    }
}

}  // namespace
}  // namespace mien
