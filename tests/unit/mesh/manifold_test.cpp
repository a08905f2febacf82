// Soups become manifolds without losing what fits.
#include "mesh/manifold.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/decimation.hpp"
#include "mesh/topology.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

bool is_manifold(const TriMesh& mesh) {
    const EdgeTable table = build_edge_table(mesh.triangles, mesh.vertices.rows(), Context());
    return inspect_topology(table, mesh.triangles, mesh.vertices.rows()).is_oriented_manifold();
}

TEST(Manifold, AManifoldStaysAsItIs) {
    const TriMesh mesh = grid(5);
    const ManifoldMesh same = make_manifold(mesh, Context());
    EXPECT_EQ(same.num_split, 0);
    EXPECT_EQ(same.num_dropped, 0);
    EXPECT_EQ(same.mesh.triangles.rows(), mesh.triangles.rows());
}

TEST(Manifold, FansThatTouchInAVertexGetOneEach) {
    TriMesh mesh;
    mesh.vertices = points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}});
    mesh.triangles = triangles_of({{0, 1, 2}, {0, 3, 4}});
    EXPECT_FALSE(is_manifold(mesh));
    const ManifoldMesh split = make_manifold(mesh, Context());
    EXPECT_TRUE(is_manifold(split.mesh));
    EXPECT_EQ(split.num_split, 1);
    EXPECT_EQ(split.mesh.triangles.rows(), 2);
    for (Index v = 0; v < split.mesh.vertices.rows(); ++v)
        EXPECT_EQ(split.mesh.vertices.row(v),
                  mesh.vertices.row(split.vertex_to_old[static_cast<std::size_t>(v)]));
}

TEST(Manifold, EdgesOfThreeTrianglesAndTurnedOnesComeApart) {
    TriMesh mesh;
    mesh.vertices = points_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}});
    mesh.triangles = triangles_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    const ManifoldMesh split = make_manifold(mesh, Context());
    EXPECT_TRUE(is_manifold(split.mesh));
    EXPECT_EQ(split.mesh.triangles.rows(), 3);
    TriMesh turned = grid(4);
    std::swap(turned.triangles(6, 1), turned.triangles(6, 2));
    EXPECT_TRUE(is_manifold(make_manifold(turned, Context()).mesh));
}

TEST(Manifold, APinchedScanCanBeDecimated) {
    TriMesh mesh = grid(10);
    // Two more triangles hang on an inner vertex alone.
    const Index n = mesh.vertices.rows(), f = mesh.triangles.rows();
    mesh.vertices.conservativeResize(n + 2, 3);
    mesh.vertices.row(n) << 4, 4, 3;
    mesh.vertices.row(n + 1) << 5, 4, 3;
    mesh.triangles.conservativeResize(f + 1, 3);
    mesh.triangles.row(f) << 44, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n + 1);
    EXPECT_THROW(decimate(mesh, 30, Context()), Error);
    EXPECT_LE(decimate(make_manifold(mesh, Context()).mesh, 30, Context()).mesh.vertices.rows(),
              40);
}

TEST(Manifold, NothingButDegenerateTrianglesIsRefused) {
    TriMesh mesh = grid(2);
    mesh.triangles = triangles_of({{0, 0, 1}});
    EXPECT_THROW(make_manifold(mesh, Context()), Error);
}

}  // namespace
