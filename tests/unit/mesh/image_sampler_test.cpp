#include "mesh/image_sampler.hpp"

#include <gtest/gtest.h>

#include "unit/mesh/sample_images.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

/// A square of 10 mm that shows a whole image of 4 x 2 pixels.
TriMesh square() {
    TriMesh mesh;
    mesh.vertices = points_of({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
    mesh.triangles = triangles_of({{0, 1, 2}, {0, 2, 3}});
    mesh.texture.resize(4, 2);
    mesh.texture << 0, 0, 1, 0, 1, 1, 0, 1;
    mesh.texture_triangles = mesh.triangles;
    auto image = std::make_shared<TextureImage>();
    image->width = 4;
    image->height = 2;
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            for (int value : {60 * x, 100 * y, 7}) image->pixels.push_back(std::uint8_t(value));
    mesh.images.push_back(image);
    mesh.materials.resize(1);
    mesh.materials[0].image = 0;
    return mesh;
}

TEST(ImageSampler, IsLinearBetweenPixelCentresWithTheFirstRowOnTop) {
    const ImageSampler sampler(square(), Context());
    ASSERT_TRUE(sampler.covers(0));
    EXPECT_FALSE(sampler.covers(2));
    // Triangle 0 has (u, v) = (b1 + b2, b2).
    const auto at = [&](double u, double v) { return sampler.color(0, Vector3(1 - u, u - v, v)); };
    EXPECT_LT((at(0.125, 0.25) - Vector3(0, 100, 7)).norm(), 1e-4);
    EXPECT_LT((at(0.875, 0.75) - Vector3(180, 0, 7)).norm(), 1e-4);
    EXPECT_LT((at(0.5, 0.5) - Vector3(90, 50, 7)).norm(), 1e-4);
    EXPECT_LT((at(0.375, 0.3) - Vector3(60, 90, 7)).norm(), 1e-4);
    // Half a pixel beyond the side comes in again from the other one.
    EXPECT_LT((at(1.0, 0.25) - Vector3(90, 100, 7)).norm(), 1e-4);
    EXPECT_LT((at(3.125, 0.25) - Vector3(0, 100, 7)).norm(), 1e-4);
}

TEST(ImageSampler, ADiscAveragesAndStaysWithinItsTriangle) {
    TriMesh mesh = square();
    const ImageSampler sampler(mesh, Context());
    const Vector3 middle(0.45, 0.1, 0.45);
    // Where the image is linear the mean of a disc is its middle.
    EXPECT_LT((sampler.color(0, middle, 0.3) - sampler.color(0, middle)).norm(), 1e-3);
    // Beyond the diagonal a chart of another colour: not seen, however wide the disc.
    mesh.texture.conservativeResize(8, 2);
    mesh.texture.bottomRows(4) << 0.99f, 0.99f, 0.99f, 0.99f, 0.99f, 0.99f, 0.99f, 0.99f;
    mesh.texture.topRows(4) << 0.13f, 0.3f, 0.14f, 0.3f, 0.14f, 0.31f, 0.13f, 0.31f;
    mesh.texture_triangles.row(1) << 4, 5, 6;
    const ImageSampler charts(mesh, Context());
    EXPECT_LT((charts.color(0, Vector3(0.5, 0, 0.5), 30.0) - Vector3(1.5, 89, 7)).norm(), 4.0);
}

TEST(ImageSampler, ColoursOfMaterialsTintAndTrianglesWithoutAnImageAreNotCovered) {
    TriMesh mesh = square();
    mesh.materials.resize(2);
    mesh.materials[0].color = {{0.5f, 1.f, 0.f}};
    mesh.triangle_materials = {0, 1};
    const ImageSampler sampler(mesh, Context());
    EXPECT_FALSE(sampler.covers(1));
    EXPECT_LT((sampler.color(0, Vector3(0.5, 0, 0.5)) - Vector3(45, 50, 0)).norm(), 1e-4);
    const Colors colors = sampler.vertex_colors(mesh, 0.0);
    EXPECT_EQ(colors(3, 0), 128);  // only of the triangle without an image
    mesh.colors = Colors::Constant(4, 3, 9);
    EXPECT_EQ(sampler.vertex_colors(mesh, 0.0)(3, 2), 9);
}

TEST(ImageSampler, AnImageThatCannotBeDecodedIsAWarning) {
    TriMesh mesh = square();
    auto broken = std::make_shared<TextureImage>();
    broken->name = "face.tif";
    broken->encoded = "II*";
    mesh.images[0] = broken;
    std::string log;
    Context context;
    context.log_function = [](void* user, std::int32_t, const char* message) {
        *static_cast<std::string*>(user) += message;
    };
    context.log_user = &log;
    EXPECT_TRUE(ImageSampler(mesh, context).empty());
    EXPECT_NE(log.find("face.tif"), std::string::npos);
    EXPECT_TRUE(ImageSampler(tetrahedron(), context).empty());
}

}  // namespace
