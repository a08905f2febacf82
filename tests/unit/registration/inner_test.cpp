// Walls that no scanner sees, found and carried with the skin.
#include "registration/inner.hpp"

#include <gtest/gtest.h>

#include "unit/registration/pocket.hpp"

namespace {

using namespace mien;

using test::add_plate;
using test::kPlateSide;
using test::middle;
using test::pocket;

TEST(InnerVertices, WallsThatFaceEachOtherAreFoundAndSkinIsNot) {
    const std::vector<std::uint8_t> inner = find_inner_vertices(pocket(), {}, Context());
    EXPECT_TRUE(inner[static_cast<std::size_t>(middle(1))]);
    EXPECT_TRUE(inner[static_cast<std::size_t>(middle(2))]);
    for (int v = 0; v < kPlateSide * kPlateSide; ++v)
        EXPECT_FALSE(inner[static_cast<std::size_t>(v)]) << v;
}

TEST(InnerVertices, AnOpenPlateHasNone) {
    TriMesh mesh;
    mesh.vertices.resize(0, 3);
    mesh.triangles.resize(0, 3);
    add_plate(mesh, 0, true);
    for (const std::uint8_t inner : find_inner_vertices(mesh, {}, Context())) EXPECT_FALSE(inner);
}

TEST(InnerVertices, AScansSlimNoseTakesTheNostrilsSacAlong) {
    const TriMesh mesh = pocket();
    const std::vector<std::uint8_t> inner = find_inner_vertices(mesh, {}, Context());
    const Eigen::RowVector3d shift(-3, 1, 0.5);
    Points places = mesh.vertices;
    for (Index v = 0; v < places.rows(); ++v)
        if (!inner[static_cast<std::size_t>(v)]) places.row(v) += shift;
    const Points before = places;
    carry_inner(mesh, build_rings(mesh.vertices.rows(), mesh.triangles), mesh.vertices, inner, {},
                places, Context());
    for (const int plate : {1, 2})
        EXPECT_LT((places.row(middle(plate)) - mesh.vertices.row(middle(plate)) - shift).norm(),
                  1e-9)
            << plate;
    for (Index v = 0; v < places.rows(); ++v)
        if (!inner[static_cast<std::size_t>(v)]) {
            EXPECT_EQ(places.row(v), before.row(v));
        }
}

// A mouth: two plates whose edges bend towards each other in two walls, 1 mm apart, and that part.
TEST(InnerVertices, TheInsideOfALipGoesWithItsOwnLip) {
    TriMesh mesh;
    mesh.vertices.resize(0, 3);
    mesh.triangles.resize(0, 3);
    add_plate(mesh, 0, true);
    add_plate(mesh, 0, true);
    std::vector<std::uint8_t> inner(static_cast<std::size_t>(mesh.vertices.rows()), 0);
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        const bool upper = v >= kPlateSide * kPlateSide;
        const double along = mesh.vertices(v, 1);  // 0 to 40 mm, the last 8 of them inside
        const double out = std::max(0.0, along - 32);
        mesh.vertices(v, 1) = (upper ? 1 : -1) * (0.5 + 32 - std::min(along, 32.0));
        mesh.vertices(v, 2) = -out;
        inner[static_cast<std::size_t>(v)] = out > 0;
    }
    Points places = mesh.vertices;
    for (Index v = kPlateSide * kPlateSide; v < places.rows(); ++v)
        if (!inner[static_cast<std::size_t>(v)]) places(v, 1) += 10;
    carry_inner(mesh, build_rings(places.rows(), mesh.triangles), mesh.vertices, inner, {}, places,
                Context());
    for (Index v = 0; v < places.rows(); ++v)
        if (mesh.vertices(v, 2) < -3) {
            EXPECT_NEAR(places(v, 1) - mesh.vertices(v, 1), v >= kPlateSide * kPlateSide ? 10 : 0,
                        0.05)
                << v;
        }
}

TEST(InnerVertices, WithoutOpenSkinNothingMoves) {
    const TriMesh mesh = pocket();
    Points places = mesh.vertices.array() + 1.0;
    const Points before = places;
    carry_inner(mesh, build_rings(places.rows(), mesh.triangles), mesh.vertices,
                std::vector<std::uint8_t>(static_cast<std::size_t>(places.rows()), 1), {}, places,
                Context());
    EXPECT_EQ(places, before);
}

}  // namespace
