// Orders of neighbourhoods on meshes whose right order is plain to see.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "learning/spirals.hpp"
#include "unit/spectral/shapes.hpp"

namespace mien {
namespace {

/// A flat 5 x 5 grid of unit squares, each cut along the same diagonal.
TriMesh flat_grid() {
    TriMesh mesh;
    mesh.vertices.resize(25, 3);
    for (Index v = 0; v < 25; ++v)
        mesh.vertices.row(v) << static_cast<double>(v % 5), static_cast<double>(v / 5), 0;
    mesh.triangles.resize(32, 3);
    Index f = 0;
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t a = 5 * y + x;
            mesh.triangles.row(f++) << a, a + 1, a + 6;
            mesh.triangles.row(f++) << a, a + 6, a + 5;
        }
    return mesh;
}

double angle_of(const TriMesh& mesh, std::uint32_t centre, std::uint32_t v) {
    const Eigen::RowVector3d d = mesh.vertices.row(v) - mesh.vertices.row(centre);
    return std::atan2(d.y(), d.x());
}

TEST(Spirals, RingsTurnCounterClockwise) {
    const TriMesh mesh = flat_grid();
    const auto rings = ordered_rings(mesh);
    ASSERT_EQ(rings[12].size(), 6u);
    double turn = 0;
    for (std::size_t k = 0; k < 6; ++k) {
        double step = angle_of(mesh, 12, rings[12][(k + 1) % 6]) - angle_of(mesh, 12, rings[12][k]);
        if (step < 0) step += 2 * 3.14159265358979;
        EXPECT_GT(step, 0);
        turn += step;
    }
    EXPECT_NEAR(turn, 2 * 3.14159265358979, 1e-9);
    // At the border the walk begins where no triangle comes before: from right to left below.
    EXPECT_EQ(rings[2], (std::vector<std::uint32_t>{3, 8, 7, 1}));
}

TEST(Spirals, WindAroundTheVertexRingByRing) {
    const TriMesh mesh = flat_grid();
    const auto rows = spirals(mesh, 19);
    const VertexRings plain = build_rings(25, mesh.triangles);
    const auto ring_of = [&](std::uint32_t a, std::uint32_t b) {
        RingWalker walker(plain);
        for (Index k = 0; k < 5; ++k) {
            const auto& near = walker.within(a, k);
            if (std::find(near.begin(), near.end(), b) != near.end()) return k;
        }
        return Index(9);
    };
    const std::vector<std::uint32_t> row(rows.begin() + 12 * 19, rows.begin() + 13 * 19);
    EXPECT_EQ(row[0], 12u);
    EXPECT_EQ(std::set<std::uint32_t>(row.begin(), row.end()).size(), 19u);
    for (std::size_t k = 1; k < 19; ++k) EXPECT_EQ(ring_of(12, row[k]), k < 7 ? 1 : 2) << k;
}

TEST(Spirals, SmallPiecesAreFilledByDistanceAndPadded) {
    TriMesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9;
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    const auto rows = spirals(mesh, 6);
    EXPECT_EQ(std::vector<std::uint32_t>(rows.begin(), rows.begin() + 6),
              (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 4}));
    EXPECT_EQ(std::vector<std::uint32_t>(rows.begin() + 18, rows.end()),
              (std::vector<std::uint32_t>{3, 1, 2, 0, 4, 4}));
}

TEST(Spirals, OfNeural3dmmBeginTowardsTheReference) {
    const TriMesh mesh = flat_grid();
    Index length = 0;
    const auto rows = reference_spirals(mesh, 1, 1, 24, length);
    // Interior vertices have seven places; borders have fewer and pull the mean down.
    EXPECT_GE(length, 6);
    for (const Index v : {6, 7, 11, 12}) {
        const auto* row = rows.data() + v * length;
        EXPECT_EQ(row[0], static_cast<std::uint32_t>(v));
        EXPECT_EQ(row[1], static_cast<std::uint32_t>(v + 6)) << "the diagonal leads to vertex 24";
    }
    // The corner has three neighbours: the rest is padding.
    EXPECT_EQ(rows[static_cast<std::size_t>(length) - 1], 25u);
    Index dilated = 0;
    const auto wide = reference_spirals(mesh, 2, 2, 24, dilated);
    EXPECT_EQ(wide[static_cast<std::size_t>(12 * dilated)], 12u);
    EXPECT_GT(dilated, length);
}

TEST(Spirals, SurviveWhatIsNoSurface) {
    TriMesh mesh = test::face_like(4);
    mesh.triangles.row(0) << 1, 1, 2;   // a vertex twice
    mesh.triangles.row(3) << 0, 9, 20;  // an edge of three triangles, or a second fan
    mesh.triangles.row(4) << 9, 0, 21;
    const auto rings = ordered_rings(mesh);
    const VertexRings plain = build_rings(mesh.vertices.rows(), mesh.triangles);
    for (std::size_t v = 0; v < rings.size(); ++v) {
        const std::set<std::uint32_t> found(rings[v].begin(), rings[v].end());
        EXPECT_EQ(found.size(), rings[v].size());
        if (v != 1 && v != 2) {
            EXPECT_EQ(found, std::set<std::uint32_t>(plain.of(v).begin(), plain.of(v).end())) << v;
        }
    }
}

}  // namespace
}  // namespace mien
