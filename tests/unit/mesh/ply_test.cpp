#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "base/error.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

template <typename T>
void put(std::string& out, T value, bool big_endian) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian) std::reverse(raw, raw + sizeof raw);
    out.append(raw, sizeof raw);
}

constexpr const char* kSquare =
    "ply\nformat ascii 1.0\ncomment made by hand\nobj_info nothing\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

TEST(Ply, APolygonBecomesAFan) {
    const TriMesh mesh = parse_mesh(kSquare, "ply");
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}}));
}

TEST(Ply, WindowsLineEndsAreRead) {
    std::string text;
    for (const char* c = kSquare; *c != '\0'; ++c) text += *c == '\n' ? "\r\n" : std::string(1, *c);
    EXPECT_EQ(parse_mesh(text, "ply").vertices.rows(), 4);
}

// Every type, in another order, with unknown elements and properties around, both byte orders.
TEST(Ply, AnyOrderAndTypeOfPropertiesInBothByteOrders) {
    for (bool big : {false, true}) {
        std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                           "_endian 1.0\nelement camera 1\nproperty double focal\n"
                           "property list ushort short marks\nelement face 2\nproperty int flags\n"
                           "property list uint ushort vertex_index\nproperty list char float odd\n"
                           "element vertex 3\nproperty uchar blue\nproperty double z\n"
                           "property list uchar uchar junk\nproperty int16 x\nproperty uint8 red\n"
                           "property float32 y\nproperty uchar green\nproperty float quality\n"
                           "element tail 5\nproperty char byte\nend_header\n";
        put(file, 1.5, big);
        put(file, std::uint16_t(2), big);
        put(file, std::int16_t(-1), big);
        put(file, std::int16_t(7), big);
        for (std::uint16_t face = 0; face < 2; ++face) {
            put(file, std::int32_t(-9), big);
            put(file, std::uint32_t(3), big);
            for (std::uint16_t k = 0; k < 3; ++k)
                put(file, static_cast<std::uint16_t>((k + face) % 3), big);
            put(file, std::int8_t(1), big);
            put(file, 0.25f, big);
        }
        for (int v = 0; v < 3; ++v) {
            put(file, std::uint8_t(v + 20), big);
            put(file, v * 0.1, big);
            put(file, std::uint8_t(v), big);
            for (int k = 0; k < v; ++k) put(file, std::uint8_t(99), big);
            put(file, std::int16_t(-v), big);
            put(file, std::uint8_t(v), big);
            put(file, v * 0.5f, big);
            put(file, std::uint8_t(v + 10), big);
            put(file, 1.0f, big);
        }
        file += "tail!";
        const TriMesh mesh = parse_mesh(file, "ply");
        EXPECT_EQ(mesh.vertices, points_of({{0, 0, 0}, {-1, 0.5, 0.1}, {-2, 1, 0.2}}));
        EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {1, 2, 0}}));
        EXPECT_EQ(mesh.colors.row(2), (Eigen::Matrix<std::uint8_t, 1, 3>(2, 12, 22)));
        EXPECT_EQ(parse_status(file.substr(0, file.size() - 1), "ply"), Status::bad_format);
    }
}

TEST(Ply, FloatColoursMayRunToOneOrTo255) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
        "end_header\n";
    EXPECT_EQ(parse_mesh(header + "0 0 0 0 0.5 1\n1 1 1 0 0 -2\n", "ply").colors.row(0),
              (Eigen::Matrix<std::uint8_t, 1, 3>(0, 128, 255)));
    EXPECT_EQ(parse_mesh(header + "0 0 0 0 100 255\n1 1 1 nan 0 999\n", "ply").colors.row(0),
              (Eigen::Matrix<std::uint8_t, 1, 3>(0, 100, 255)));
}

TEST(Ply, TextureCoordinatesPerVertexAndPerCorner) {
    const TriMesh per_vertex = parse_mesh(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float s\nproperty float t\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0.5 0.25\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n",
        "ply");
    EXPECT_EQ(per_vertex.texture_triangles, per_vertex.triangles);
    EXPECT_EQ(per_vertex.texture(0, 1), 0.25f);
    const TriMesh per_corner = parse_mesh(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
        "property list uchar float texcoord\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 0\n3 0 2 3 6 .1 .2 .3 .4 .5 .6\n",
        "ply");
    ASSERT_EQ(per_corner.texture_triangles.rows(), 2);
    EXPECT_EQ(per_corner.texture(per_corner.texture_triangles(1, 2), 1), 0.6f);
    EXPECT_EQ(per_corner.texture(per_corner.texture_triangles(0, 0), 0), 0.0f);
}

TEST(Ply, StripsAlternateTheirOrientation) {
    const TriMesh mesh = parse_mesh(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n",
        "ply");
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {2, 1, 3}, {0, 1, 2}}));
}

TEST(Ply, ForgedCountsAreHeldAgainstTheFileBeforeAnythingIsAllocated) {
    for (const char* count :
         {"1000000000", "18446744073709551615", "18446744073709551616", "-1", "1e9", "5"}) {
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
            const std::string vertices =
                std::string("ply\nformat ") + format + " 1.0\nelement vertex " + count +
                "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n";
            EXPECT_EQ(parse_status(vertices, "ply"), Status::bad_format) << count << format;
            const std::string faces = std::string("ply\nformat ") + format + " 1.0\nelement face " +
                                      count +
                                      "\nproperty list uchar int vertex_indices\nelement vertex 1\n"
                                      "property float x\nproperty float y\nproperty float z\n"
                                      "end_header\n0 0\n";
            EXPECT_EQ(parse_status(faces, "ply"), Status::bad_format) << count << format;
        }
    }
    // A list that promises more than the file holds.
    std::string list =
        "ply\nformat binary_little_endian 1.0\nelement face 1\n"
        "property list int int vertex_indices\nend_header\n";
    for (std::int32_t length : {-1, 1000000, 2147483647}) {
        std::string file = list;
        put(file, length, false);
        EXPECT_EQ(parse_status(file + "some bytes", "ply"), Status::bad_format);
    }
}

TEST(Ply, AnUnknownElementWithoutPropertiesCostsNothing) {
    std::string text = kSquare;
    text.insert(text.find("element vertex"), "element nothing 18446744073709551615\n");
    EXPECT_EQ(parse_mesh(text, "ply").vertices.rows(), 4);
}

TEST(Ply, BadHeadersAreRefused) {
    const std::string good = kSquare;
    auto with = [&](const char* from, const char* to) {
        std::string text = good;
        text.replace(text.find(from), std::strlen(from), to);
        return parse_status(text, "ply");
    };
    ASSERT_EQ(parse_status(good, "ply"), Status::ok);
    EXPECT_EQ(with("ply\n", "pyl\n"), Status::bad_format);
    EXPECT_EQ(with("format ascii 1.0\n", ""), Status::bad_format);
    EXPECT_EQ(with("ascii", "utf8"), Status::bad_format);
    EXPECT_EQ(with("1.0", "2.0"), Status::bad_format);
    EXPECT_EQ(with("end_header", "end"), Status::bad_format);
    EXPECT_EQ(with("float x", "quad x"), Status::bad_format);
    EXPECT_EQ(with("float x", "float w"), Status::bad_format);
    EXPECT_EQ(with("list uchar int", "list float int"), Status::bad_format);
    EXPECT_EQ(with("list uchar int", "list uchar"), Status::bad_format);
    EXPECT_EQ(with("element face", "element vertex"), Status::bad_format);
    EXPECT_EQ(with("element vertex 4\n", ""), Status::bad_format);
    EXPECT_EQ(with("4 0 1 2 3", "4 0 1 2 -3"), Status::bad_format);
    EXPECT_EQ(with("4 0 1 2 3", "4 0 1 2 1.5"), Status::bad_format);
    EXPECT_EQ(with("4 0 1 2 3", "4 0 1 2 x"), Status::bad_format);
    EXPECT_EQ(with("4 0 1 2 3", "4 0 1 2 4"), Status::invalid_mesh);
    EXPECT_EQ(with("1 1 0", "1 nan 0"), Status::invalid_mesh);
    EXPECT_EQ(with("1 1 0", "1 1e999 0"), Status::invalid_mesh);
}

}  // namespace
