// Textures, materials and images by the C++ face.
#include <gtest/gtest.h>

#include <mien/mien.hpp>

namespace {

mien::Appearance two_parts() {
    mien::Appearance look;
    look.texture = {{{0.f, 0.f}}, {{1.f, 0.f}}, {{1.f, 1.f}}, {{0.f, 1.f}}, {{0.5f, 0.5f}}};
    look.texture_triangles = {{{0, 1, 4}}, {{4, 2, 3}}};
    look.materials.resize(2);
    look.materials[0].name = "skin";
    look.materials[0].image = 0;
    look.materials[1].color = {{0.5, 0.25, 0.}};
    look.triangle_materials = {1, 0};
    look.images.resize(1);
    look.images[0].name = "skin.png";
    look.images[0].width = 2;
    look.images[0].height = 1;
    look.images[0].pixels = {1, 2, 3, 4, 5, 6};
    return look;
}

mien::Mesh square(const mien::Session& session) {
    return mien::Mesh(session, {{{0, 0, 0}}, {{10, 0, 0}}, {{10, 10, 0}}, {{0, 10, 0}}},
                      {{{0, 1, 2}}, {{0, 2, 3}}},
                      {{{9, 8, 7}}, {{6, 5, 4}}, {{3, 2, 1}}, {{0, 1, 2}}});
}

TEST(CppAppearance, GoesInAndComesOutWhole) {
    const mien::Session session;
    const mien::Appearance given = two_parts();
    const mien::Mesh mesh = mien::with_appearance(session, square(session), given);
    EXPECT_EQ(mesh.positions(), square(session).positions());
    EXPECT_EQ(mesh.colors(), square(session).colors());
    const mien::Appearance look = mien::appearance_of(session, mesh);
    EXPECT_EQ(look.texture, given.texture);
    EXPECT_EQ(look.texture_triangles, given.texture_triangles);
    EXPECT_EQ(look.triangle_materials, given.triangle_materials);
    ASSERT_EQ(look.materials.size(), 2u);
    EXPECT_EQ(look.materials[0].name, "skin");
    EXPECT_EQ(look.materials[0].image, 0);
    EXPECT_EQ(look.materials[1].name, "");
    EXPECT_EQ(look.materials[1].image, -1);
    EXPECT_EQ(look.materials[1].color, given.materials[1].color);
    ASSERT_EQ(look.images.size(), 1u);
    EXPECT_EQ(look.images[0].name, "skin.png");
    EXPECT_TRUE(look.images[0].file.empty());
    EXPECT_EQ(look.images[0].width, 2u);
    EXPECT_EQ(look.images[0].pixels, given.images[0].pixels);
}

TEST(CppAppearance, OfAPlainMeshIsEmpty) {
    const mien::Session session;
    const mien::Appearance look = mien::appearance_of(session, square(session));
    EXPECT_TRUE(look.texture.empty() && look.materials.empty() && look.images.empty());
    const mien::Mesh again = mien::with_appearance(session, square(session), look);
    EXPECT_EQ(again.triangles(), square(session).triangles());
}

TEST(CppAppearance, ThatDoesNotFitIsRefused) {
    const mien::Session session;
    mien::Appearance look = two_parts();
    look.images[0].pixels.pop_back();
    EXPECT_THROW(mien::with_appearance(session, square(session), look), std::invalid_argument);
    look = two_parts();
    look.triangle_materials.pop_back();
    EXPECT_THROW(mien::with_appearance(session, square(session), look), std::invalid_argument);
    look = two_parts();
    look.texture_triangles[1][0] = 5;
    EXPECT_THROW(mien::with_appearance(session, square(session), look), mien::Exception);
    EXPECT_THROW(mien::decode_image(session, square(session), 0), mien::Exception);
}

}  // namespace
