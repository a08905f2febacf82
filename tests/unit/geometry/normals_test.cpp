#include "geometry/normals.hpp"

#include <gtest/gtest.h>

#include "unit/measure/shapes.hpp"

namespace mien {
namespace {

TEST(Normals, TriangleNormalHasTwiceTheArea) {
    const TriMesh mesh = test::grid(4, 3, 1, 1);
    const Points normals = triangle_normals(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(normals(0, 2), 12.0, 1e-13);
    EXPECT_NEAR(normals.leftCols(2).norm(), 0.0, 1e-13);
}

TEST(Normals, SphereNormalsPointOutwards) {
    const TriMesh mesh = test::sphere(7.0, 3);
    const Points normals = vertex_normals(mesh.vertices, mesh.triangles);
    for (Index v = 0; v < normals.rows(); ++v)
        EXPECT_GT(normals.row(v).dot(mesh.vertices.row(v)) / 7.0, 0.995);
}

TEST(Normals, VerticesWithoutAreaGetZero) {
    TriMesh mesh = test::grid(1, 1, 1, 1);
    mesh.vertices.conservativeResize(5, 3);
    mesh.vertices.row(4).setZero();
    const Points normals = vertex_normals(mesh.vertices, mesh.triangles);
    EXPECT_EQ(normals.row(4).norm(), 0.0);
    EXPECT_NEAR(normals.row(0).norm(), 1.0, 1e-14);
}

}  // namespace
}  // namespace mien
