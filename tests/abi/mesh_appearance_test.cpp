// Texture coordinates, materials, images, morph targets and the table of formats, through the
// shared library alone.
#include <algorithm>

#include "handles.hpp"

namespace {

using namespace mien_test;

/// The square with a texture per vertex, two materials and an image of 2 x 3 pixels in wider rows.
struct Textured {
    Square square;
    float texture[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    std::uint8_t rows[3][8] = {{1, 2, 3, 4, 5, 6, 99, 99},
                               {7, 8, 9, 10, 11, 12, 99, 99},
                               {13, 14, 15, 16, 17, 18, 99, 99}};
    mien_image image{"skin.png", rows[0], 8, 2, 3, nullptr, 0};
    mien_material materials[2] = {{"face", 0, 0, 1, 1, 1}, {nullptr, -1, 0, 0.5, 0.25, 0}};
    std::uint32_t numbers[2] = {1, 0};
    mien_mesh_arrays arrays() const {
        mien_mesh_arrays a = square.arrays();
        a.texture = texture;
        a.texture_count = 4;
        a.materials = materials;
        a.material_count = 2;
        a.triangle_materials = numbers;
        a.images = &image;
        a.image_count = 1;
        return a;
    }
};

Mesh make(mien_session* session, const mien_mesh_arrays& arrays) {
    mien_mesh* mesh = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, &error)) << error.message;
    return Mesh(mesh, mien_mesh_release);
}

Mesh load(mien_session* session, const std::string& path) {
    mien_mesh* mesh = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_OK, mien_mesh_load(session, path.c_str(), &mesh, &error)) << error.message;
    return Mesh(mesh, mien_mesh_release);
}

std::vector<std::uint8_t> pixels(mien_session* session, const mien_mesh* mesh, uint64_t stride) {
    uint64_t count = 0;
    EXPECT_EQ(MIEN_OK,
              mien_mesh_get_image_pixels(session, mesh, 0, stride, nullptr, 0, &count, nullptr));
    std::vector<std::uint8_t> all(static_cast<std::size_t>(count), 77);
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_OK, mien_mesh_get_image_pixels(session, mesh, 0, stride, all.data(), count,
                                                  &count, &error))
        << error.message;
    return all;
}

TEST(MeshAppearance, ArraysComeBackWithTheImageInAnyRowLength) {
    Session session;
    const Textured textured;
    const Mesh mesh = make(session, textured.arrays());
    float texture[8] = {};
    uint64_t count = 0;
    ASSERT_EQ(MIEN_OK, mien_mesh_get_texture(mesh.get(), texture, 4, &count, nullptr));
    EXPECT_EQ(4u, count);
    EXPECT_TRUE(std::equal(texture, texture + 8, textured.texture));
    uint32_t corners[6] = {};
    ASSERT_EQ(MIEN_OK, mien_mesh_get_texture_triangles(mesh.get(), corners, 2, nullptr, nullptr));
    EXPECT_TRUE(std::equal(corners, corners + 6, textured.square.triangles));
    uint32_t numbers[2] = {};
    ASSERT_EQ(MIEN_OK, mien_mesh_get_triangle_materials(mesh.get(), numbers, 2, nullptr, nullptr));
    EXPECT_EQ(1u, numbers[0]);
    uint64_t materials = 0, images = 0;
    ASSERT_EQ(MIEN_OK, mien_mesh_get_material_counts(mesh.get(), &materials, &images, nullptr));
    EXPECT_EQ(2u, materials);
    EXPECT_EQ(1u, images);
    int32_t image = 7;
    double green = 0;
    ASSERT_EQ(MIEN_OK,
              mien_mesh_get_material(mesh.get(), 1, &image, nullptr, &green, nullptr, nullptr));
    EXPECT_EQ(-1, image);
    EXPECT_EQ(0.25, green);
    char name[16] = "";
    ASSERT_EQ(MIEN_OK, mien_mesh_get_material_name(mesh.get(), 0, name, 16, &count, nullptr));
    EXPECT_STREQ("face", name);
    ASSERT_EQ(MIEN_OK, mien_mesh_get_image_name(mesh.get(), 0, name, 16, nullptr, nullptr));
    EXPECT_STREQ("skin.png", name);
    uint32_t width = 0, height = 0;
    ASSERT_EQ(MIEN_OK, mien_mesh_get_image_size(mesh.get(), 0, &width, &height, nullptr));
    EXPECT_EQ(2u, width);
    EXPECT_EQ(3u, height);
    const std::vector<std::uint8_t> tight = pixels(session, mesh.get(), 0);
    ASSERT_EQ(18u, tight.size());
    for (std::size_t k = 0; k < 18; ++k) EXPECT_EQ(k + 1, tight[k]);
    const std::vector<std::uint8_t> wide = pixels(session, mesh.get(), 10);
    ASSERT_EQ(26u, wide.size());
    EXPECT_EQ(7, wide[10]);
    EXPECT_EQ(77, wide[6]);  // between rows nothing is written
    std::uint8_t few[17];
    EXPECT_EQ(MIEN_E_BUFFER_TOO_SMALL,
              mien_mesh_get_image_pixels(session, mesh.get(), 0, 0, few, 17, &count, nullptr));
}

TEST(MeshAppearance, AFileKeepsImageAndNamesAndItsBytesAreServed) {
    Session session;
    const Textured textured;
    const Mesh mesh = make(session, textured.arrays());
    for (const char* name : {"textured.obj", "textured.glb", "textured.ply"}) {
        const std::string path = temporary_path(name);
        mien_error error = fresh_error();
        const mien_status saved = mien_mesh_save(session, mesh.get(), path.c_str(), &error);
        if (saved == MIEN_E_UNSUPPORTED_OPTION) GTEST_SKIP() << error.message;
        ASSERT_EQ(MIEN_OK, saved) << error.message;
        const Mesh back = load(session, path);
        const std::vector<std::uint8_t> seen = pixels(session, back.get(), 0);
        ASSERT_EQ(18u, seen.size()) << name;
        EXPECT_EQ(18, seen[17]) << name;
        uint64_t size = 0;
        ASSERT_EQ(MIEN_OK, mien_mesh_get_image_file(back.get(), 0, nullptr, 0, &size, nullptr));
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
        ASSERT_EQ(MIEN_OK,
                  mien_mesh_get_image_file(back.get(), 0, bytes.data(), size, &size, nullptr));
        ASSERT_GT(size, 8u);
        EXPECT_EQ(0x89, bytes[0]);
        // The bytes of a file are taken as well, and kept.
        Textured again;
        again.image = {"skin.png", nullptr, 0, 0, 0, bytes.data(), size};
        const Mesh from_bytes = make(session, again.arrays());
        EXPECT_EQ(seen, pixels(session, from_bytes.get(), 0));
    }
}

TEST(MeshAppearance, WhatDoesNotFitIsRefused) {
    Session session;
    for (int fault = 0; fault < 10; ++fault) {
        Textured textured;
        mien_mesh_arrays arrays = textured.arrays();
        if (fault == 0) textured.materials[0].image = 1;
        if (fault == 1) textured.materials[1].red = 1.5;
        if (fault == 2) textured.numbers[0] = 2;
        if (fault == 3) textured.image.width = 0;
        if (fault == 4) textured.image.row_stride_bytes = 5;
        if (fault == 5) textured.image.pixels = nullptr;
        if (fault == 6) arrays.texture_count = 3;
        if (fault == 7) arrays.images = nullptr;
        if (fault == 8) textured.texture[3] = HUGE_VALF;
        if (fault == 9) arrays.material_count = std::uint64_t(1) << 40;
        mien_mesh* mesh = nullptr;
        EXPECT_NE(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr)) << fault;
        EXPECT_EQ(nullptr, mesh);
    }
    const Textured textured;
    const Mesh mesh = make(session, textured.arrays());
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_mesh_get_image_size(mesh.get(), 1, nullptr, nullptr, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_mesh_get_material(mesh.get(), 2, nullptr, nullptr, nullptr, nullptr, nullptr));
}

/// Old hosts know the struct only up to its colours.
TEST(MeshAppearance, TheShorterStructOfTheFirstReleaseStillMakesAMesh) {
    Session session;
    const Square square;
    mien_mesh_arrays arrays = square.arrays();
    arrays.struct_size = offsetof(mien_mesh_arrays, texture);
    arrays.texture_count = 12345;
    const Mesh mesh = make(session, arrays);
    uint64_t count = 7;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_texture(mesh.get(), nullptr, 0, &count, nullptr));
    EXPECT_EQ(0u, count);
}

TEST(MeshAppearance, MorphTargetsGoIntoOneFileAndComeBackByName) {
    Session session;
    const Mesh neutral = make_square(session);
    Square smiling;
    smiling.positions[4] = -0.5f;
    const Mesh smile = make(session, smiling.arrays());
    const mien_mesh* targets[] = {smile.get(), neutral.get()};
    const char* names[] = {"smile", "nothing"};
    const std::string path = temporary_path("targets.glb");
    ASSERT_EQ(MIEN_OK, mien_mesh_save_targets(session, neutral.get(), targets, names, 2,
                                              path.c_str(), nullptr));
    mien_mesh* read = nullptr;
    ASSERT_EQ(MIEN_OK, mien_mesh_load_target(session, path.c_str(), "smile", &read, nullptr));
    double positions[12];
    EXPECT_EQ(MIEN_OK,
              mien_mesh_get_positions(read, MIEN_DTYPE_F64, positions, 4, nullptr, nullptr));
    EXPECT_EQ(-0.5, positions[4]);
    mien_mesh_release(read);
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_NOT_FOUND,
              mien_mesh_load_target(session, path.c_str(), "frown", &read, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "'smile'"));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
              mien_mesh_save_targets(session, neutral.get(), targets, names, 2,
                                     temporary_path("targets.ply").c_str(), nullptr));
}

TEST(MeshAppearance, TheTableOfFormatsNamesWhatIsReadAndWritten) {
    const uint32_t count = mien_mesh_format_count();
    ASSERT_GE(count, 8u);
    int writes_ply = -1, writes_vtp = -1;
    for (uint32_t k = 0; k < count; ++k) {
        const std::string extension = mien_mesh_format_extension(k);
        EXPECT_NE(nullptr, mien_mesh_format_description(k));
        if (extension == "ply") writes_ply = mien_mesh_format_writes(k);
        if (extension == "vtp") writes_vtp = mien_mesh_format_writes(k);
    }
    EXPECT_EQ(1, writes_ply);
    EXPECT_EQ(0, writes_vtp);
    EXPECT_EQ(nullptr, mien_mesh_format_extension(count));
    EXPECT_EQ(0, mien_mesh_format_writes(count));
}

}  // namespace
