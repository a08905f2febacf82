#include "registration/transfer.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

TEST(Transfer, ZonesGoThereAndBack) {
    const TriMesh fitted = face_sheet(30), scan = face_sheet(57);
    const SurfaceTransfer transfer(fitted, scan, {});
    std::vector<std::uint32_t> nose;
    for (Index i = 0; i < fitted.vertices.rows(); ++i)
        if (fitted.vertices.row(i).head<2>().norm() < 30)
            nose.push_back(static_cast<std::uint32_t>(i));
    const auto on_scan = transfer.zone(nose, TransferDirection::to_scan, 5, {});
    ASSERT_FALSE(on_scan.empty());
    for (const std::uint32_t v : on_scan) EXPECT_LT(scan.vertices.row(v).head<2>().norm(), 36);
    const auto back = transfer.zone(on_scan, TransferDirection::to_template, 5, {});
    std::size_t kept = 0;
    for (const std::uint32_t v : nose) kept += std::binary_search(back.begin(), back.end(), v);
    EXPECT_GT(kept, nose.size() * 8 / 10);
}

TEST(Transfer, ContoursLandOnTheScan) {
    const TriMesh fitted = face_sheet(30), scan = face_sheet(57);
    const SurfaceTransfer transfer(fitted, scan, {});
    const Points contour = fitted.vertices.middleRows(31 * 15, 31);
    for (const SurfaceHit& hit : transfer.points(contour, TransferDirection::to_scan, 5, {})) {
        ASSERT_TRUE(hit.valid());
        EXPECT_LT(hit.distance(), 1.5);
    }
    Points far(1, 3);
    far << 0, 0, 500;
    EXPECT_FALSE(transfer.points(far, TransferDirection::to_scan, 5, {})[0].valid());
}

TEST(Transfer, LandmarksAndWrongVerticesAreTold) {
    const TriMesh fitted = face_sheet(10);
    const SurfaceTransfer transfer(fitted, fitted, {});
    EXPECT_EQ(transferred_landmarks_json(transfer, {}, 5, {}),
              "{\"points\":{},\"distances_mm\":{}}");
    EXPECT_NE(transferred_landmarks_json(transfer, {{"a", 3}}, 5, {}).find("\"a\":["),
              std::string::npos);
    EXPECT_THROW(transferred_landmarks_json(transfer, {{"a", 9999}}, 5, {}), Error);
    EXPECT_THROW(transfer.zone({9999}, TransferDirection::to_scan, 5, {}), Error);
}

}  // namespace
}  // namespace mien
