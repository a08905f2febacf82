// Means over the triangles around a vertex, and borders, of surfaces whole and torn.
#include "mesh/triangle_fans.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesh/topology.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;
using Field = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A sheet with holes, three triangles at an edge, one turned over, and a vertex of its own.
TriMesh torn_sheet() {
    TriMesh mesh = face_sheet(12);
    Triangles kept(0, 3);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        if (t % 17 == 3) continue;
        kept.conservativeResize(kept.rows() + 1, 3);
        kept.row(kept.rows() - 1) = mesh.triangles.row(t);
    }
    std::swap(kept(40, 1), kept(40, 2));
    kept.conservativeResize(kept.rows() + 1, 3);
    kept.row(kept.rows() - 1) << kept(60, 0), kept(60, 1), kept(200, 2);
    mesh.triangles = kept;
    mesh.vertices.conservativeResize(mesh.vertices.rows() + 1, 3);
    mesh.vertices.bottomRows(1).setZero();
    return mesh;
}

TEST(TriangleFans, AddUpWhatTheTrianglesAroundAVertexHold) {
    for (const TriMesh& mesh : {face_sheet(12), torn_sheet()}) {
        const Index n = mesh.vertices.rows();
        const TriangleFans fans(n, mesh.triangles, {});
        std::mt19937 random(3);
        Field field(n, 4), sums(n, 4), expected = Field::Zero(n, 4);
        for (Index i = 0; i < field.size(); ++i)
            field.data()[i] = static_cast<float>(random() / 4294967296.0);
        for (Index t = 0; t < mesh.triangles.rows(); ++t)
            for (int k = 0; k < 3; ++k)
                for (int other = 0; other < 3; ++other)
                    expected.row(mesh.triangles(t, k)) += field.row(mesh.triangles(t, other));
        fans.add_up(field, 0, static_cast<std::size_t>(n), sums);
        EXPECT_LT((sums - expected).cwiseAbs().maxCoeff(), 1e-5f);
    }
}

TEST(TriangleFans, KnowTheBorderThatTheEdgesTell) {
    for (const TriMesh& mesh : {face_sheet(12), torn_sheet()}) {
        const Index n = mesh.vertices.rows();
        EXPECT_EQ(TriangleFans(n, mesh.triangles, {}).border({}),
                  border_vertices(mesh.triangles, n, {}));
    }
}

}  // namespace
}  // namespace mien
