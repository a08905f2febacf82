// A vertex with thousands of neighbours, which cost the decimater the cube of their number.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "base/error.hpp"
#include "learning/hierarchy.hpp"
#include "mesh/decimation.hpp"

namespace {

using namespace mien;

TriMesh fan(Index size) {
    TriMesh mesh;
    mesh.vertices.resize(size + 2, 3);
    mesh.triangles.resize(size, 3);
    mesh.vertices.row(0).setZero();
    for (Index k = 0; k <= size; ++k) {
        const double angle = 6.0 * static_cast<double>(k) / static_cast<double>(size);
        mesh.vertices.row(k + 1) << 60 * std::cos(angle), 60 * std::sin(angle),
            5 * std::sin(3 * angle);
    }
    for (Index k = 0; k < size; ++k)
        mesh.triangles.row(k) << 0, static_cast<std::uint32_t>(k + 1),
            static_cast<std::uint32_t>(k + 2);
    return mesh;
}

TEST(Fan, IsDecimatedInLittleTimeAndKeepsItsHub) {
    const std::clock_t begin = std::clock();
    const DecimatedMesh coarse = decimate(fan(20000), 5000, {});
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
    EXPECT_EQ(coarse.mesh.vertices.rows(), 5000);
    EXPECT_EQ(coarse.kept.front(), 0u);
}

TEST(Fan, ItsHierarchyEndsSoonAfterACancel) {
    CancelToken token;
    Context context;
    context.cancel = &token;
    token.request();
    try {
        quadric_hierarchy(fan(2000), 2, 4, context);
        ADD_FAILURE() << "was not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::cancelled);
    }
}

}  // namespace
