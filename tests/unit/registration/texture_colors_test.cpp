// A scan with a texture image shows its photograph where it is hit, not what its few vertices hold.
#include <gtest/gtest.h>

#include <cmath>

#include "registration/intake.hpp"

namespace {

using namespace mien;

/// A square of 100 mm in two triangles, whose image has skin on the left and cloth on the right.
TriMesh textured_square() {
    TriMesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << 0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0;
    mesh.triangles.resize(2, 3);
    mesh.triangles << 0, 1, 2, 0, 2, 3;
    mesh.texture.resize(4, 2);
    mesh.texture << 0, 0, 1, 0, 1, 1, 0, 1;
    mesh.texture_triangles = mesh.triangles;
    mesh.materials.resize(1);
    mesh.materials[0].image = 0;
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 50;
    constexpr int kSkin[] = {220, 160, 130}, kCloth[] = {20, 60, 200};
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x)
            for (int k = 0; k < 3; ++k)
                image->pixels.push_back(static_cast<std::uint8_t>((x < 25 ? kSkin : kCloth)[k]));
    mesh.images.push_back(image);
    return mesh;
}

IntakeSettings in_mm() {
    IntakeSettings settings;
    settings.units = UnitRule::millimetres;
    return settings;
}

SurfaceHit hit_at(const PreparedScan& scan, double x, double y) {
    return scan.surface.tree.closest(Vector3(x, y, 1));
}

TEST(TextureColors, AHitSeesTheImageAndNotTheMeanOfItsCorners) {
    const IntakeSettings settings = in_mm();
    const PreparedScan scan = prepare_scan(textured_square(), settings, Context());
    ASSERT_TRUE(scan.surface.has_colors());
    for (const double x : {10.0, 30.0, 45.0, 55.0, 90.0}) {
        const Vector3 color = x < 50 ? Vector3(220, 160, 130) : Vector3(20, 60, 200);
        const Eigen::Vector2d expected = color_signal(color, settings.signals);
        for (const double y : {20.0, 80.0})
            EXPECT_LT((scan.surface.colors_at(hit_at(scan, x, y)) - expected).norm(), 1e-6)
                << x << " " << y;
    }
}

TEST(TextureColors, SkinWeighsAtTheHitTimesTheHostsWeight) {
    IntakeSettings settings = in_mm();
    settings.skin_weights = true;
    settings.weight_per_vertex = Vector::Constant(4, 0.5);
    const PreparedScan scan = prepare_scan(textured_square(), settings, Context());
    const double skin = skin_weight(Vector3(220, 160, 130), settings.skin);
    const double cloth = skin_weight(Vector3(20, 60, 200), settings.skin);
    ASSERT_GT(skin, 2 * cloth);
    EXPECT_NEAR(scan.surface.weight_at(hit_at(scan, 45, 30)), 0.5 * skin, 1e-9);
    EXPECT_NEAR(scan.surface.weight_at(hit_at(scan, 55, 30)), 0.5 * cloth, 1e-9);
}

TEST(TextureColors, AScanWithoutImagesIsWhatItsVerticesSay) {
    TriMesh mesh = textured_square();
    mesh.images.clear();
    mesh.materials.clear();
    EXPECT_FALSE(prepare_scan(mesh, in_mm(), Context()).surface.has_colors());
    mesh.colors.resize(4, 3);
    mesh.colors << 200, 100, 100, 100, 200, 100, 100, 100, 200, 50, 50, 50;
    const IntakeSettings settings = in_mm();
    const PreparedScan scan = prepare_scan(mesh, settings, Context());
    const ColorSignals at_vertices = color_signals(mesh.colors, settings.signals);
    EXPECT_LT(
        (scan.surface.colors_at(hit_at(scan, 0, 0)) - at_vertices.row(0).transpose().cast<double>())
            .norm(),
        1e-6);
}

}  // namespace
