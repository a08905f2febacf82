// OBJ, STL and OFF as the world writes them.
#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

constexpr const char* kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, EveryFormOfCorner) {
    const std::string extras = "vt 0 0\nvt 1 0 0\nvt 1\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f -4 -3 -2",
          "f -4/-3 -3/-2 -2/-1", "f\t1  2 3 # comment", "f 1 2 \\\n 3", "f 1 2 3\r", "f +1 2 3"}) {
        const TriMesh mesh = parse_mesh(kPoints + extras + face + "\n", "obj");
        EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}})) << face;
        const bool textured =
            std::strstr(face, "/1") != nullptr && std::strstr(face, "//") == nullptr;
        if (textured) {
            ASSERT_EQ(mesh.texture_triangles, triangles_of({{0, 1, 2}})) << face;
            EXPECT_EQ(mesh.texture(1, 0), 1.0f);
        }
    }
}

TEST(Obj, PolygonsFanGroupsAndLinesAreSteppedOver) {
    const TriMesh mesh =
        parse_mesh(std::string("# head\nmtllib a.mtl\no face\ng a b\ns 1\n") + kPoints +
                       "usemtl C:\\\nl 1 2\np 1\nf 1 2 3 4\nf 1 2\nfo 1 2 3\n",
                   "obj");
    // The last one is written as old files write a face.
    ASSERT_EQ(mesh.triangles.rows(), 3);
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
}

TEST(Obj, ColoursFollowThePositionAndAWeightIsNoColour) {
    const TriMesh unit = parse_mesh("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\n", "obj");
    EXPECT_EQ(unit.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 128, 0)));
    const TriMesh bytes = parse_mesh("v 0 0 0 255 128 0 255\nv 1 0 0\n", "obj");
    EXPECT_EQ(bytes.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 128, 0)));
    EXPECT_EQ(bytes.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 0, 0)));
    EXPECT_EQ(parse_mesh("v 0 0 0 1.0\n", "obj").colors.rows(), 0);
}

TEST(Obj, FacesPartlyWithoutTextureShareOneSpareCoordinate) {
    const TriMesh mesh =
        parse_mesh(std::string(kPoints) + "vt .5 .5\nf 1 2 3\nf 1/1 3/1 4/1\nf 1 2 4\n", "obj");
    EXPECT_EQ(mesh.texture_triangles, triangles_of({{1, 1, 1}, {0, 0, 0}, {1, 1, 1}}));
    EXPECT_EQ(mesh.texture.rows(), 2);
}

TEST(Obj, BrokenLinesAreNamed) {
    for (const char* line :
         {"f 0 1 2", "f 1 2 x", "f 1 2 3.5", "f -9 1 2", "v 1 2", "v a b c", "vt x", "f 1/x 2 3",
          "f 99999999999999999999 1 2", "f 1 2 4294967297"}) {
        try {
            parse_mesh(std::string(kPoints) + line + "\n", "obj");
            ADD_FAILURE() << line;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::bad_format) << line;
            EXPECT_NE(std::string(error.what()).find("line 5"), std::string::npos) << error.what();
        }
    }
    EXPECT_EQ(parse_status(std::string(kPoints) + "f 1 2 5\n", "obj"), Status::invalid_mesh);
    EXPECT_EQ(parse_status("nothing here\n", "obj"), Status::bad_format);
    EXPECT_EQ(parse_status("v nan 0 0\n", "obj"), Status::invalid_mesh);
}

std::string binary_stl(const char* head, std::uint32_t promised, std::uint32_t written) {
    std::string file = head;
    file.resize(80, ' ');
    file.append(reinterpret_cast<const char*>(&promised), 4);
    for (std::uint32_t t = 0; t < written; ++t) {
        const float values[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, float(t), 1, 0};
        file.append(reinterpret_cast<const char*>(values), 48);
        file.append(2, '\0');
    }
    return file;
}

TEST(Stl, ABinaryFileMayBeginWithSolid) {
    const TriMesh mesh = parse_mesh(binary_stl("solid exported", 2, 2), "stl");
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 1, 3}}));
    EXPECT_EQ(mesh.vertices.rows(), 4);
    EXPECT_EQ(parse_mesh(binary_stl("solid exported", 2, 2) + "tail", "stl").triangles.rows(), 2);
}

TEST(Stl, PromisesAreHeldAgainstTheSize) {
    EXPECT_EQ(parse_status(binary_stl("x", 3, 2), "stl"), Status::bad_format);
    EXPECT_EQ(parse_status(binary_stl("x", 0xffffffffu, 2), "stl"), Status::bad_format);
    EXPECT_EQ(parse_status(binary_stl("x", 0, 0), "stl"), Status::invalid_mesh);
    EXPECT_EQ(parse_status("x", "stl"), Status::bad_format);
}

constexpr const char* kAscii =
    "solid a name of words\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n"
    "   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n endfacet\n FACET NORMAL 0 0 nan\n"
    "  OUTER LOOP\n   VERTEX 1 0 0\n   VERTEX 1 1 0\n   VERTEX -0 1e0 0\n  ENDLOOP\n ENDFACET\n"
    "endsolid a\n";

TEST(Stl, AsciiIsReadInAnyCaseAndWelded) {
    const TriMesh mesh = parse_mesh(kAscii, "stl");
    EXPECT_EQ(mesh.vertices.rows(), 4);
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {1, 3, 2}}));
}

TEST(Stl, BrokenAsciiIsRefused) {
    const std::string good = kAscii;
    for (const char* word : {"vertex 1 0 0\n", "endsolid a\n", "  endloop\n"}) {
        std::string text = good;
        text.erase(text.find(word), std::strlen(word));
        EXPECT_EQ(parse_status(text, "stl"), Status::bad_format) << word;
    }
    EXPECT_EQ(parse_status("solid x\nnonsense\nendsolid\n", "stl"), Status::bad_format);
    EXPECT_EQ(parse_status("solid x\nvertex 0 0 0\nendsolid\n", "stl"), Status::bad_format);
}

TEST(Off, CommentsMissingEdgesAndFaceColours) {
    for (const char* text :
         {"OFF\n# comment\n4 2 0\n0 0 0\n1 0 0 # x\n1 1 0\n\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n",
          "OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 0.5 0.5 0.5\n3 0 1 2",
          "OFF4 2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n"}) {
        const TriMesh mesh = parse_mesh(text, "off");
        EXPECT_EQ(mesh.vertices.rows(), 4);
        EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}})) << text;
    }
}

TEST(Off, ColoursNormalsAndTexture) {
    const TriMesh mesh = parse_mesh(
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 10 255 .5 .25\n1 0 0 0 0 1 1 2 3 255 1 0\n"
        "0 1 0 0 0 1 4 5 6 255 0 1\n3 0 1 2\n",
        "off");
    EXPECT_EQ(mesh.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 0, 10)));
    EXPECT_EQ(mesh.texture(0, 1), 0.25f);
    EXPECT_EQ(mesh.texture_triangles, mesh.triangles);
}

TEST(Off, BinaryIsBigEndian) {
    std::string file = "COFF BINARY\n";
    auto put = [&](std::uint32_t bits) {
        for (int shift = 24; shift >= 0; shift -= 8) file += static_cast<char>(bits >> shift);
    };
    auto put_float = [&](float value) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, 4);
        put(bits);
    };
    put(3);
    put(1);
    put(0);
    for (int v = 0; v < 3; ++v) {
        put_float(float(v == 1));
        put_float(float(v == 2));
        put_float(-2.5f);
        for (int k = 0; k < 4; ++k) put_float(0.2f * float(k));
    }
    put(3);
    for (std::uint32_t k = 0; k < 3; ++k) put(k);
    put(0);
    const TriMesh mesh = parse_mesh(file, "off");
    EXPECT_EQ(mesh.vertices(1, 0), 1.0);
    EXPECT_EQ(mesh.vertices(2, 2), -2.5);
    EXPECT_EQ(mesh.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 51, 102)));
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}}));
    // Without the last word, the empty colour of its only face, the file is whole for those who
    // leave that word out.
    EXPECT_EQ(parse_mesh(file.substr(0, file.size() - 4), "off").triangles, mesh.triangles);
    for (std::size_t size = 0; size < file.size(); ++size)
        if (size + 4 != file.size()) {
            EXPECT_NE(parse_status(file.substr(0, size), "off"), Status::ok) << size;
        }
}

TEST(Off, BrokenFilesAreRefused) {
    for (const char* text :
         {"FOO\n1 0 0\n0 0 0\n", "OFF\n", "OFF\n-1 0 0\n", "OFF\n1 x 0\n", "OFF\n2 0 0\n0 0 0\n",
          "OFF\n1 0 0\n0 0\n", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "OFF\n1 1 0\n0 0 0\n3 0 0\n",
          "OFF\n1 1 0\n0 0 0\n-3 0 0 0\n", "OFF\n9223372036854775807 0 0\n0 0 0\n",
          "OFF\n1 9223372036854775807 0\n0 0 0\n", "OFF\n1 1 0\n0 0 0\n9223372036854775807 0\n",
          "4OFF\n1 0 0\n0 0 0 0\n", "COFF\n1 0 0\n0 0 0 1\n"})
        EXPECT_EQ(parse_status(text, "off"), Status::bad_format) << text;
}

}  // namespace
