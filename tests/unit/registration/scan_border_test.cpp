// A vertex with as many triangles as the scan: borders were found in the square of their number.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "registration/scan_surface.hpp"

namespace {

using namespace mien;

TEST(ScanBorder, OfAFanIsItsRimInLittleTime) {
    constexpr Index kSize = 60000;
    TriMesh mesh;
    mesh.vertices.resize(kSize + 1, 3);
    mesh.triangles.resize(kSize, 3);
    mesh.vertices.row(0).setZero();
    for (Index k = 0; k < kSize; ++k) {
        const double angle = 2 * 3.14159265358979 * static_cast<double>(k) / kSize;
        mesh.vertices.row(k + 1) << 60 * std::cos(angle), 60 * std::sin(angle), 0;
        mesh.triangles.row(k) << 0, static_cast<std::uint32_t>(k + 1),
            static_cast<std::uint32_t>((k + 1) % kSize + 1);
    }
    ScanSurfaceSettings settings;
    settings.smoothing_mm = 0;  // borders alone
    const std::clock_t begin = std::clock();
    const ScanSurface scan = build_scan_surface(mesh, settings, {});
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 3);
    EXPECT_EQ(scan.on_border[0], 0);
    for (Index k = 1; k <= kSize; ++k) ASSERT_EQ(scan.on_border[static_cast<std::size_t>(k)], 1);
}

}  // namespace
