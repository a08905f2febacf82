#include "mesh/cleaning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

void expect_consistent_maps(const TriMesh& raw, const CleanedMesh& cleaned) {
    check_mesh(cleaned.mesh, "cleaned");
    ASSERT_EQ(cleaned.vertex_to_new.size(), static_cast<std::size_t>(raw.vertices.rows()));
    ASSERT_EQ(cleaned.vertex_to_old.size(), static_cast<std::size_t>(cleaned.mesh.vertices.rows()));
    ASSERT_EQ(cleaned.triangle_to_new.size(), static_cast<std::size_t>(raw.triangles.rows()));
    for (std::size_t v = 0; v < cleaned.vertex_to_new.size(); ++v) {
        if (cleaned.vertex_to_new[v] == kDropped) continue;
        EXPECT_EQ(cleaned.mesh.vertices.row(cleaned.vertex_to_new[v]),
                  raw.vertices.row(static_cast<Index>(v)));
    }
    for (std::size_t v = 0; v < cleaned.vertex_to_old.size(); ++v) {
        EXPECT_EQ(cleaned.vertex_to_new[cleaned.vertex_to_old[v]], v);
        EXPECT_TRUE(v == 0 || cleaned.vertex_to_old[v - 1] < cleaned.vertex_to_old[v]);
    }
    for (std::size_t t = 0; t < cleaned.triangle_to_old.size(); ++t)
        EXPECT_EQ(cleaned.triangle_to_new[cleaned.triangle_to_old[t]], t);
}

TEST(Cleaning, ACleanMeshStaysAsItIs) {
    const TriMesh mesh = colorful();
    const CleanedMesh cleaned = clean_mesh(mesh, {}, Context());
    EXPECT_EQ(cleaned.mesh.vertices, mesh.vertices);
    EXPECT_EQ(cleaned.mesh.triangles, mesh.triangles);
    EXPECT_EQ(cleaned.mesh.colors, mesh.colors);
    EXPECT_EQ(cleaned.mesh.texture_triangles, mesh.texture_triangles);
    expect_consistent_maps(mesh, cleaned);
}

TEST(Cleaning, EachFaultIsDroppedAndCounted) {
    TriMesh raw = tetrahedron();
    raw.vertices.conservativeResize(8, 3);
    raw.vertices.row(4) << std::nan(""), 0, 0;
    raw.vertices.row(5) = raw.vertices.row(1);
    raw.vertices.row(6) << 5, 5, 5;
    raw.vertices.row(7) << std::numeric_limits<double>::infinity(), 0, 0;
    raw.triangles = triangles_of({{0, 1, 2},
                                  {0, 4, 1},  // not finite
                                  {0, 3, 5},  // through the double of 1
                                  {1, 3, 2},
                                  {3, 2, 1},  // the same again, turned
                                  {2, 3, 0},
                                  {1, 5, 2},     // degenerate once merged
                                  {0, 0, 1},     // degenerate
                                  {0, 1, 99}});  // out of range
    const CleanedMesh cleaned = clean_mesh(raw, {}, Context());
    EXPECT_EQ(cleaned.mesh.vertices, tetrahedron().vertices);
    EXPECT_EQ(cleaned.mesh.triangles, triangles_of({{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}));
    EXPECT_EQ(cleaned.num_not_finite, 2);
    EXPECT_EQ(cleaned.num_merged, 1);
    EXPECT_EQ(cleaned.num_unused, 1);
    EXPECT_EQ(cleaned.num_bad_index, 2);
    EXPECT_EQ(cleaned.num_degenerate, 2);
    EXPECT_EQ(cleaned.num_duplicate, 1);
    expect_consistent_maps(raw, cleaned);
}

TEST(Cleaning, MergingHealsTheSeamsThatLookLikeBorders) {
    const TriMesh whole = grid(8);
    TriMesh split;  // every triangle with vertices of its own
    split.vertices.resize(3 * whole.triangles.rows(), 3);
    split.triangles.resize(whole.triangles.rows(), 3);
    for (Index t = 0; t < whole.triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            split.vertices.row(3 * t + k) = whole.vertices.row(whole.triangles(t, k));
            split.triangles(t, k) = static_cast<std::uint32_t>(3 * t + k);
        }
    const CleanedMesh cleaned = clean_mesh(split, {}, Context());
    EXPECT_EQ(cleaned.mesh.vertices.rows(), 64);
    const EdgeTable table =
        build_edge_table(cleaned.mesh.triangles, cleaned.mesh.vertices.rows(), Context());
    EXPECT_EQ(border_sides(table).size(), 28u);
    CleaningOptions apart;
    apart.merge_equal_vertices = false;
    EXPECT_EQ(clean_mesh(split, apart, Context()).mesh.vertices.rows(), split.vertices.rows());
}

TEST(Cleaning, SmallPiecesGoOnlyWhenAsked) {
    TriMesh raw = grid(5);
    raw.vertices.conservativeResize(28, 3);
    raw.vertices.bottomRows(3) << 100, 0, 0, 101, 0, 0, 100, 1, 0;
    raw.triangles.conservativeResize(33, 3);
    raw.triangles.row(32) << 25, 26, 27;
    EXPECT_EQ(clean_mesh(raw, {}, Context()).mesh.triangles.rows(), 33);
    CleaningOptions options;
    options.min_component_triangles = 2;
    const CleanedMesh cleaned = clean_mesh(raw, options, Context());
    EXPECT_EQ(cleaned.mesh.triangles.rows(), 32);
    EXPECT_EQ(cleaned.mesh.vertices.rows(), 25);
    EXPECT_EQ(cleaned.num_small_component, 1);
}

TEST(Cleaning, TrianglesWithoutAreaGoOnlyWhenAskedAtAnyScale) {
    for (double scale : {1e-150, 1.0, 1e150}) {
        TriMesh raw = tetrahedron();
        raw.vertices.conservativeResize(5, 3);
        raw.vertices.row(4) = 0.5 * (raw.vertices.row(0) + raw.vertices.row(1));
        raw.vertices *= scale;
        raw.triangles.conservativeResize(5, 3);
        raw.triangles.row(4) << 0, 1, 4;
        EXPECT_EQ(clean_mesh(raw, {}, Context()).mesh.triangles.rows(), 5);
        CleaningOptions options;
        options.drop_zero_area = true;
        EXPECT_EQ(clean_mesh(raw, options, Context()).mesh.triangles.rows(), 4) << scale;
    }
}

TEST(Cleaning, APointCloudKeepsItsPoints) {
    TriMesh raw = tetrahedron();
    raw.triangles.resize(0, 3);
    raw.vertices(2, 2) = std::nan("");
    EXPECT_EQ(clean_mesh(raw, {}, Context()).mesh.vertices.rows(), 3);
}

TEST(Cleaning, NothingLeftIsAnError) {
    TriMesh raw = tetrahedron();
    raw.vertices.col(0).setConstant(std::nan(""));
    EXPECT_THROW(clean_mesh(raw, {}, Context()), Error);
    TriMesh degenerate = tetrahedron();
    degenerate.triangles.setZero();
    EXPECT_THROW(clean_mesh(degenerate, {}, Context()), Error);
    EXPECT_THROW(clean_mesh(TriMesh(), {}, Context()), Error);
}

TEST(Cleaning, CleaningTwiceChangesNothingMore) {
    std::mt19937 random(8);
    for (int round = 0; round < 100; ++round) {
        TriMesh raw;
        raw.vertices.resize(20, 3);
        for (Index i = 0; i < raw.vertices.size(); ++i)
            raw.vertices.data()[i] = random() % 13 == 0 ? std::nan("") : double(random() % 3);
        raw.triangles.resize(60, 3);
        for (Index i = 0; i < raw.triangles.size(); ++i)
            raw.triangles.data()[i] = static_cast<std::uint32_t>(random() % 21);
        const CleanedMesh once = clean_mesh(raw, {}, Context());
        expect_consistent_maps(raw, once);
        const CleanedMesh twice = clean_mesh(once.mesh, {}, Context());
        EXPECT_EQ(twice.mesh.vertices, once.mesh.vertices);
        EXPECT_EQ(twice.mesh.triangles, once.mesh.triangles);
    }
}

TEST(Cleaning, AttributesOfTheWrongLengthAreIgnored) {
    TriMesh raw = colorful();
    raw.colors.conservativeResize(3, 3);
    raw.texture_triangles(0, 0) = 77;
    const CleanedMesh cleaned = clean_mesh(raw, {}, Context());
    EXPECT_EQ(cleaned.mesh.colors.rows(), 0);
    EXPECT_EQ(cleaned.mesh.texture_triangles.rows(), 0);
}

}  // namespace
