#include "mesh/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "mesh/half_edge.hpp"
#include "mesh/triangle_fans.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

TopologyReport inspect(const TriMesh& mesh) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), Context());
    return inspect_topology(table, mesh.triangles, mesh.vertices.rows());
}

std::vector<std::vector<std::uint32_t>> loops_of(const TriMesh& mesh) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), Context());
    return border_loops(table, mesh.triangles, mesh.vertices.rows());
}

TEST(Topology, EulersFormulaHoldsForAClosedMeshAndADisc) {
    const TriMesh closed = tetrahedron(), disc = grid(7);
    EXPECT_EQ(build_edge_table(closed.triangles, 4, Context()).num_edges(), 6u);
    const EdgeTable table = build_edge_table(disc.triangles, 49, Context());
    EXPECT_EQ(49 - static_cast<Index>(table.num_edges()) + disc.triangles.rows(), 1);
    EXPECT_TRUE(inspect(closed).is_oriented_manifold());
    EXPECT_EQ(inspect(closed).num_border_edges, 0);
    EXPECT_EQ(inspect(disc).num_border_edges, 24);
}

TEST(Topology, TheBorderOfAGridRunsOnceAroundWithTheSurfaceOnItsLeft) {
    const TriMesh mesh = grid(4);
    const auto loops = loops_of(mesh);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops[0], (std::vector<std::uint32_t>{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}));
    const EdgeTable table = build_edge_table(mesh.triangles, 16, Context());
    const auto on_border = border_vertices(table, 16);
    EXPECT_EQ(std::accumulate(on_border.begin(), on_border.end(), 0), 12);
    EXPECT_EQ(on_border[5], 0);
    EXPECT_EQ(border_vertices(mesh.triangles, 16, Context()), on_border);
}

TEST(Topology, ASideFromAVertexToItselfIsNoBorder) {
    TriMesh closed = tetrahedron();
    closed.triangles.conservativeResize(closed.triangles.rows() + 1, 3);
    closed.triangles.bottomRows(1).setConstant(2);
    const std::vector<std::uint8_t> nowhere(4, 0);
    EXPECT_EQ(border_vertices(closed.triangles, 4, Context()), nowhere);
}

TEST(Topology, AHoleIsALoopOfItsOwn) {
    TriMesh mesh = grid(6);
    // The two triangles of the cell in row 2, column 2.
    const Index cell = 2 * (2 * 5 + 2);
    Triangles fewer(mesh.triangles.rows() - 2, 3);
    fewer << mesh.triangles.topRows(cell),
        mesh.triangles.bottomRows(mesh.triangles.rows() - cell - 2);
    mesh.triangles = fewer;
    const auto loops = loops_of(mesh);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(loops[0].size(), 20u);
    EXPECT_EQ(loops[1], (std::vector<std::uint32_t>{14, 20, 21, 15}));
}

TEST(Topology, FaultsAreCountedAndTheFirstIsNamed) {
    TriMesh fin = tetrahedron();  // a third triangle on the edge 0-1
    fin.vertices.conservativeResize(6, 3);
    fin.vertices.bottomRows(2).setConstant(9.0);
    fin.triangles.conservativeResize(5, 3);
    fin.triangles.row(4) << 0, 1, 4;
    const TopologyReport report = inspect(fin);
    EXPECT_EQ(report.num_complex_edges, 1);
    EXPECT_EQ(report.first_complex_edge, 0);
    EXPECT_EQ(report.num_unused_vertices, 1);
    EXPECT_FALSE(report.is_oriented_manifold());

    TriMesh flipped = grid(3);
    std::swap(flipped.triangles(0, 0), flipped.triangles(0, 1));
    EXPECT_GT(inspect(flipped).num_misoriented_edges, 0);
    EXPECT_EQ(inspect(flipped).num_complex_edges, 0);

    TriMesh bow;  // two triangles that share nothing but vertex 2
    bow.vertices = Points::Random(5, 3);
    bow.triangles = triangles_of({{0, 1, 2}, {2, 3, 4}});
    EXPECT_EQ(inspect(bow).num_pinched_vertices, 1);
    EXPECT_EQ(inspect(bow).first_pinched_vertex, 2);

    TriMesh line = tetrahedron();
    line.triangles(2, 1) = line.triangles(2, 0);
    EXPECT_EQ(inspect(line).first_degenerate_triangle, 2);
}

TEST(Topology, PiecesAreOrderedBySizeAndDoNotDependOnTheOrderOfTriangles) {
    const TriMesh small = tetrahedron(), large = grid(5);
    TriMesh both;
    both.vertices.resize(30, 3);
    both.vertices << small.vertices, large.vertices, Points::Zero(1, 3);
    both.triangles.resize(small.triangles.rows() + large.triangles.rows(), 3);
    both.triangles << small.triangles, (large.triangles.array() + 4u).matrix();
    const ConnectedComponents parts = connected_components(both.triangles, 30);
    EXPECT_EQ(parts.num_triangles, (std::vector<Index>{32, 4, 0}));
    EXPECT_EQ(parts.num_vertices, (std::vector<Index>{25, 4, 1}));
    EXPECT_EQ(parts.of_vertex[0], 1u);
    EXPECT_EQ(parts.of_vertex[4], 0u);
    EXPECT_EQ(parts.of_vertex[29], 2u);
    EXPECT_EQ(parts.of_triangle[0], 1u);
    Triangles shuffled = both.triangles.colwise().reverse();
    EXPECT_EQ(connected_components(shuffled, 30).of_vertex, parts.of_vertex);
}

TEST(Topology, RandomSoupsAreSurvived) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        TriMesh mesh;
        const Index vertices = 1 + static_cast<Index>(random() % 12);
        mesh.vertices = Points::Random(vertices, 3);
        mesh.triangles.resize(static_cast<Index>(random() % 40), 3);
        for (Index i = 0; i < mesh.triangles.size(); ++i)
            mesh.triangles.data()[i] =
                static_cast<std::uint32_t>(random() % static_cast<unsigned>(vertices));
        const EdgeTable table = build_edge_table(mesh.triangles, vertices, Context());
        std::size_t in_loops = 0;
        for (const auto& loop : border_loops(table, mesh.triangles, vertices))
            in_loops += loop.size();
        EXPECT_GE(in_loops, border_sides(table).size());
        const bool manifold = inspect(mesh).is_oriented_manifold();
        if (manifold)
            EXPECT_NO_THROW(build_half_edge_mesh(mesh, "soup", Context()));
        else
            EXPECT_THROW(build_half_edge_mesh(mesh, "soup", Context()), Error);
    }
}

TEST(HalfEdge, KeepsNumbersAndGeometry) {
    for (TriMesh mesh : {tetrahedron(), grid(6)}) {
        const HalfEdgeMesh half_edges = build_half_edge_mesh(mesh, "mesh", Context());
        const TriMesh back = from_half_edge_mesh(half_edges);
        EXPECT_EQ(back.vertices, mesh.vertices);
        for (Index t = 0; t < mesh.triangles.rows(); ++t) {
            // The first corner may have turned.
            std::vector<std::uint32_t> a(3), b(3);
            for (int k = 0; k < 3; ++k) {
                a[static_cast<std::size_t>(k)] = mesh.triangles(t, k);
                b[static_cast<std::size_t>(k)] = back.triangles(t, k);
            }
            std::rotate(a.begin(), std::min_element(a.begin(), a.end()), a.end());
            std::rotate(b.begin(), std::min_element(b.begin(), b.end()), b.end());
            EXPECT_EQ(a, b);
        }
    }
}

TEST(HalfEdge, ErrorsNameEdgeOrVertexAndNothingIsPrinted) {
    TriMesh mesh = tetrahedron();
    mesh.triangles.conservativeResize(5, 3);
    mesh.triangles.row(4) << 0, 1, 3;
    ::testing::internal::CaptureStderr();
    try {
        build_half_edge_mesh(mesh, "template", Context());
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::invalid_mesh);
        EXPECT_EQ(error.detail_index(), 0);
        EXPECT_NE(std::string(error.what()).find("vertices 0 and 1"), std::string::npos)
            << error.what();
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(HalfEdge, TheOrderOfTrianglesDoesNotMatter) {
    // Order of insertion is where half-edge builders fail: a shuffled grid must build as well.
    TriMesh mesh = grid(30);
    std::mt19937 random(11);
    for (Index t = mesh.triangles.rows() - 1; t > 0; --t) {
        const Index other = static_cast<Index>(random() % static_cast<unsigned>(t + 1));
        mesh.triangles.row(t).swap(mesh.triangles.row(other));
    }
    EXPECT_NO_THROW(build_half_edge_mesh(mesh, "grid", Context()));
}

// A grid of which many triangles are missing: full of vertices where pieces touch.
TriMesh riddled_grid(unsigned seed) {
    TriMesh mesh = grid(30);
    std::mt19937 random(seed);
    Triangles kept(0, 3);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        if (random() % 5 < 2) continue;
        kept.conservativeResize(kept.rows() + 1, 3);
        kept.row(kept.rows() - 1) = mesh.triangles.row(t);
    }
    mesh.triangles = kept;
    return mesh;
}

TEST(Topology, PiecesAcrossEdgesAreThoseThatTheEdgesJoin) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const TriMesh mesh = riddled_grid(seed);
        const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), Context());
        std::vector<std::uint32_t> expected(static_cast<std::size_t>(mesh.triangles.rows()));
        std::iota(expected.begin(), expected.end(), 0u);
        for (bool changed = true; changed;) {  // the lowest triangle of each piece
            changed = false;
            for (std::size_t e = 0; e < table.num_edges(); ++e) {
                if (table.num_sides(e) != 2) continue;
                std::uint32_t& a = expected[table.sides[table.first_side[e]] / 3];
                std::uint32_t& b = expected[table.sides[table.first_side[e] + 1] / 3];
                changed = changed || a != b;
                a = b = std::min(a, b);
            }
        }
        const TriangleFans fans(mesh.vertices.rows(), mesh.triangles, Context());
        ASSERT_TRUE(fans.wound_alike());
        EXPECT_EQ(
            static_cast<Index>(fans.pinched().size()),
            inspect_topology(table, mesh.triangles, mesh.vertices.rows()).num_pinched_vertices);
        EXPECT_GT(fans.pinched().size(), 20u);
        const std::vector<std::uint32_t> pieces = pieces_across_edges(mesh.triangles, fans);
        std::vector<std::uint32_t> first_of;
        for (std::size_t t = 0; t < pieces.size(); ++t) {
            if (pieces[t] == first_of.size()) first_of.push_back(static_cast<std::uint32_t>(t));
            ASSERT_LT(pieces[t], first_of.size());
            EXPECT_EQ(first_of[pieces[t]], expected[t]);
        }
        EXPECT_GT(first_of.size(), 5u);
    }
}

// More triangles around a vertex than are walked around.
TEST(Topology, AManySidedFanIsWoundAlikeUntilOneTurns) {
    constexpr std::uint32_t kSides = 60;
    TriMesh mesh;
    mesh.vertices = Points::Random(kSides + 1, 3);
    mesh.triangles.resize(kSides, 3);
    for (std::uint32_t k = 0; k < kSides; ++k)
        mesh.triangles.row(k) << 0, 1 + k, 1 + (k + 1) % kSides;
    const auto fans = [&] { return TriangleFans(kSides + 1, mesh.triangles, Context()); };
    EXPECT_TRUE(fans().wound_alike());
    EXPECT_EQ(pieces_across_edges(mesh.triangles, fans()), std::vector<std::uint32_t>(kSides, 0));
    std::swap(mesh.triangles(7, 1), mesh.triangles(7, 2));
    EXPECT_FALSE(fans().wound_alike());
}

}  // namespace
