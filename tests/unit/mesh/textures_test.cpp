// Texture coordinates, materials and images from load to save, in every format that has them.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/gltf.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/sample_images.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

/// A tetrahedron whose triangles have two materials with an image each, and one with a colour
/// alone.
TriMesh textured() {
    TriMesh mesh = colorful();
    mesh.colors.resize(0, 3);
    for (const char* name : {"left cheek.png", "right.jpg"}) {
        auto image = std::make_shared<TextureImage>();
        image->name = name;
        image->encoded = name[0] == 'l' ? sample_png(5, 3) : sample_jpeg();
        mesh.images.push_back(image);
    }
    mesh.materials.resize(3);
    mesh.materials[0].name = "skin left";
    mesh.materials[0].image = 0;
    mesh.materials[1].name = "skin_right";
    mesh.materials[1].image = 1;
    mesh.materials[2].name = "cap";
    mesh.materials[2].color = {{0.25f, 0.5f, 0.75f}};
    mesh.triangle_materials = {0, 1, 2, 1};
    return mesh;
}

/// By content: triangles may come in another order, sorted by material.
void expect_same_appearance(const TriMesh& a, const TriMesh& b, const std::string& what,
                            bool named = true) {
    ASSERT_EQ(a.vertices, b.vertices) << what;
    ASSERT_EQ(a.triangles.rows(), b.triangles.rows()) << what;
    ASSERT_EQ(a.texture_triangles.rows(), b.texture_triangles.rows()) << what;
    auto material = [](const TriMesh& mesh, Index t) {
        return mesh.materials.at(mesh.triangle_materials.empty()
                                     ? 0
                                     : mesh.triangle_materials[static_cast<std::size_t>(t)]);
    };
    for (Index t = 0; t < a.triangles.rows(); ++t) {
        Index s = 0;
        while (s < b.triangles.rows() && b.triangles.row(s) != a.triangles.row(t)) ++s;
        ASSERT_LT(s, b.triangles.rows()) << what;
        for (int k = 0; k < 3; ++k)
            EXPECT_LT((a.texture.row(a.texture_triangles(t, k)) -
                       b.texture.row(b.texture_triangles(s, k)))
                          .norm(),
                      1e-7f)
                << what;
        const Material left = material(a, t), right = material(b, s);
        if (named) {
            EXPECT_EQ(left.name, right.name) << what;
            EXPECT_EQ(left.color, right.color) << what;
        }
        ASSERT_EQ(left.image < 0, right.image < 0) << what;
        if (left.image >= 0) {
            const TextureImage& first = *a.images.at(static_cast<std::size_t>(left.image));
            const TextureImage& second = *b.images.at(static_cast<std::size_t>(right.image));
            EXPECT_EQ(first.encoded, second.encoded) << what;
            EXPECT_EQ(first.name, second.name) << what;
        }
    }
}

TEST(Textures, ImagesMaterialsAndCoordinatesComeBackFromEveryFormatThatHasThem) {
    ScratchFolder folder;
    const TriMesh mesh = textured();
    for (const char* name : {"m.obj", "m.glb", "m.ply"}) {
        write_mesh_file(folder / name, mesh, Context());
        const TriMesh back = read_mesh_file(folder / name, Context());
        expect_same_appearance(mesh, back, name, name[2] != 'p');
        // Written again elsewhere, from what was read.
        ScratchFolder other;
        write_mesh_file(other / name, back, Context());
        expect_same_appearance(mesh, read_mesh_file(other / name, Context()), name, name[2] != 'p');
    }
    EXPECT_EQ(read_bytes(folder / "right.jpg"), mesh.images[1]->encoded);
}

TEST(Textures, CleaningKeepsThemWithTheTrianglesThatStay) {
    TriMesh mesh = textured();
    mesh.triangles.row(0) << 1, 1, 2;
    const TriMesh cleaned = clean_mesh(mesh, {}, Context()).mesh;
    check_mesh(cleaned, "cleaned");
    EXPECT_EQ(cleaned.triangle_materials, (std::vector<std::uint32_t>{1, 2, 1}));
    EXPECT_EQ(cleaned.images, mesh.images);
    mesh.triangle_materials = {0, 1, 9, 1};
    EXPECT_TRUE(clean_mesh(mesh, {}, Context()).mesh.materials.empty());
}

TEST(Textures, AnotherImageOfTheSameNameIsNotOverwritten) {
    ScratchFolder folder;
    write_bytes(folder / "right.jpg", "someone's");
    const TriMesh mesh = textured();
    write_mesh_file(folder / "m.obj", mesh, Context());
    EXPECT_EQ(read_bytes(folder / "right.jpg"), "someone's");
    EXPECT_EQ(read_bytes(folder / "m_right.jpg"), mesh.images[1]->encoded);
    const TriMesh back = read_mesh_file(folder / "m.obj", Context());
    EXPECT_EQ(back.images.at(1)->encoded, mesh.images[1]->encoded);
    // Again over itself, and two images of one name.
    write_mesh_file(folder / "m.obj", mesh, Context());
    TriMesh twins = mesh;
    auto twin = std::make_shared<TextureImage>(*mesh.images[0]);
    twin->name = "RIGHT.jpg.png";
    twins.images[0] = twin;
    auto same = std::make_shared<TextureImage>(*mesh.images[0]);
    same->name = "RIGHT.jpg.png";
    same->encoded = sample_png(2, 2);
    twins.images.push_back(same);
    twins.materials[2].image = 2;
    write_mesh_file(folder / "m.obj", twins, Context());
    const TriMesh again = read_mesh_file(folder / "m.obj", Context());
    ASSERT_EQ(again.images.size(), 3u);
    EXPECT_EQ(again.images[2]->encoded, same->encoded);
}

TEST(Textures, PixelsOfAHostBecomeAPngWithTheSamePixels) {
    if (!images_are_decoded()) GTEST_SKIP() << "built without image decoders";
    ScratchFolder folder;
    TriMesh mesh = textured();
    auto image = std::make_shared<TextureImage>();
    image->name = "photo.bmp";
    image->width = 3;
    image->height = 2;
    for (int k = 0; k < 18; ++k) image->pixels.push_back(static_cast<std::uint8_t>(14 * k));
    mesh.images[0] = image;
    for (const char* name : {"m.obj", "m.glb", "m.ply"}) {
        write_mesh_file(folder / name, mesh, Context());
        const TriMesh back = read_mesh_file(folder / name, Context());
        const Image decoded = decode_image(*back.images.at(0), Context());
        EXPECT_EQ(decoded.rgb, image->pixels) << name;
        EXPECT_EQ(decoded.width, 3) << name;
    }
}

TEST(Textures, AMissingImageOrLibraryIsAWarningAndTheMeshIsRead) {
    ScratchFolder folder;
    std::vector<std::string> log;
    Context context;
    context.log_function = [](void* user, std::int32_t, const char* message) {
        static_cast<std::vector<std::string>*>(user)->push_back(message);
    };
    context.log_user = &log;
    const std::string text =
        "mtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a b\nf 1/1 2/1 3/1\n";
    write_bytes(folder / "m.obj", text);
    TriMesh mesh = read_mesh_file(folder / "m.obj", context);
    EXPECT_EQ(mesh.materials.at(0).name, "a b");
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("missing.mtl"), std::string::npos);
    write_bytes(folder / "missing.mtl", "newmtl a b\nKd 1 0 0\nmap_Kd gone.png\n");
    log.clear();
    mesh = read_mesh_file(folder / "m.obj", context);
    EXPECT_EQ(mesh.materials.at(0).image, -1);
    EXPECT_EQ(mesh.materials.at(0).color, (std::array<float, 3>{{1.f, 0.f, 0.f}}));
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("gone.png"), std::string::npos);
}

TEST(Textures, NamesWithBlanksFoldersAndAnotherMachinesPathsAreFoundBesideTheMesh) {
    ScratchFolder folder;
    std::filesystem::create_directory(std::filesystem::u8path(folder / "maps"));
    write_bytes(folder / "maps/skin of a face.png", sample_png(4, 4));
    write_bytes(folder / "skin.png", sample_png(4, 4));
    write_bytes(folder / "m.obj",
                "mtllib my library.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl s\nf 1/1 2/1 "
                "3/1\n");
    for (const char* line :
         {"map_Kd maps/skin of a face.png",
          "map_Kd -s 2 2 2 -o 0 0 -clamp on maps\\skin of a face.png",
          "map_kd C:\\Users\\Nurse\\Desktop\\skin.png", "map_Kd /home/x/skin.png",
          "map_Kd \"skin.png\"", "\tmap_Kd   skin.png  \r"}) {
        write_bytes(folder / "my library.mtl", std::string("newmtl s\n") + line + "\n");
        const TriMesh mesh = read_mesh_file(folder / "m.obj", Context());
        ASSERT_EQ(mesh.images.size(), 1u) << line;
        EXPECT_EQ(mesh.materials.at(0).image, 0) << line;
    }
    // What lies outside of the mesh's folder is not read, whatever the file says.
    write_bytes(folder / "maps/m.obj",
                "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl s\nf 1/1 2/1 3/1\n");
    write_bytes(folder / "maps/m.mtl", "newmtl s\nmap_Kd ../skin.png\n");
    EXPECT_TRUE(read_mesh_file(folder / "maps/m.obj", Context()).images.empty());
}

TEST(Textures, MaterialsThatDoNotFitTheMeshAreRefused) {
    const TriMesh good = textured();
    check_mesh(good, "good");
    for (int fault = 0; fault < 5; ++fault) {
        TriMesh bad = good;
        if (fault == 0) bad.triangle_materials = {0, 1, 3, 0};
        if (fault == 1) bad.triangle_materials = {0, 1};
        if (fault == 2) bad.materials[0].image = 2;
        if (fault == 3) bad.images[0] = nullptr;
        if (fault == 4) {
            auto image = std::make_shared<TextureImage>();
            image->width = image->height = 2;
            image->pixels.resize(11);
            bad.images[0] = image;
        }
        EXPECT_THROW(check_mesh(bad, "bad"), Error) << fault;
    }
}

TEST(Images, AreDecodedWithTheirSizes) {
    if (!images_are_decoded()) GTEST_SKIP() << "built without image decoders";
    TextureImage image;
    image.encoded = sample_png(5, 3);
    Image decoded = decode_image(image, Context());
    EXPECT_EQ(decoded.width, 5);
    EXPECT_EQ(decoded.height, 3);
    EXPECT_EQ(decoded.rgb, sample_pixels(5, 3));
    image.encoded = sample_jpeg();
    EXPECT_EQ(size_of_image(image).width, 16);
    decoded = decode_image(image, Context());
    const std::vector<std::uint8_t> original = sample_pixels(16, 8);
    ASSERT_EQ(decoded.rgb.size(), original.size());
    for (std::size_t k = 0; k < original.size(); ++k)
        EXPECT_NEAR(decoded.rgb[k], original[k], 40) << k;
    image.encoded = "II*\0 a TIFF";
    EXPECT_EQ(kind_of_image(image), ImageKind::other);
    EXPECT_THROW(decode_image(image, Context()), Error);
}

TEST(Images, EveryTruncatedLengthIsATypedErrorAndNoForgedSizeAllocates) {
    if (!images_are_decoded()) GTEST_SKIP() << "built without image decoders";
    for (const std::string& whole : {sample_png(5, 3), sample_jpeg(), sample_progressive_jpeg()}) {
        TextureImage sound;
        sound.encoded = whole;
        const std::vector<std::uint8_t> pixels = decode_image(sound, Context()).rgb;
        for (std::size_t size = 1; size < whole.size(); ++size) {
            TextureImage image;
            image.encoded = whole.substr(0, size);
            try {
                const Image decoded = decode_image(image, Context());
                // What follows the last pixel, as a PNG's end, says nothing of them.
                EXPECT_EQ(decoded.rgb, pixels) << size;
            } catch (const Error& error) {
                EXPECT_NE(error.status(), Status::internal) << error.what();
            }
        }
    }
    TextureImage forged;
    forged.encoded = sample_png(5, 3);
    for (int k = 16; k < 24; ++k) forged.encoded[static_cast<std::size_t>(k)] = '\x7f';
    EXPECT_THROW(decode_image(forged, Context()), Error);
    forged.encoded = sample_jpeg();
    const std::size_t frame = forged.encoded.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    for (std::size_t k = frame + 5; k < frame + 9; ++k) forged.encoded[k] = '\x7f';
    EXPECT_THROW(decode_image(forged, Context()), Error);
}

}  // namespace
