// glTF 2.0 as others write it, and as Mien does.
#include "mesh/gltf.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "mesh/gltf_document.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_images.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

void put32(std::string& out, std::uint32_t value) {
    out.append(reinterpret_cast<const char*>(&value), 4);
}

std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string out = "glTF";
    put32(out, 2);
    put32(out, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
    put32(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    put32(out, static_cast<std::uint32_t>(binary.size()));
    return out + std::string("BIN\0", 4) + binary;
}

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
    return std::string(reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size());
}

/// Two triangles over four corners of a square, of which the texture's seam doubles one.
const std::string kSquare =
    bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0}) +  // 60 bytes
    bytes_of<float>({0, 0, 1, 0, 1, .25f, .5f, .5f, 0, 1}) +          // 40
    bytes_of<std::uint16_t>({0, 1, 2, 3, 2, 4}) +                     // 12
    bytes_of<std::uint8_t>(
        {0, 0, 0, 255, 51, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 255, 255});

std::string square_json(const std::string& nodes, const std::string& more_attributes = "",
                        const std::string& more = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1)" +
           more_attributes + R"(},"indices":2,"material":0}]}],
"materials":[{"name":"skin","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"},
{"bufferView":1,"componentType":5126,"count":5,"type":"VEC2"},
{"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"},
{"bufferView":3,"componentType":5121,"normalized":true,"count":5,"type":"VEC4"}],
"bufferViews":[{"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":40},
{"buffer":0,"byteOffset":100,"byteLength":12},{"buffer":0,"byteOffset":112,"byteLength":20}],
"buffers":[{"byteLength":132}])" +
           more + "}";
}

TEST(Gltf, SplitVerticesAreJoinedAndTextureCoordinatesStayWithTheCorners) {
    const TriMesh mesh =
        parse_mesh(glb(square_json(R"({"mesh":0})", R"(,"COLOR_0":3)"), kSquare), "glb");
    EXPECT_EQ(mesh.vertices, points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}}));
    const auto corner = [&](Index t, int k) {
        return Eigen::RowVector2f(mesh.texture.row(mesh.texture_triangles(t, k)));
    };
    EXPECT_EQ(corner(0, 0), Eigen::RowVector2f(0, 1));
    EXPECT_EQ(corner(1, 0), Eigen::RowVector2f(.5f, .5f));
    EXPECT_EQ(corner(0, 2), Eigen::RowVector2f(1, .75f));
    ASSERT_EQ(mesh.materials.size(), 1u);
    EXPECT_EQ(mesh.materials[0].name, "skin");
    EXPECT_EQ(mesh.materials[0].color[1], 0.5f);
    EXPECT_EQ(mesh.colors.row(1), (Eigen::Matrix<std::uint8_t, 1, 3>(51, 0, 0)));
}

TEST(Gltf, NodesMoveTheirMeshesAndMirrorsTurnTriangles) {
    const TriMesh moved = parse_mesh(glb(square_json(R"({"children":[1],"translation":[10,0,0]},
                       {"mesh":0,"scale":[2,2,2],"rotation":[0,0,0.7071067811865476,0.7071067811865476]})"),
                                         kSquare),
                                     "glb");
    EXPECT_LT((moved.vertices - points_of({{10, 0, 0}, {10, 2, 0}, {8, 2, 0}, {8, 0, 0}})).norm(),
              1e-12);
    const TriMesh matrix = parse_mesh(
        glb(square_json(R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]})"), kSquare),
        "glb");
    EXPECT_EQ(matrix.vertices.row(0), Eigen::RowVector3d(5, 6, 7));
    const TriMesh mirrored =
        parse_mesh(glb(square_json(R"({"mesh":0,"scale":[-1,1,1]})"), kSquare), "glb");
    EXPECT_EQ(mirrored.triangles, triangles_of({{0, 2, 1}, {0, 3, 2}}));
}

TEST(Gltf, TextWithItsBufferInItselfOrBesideItIsRead) {
    ScratchFolder folder;
    std::string json = square_json(R"({"mesh":0})");
    const std::string with = R"("buffers":[{"uri":"my%20data.bin","byteLength")";
    json.replace(json.find(R"("buffers":[{"byteLength")"),
                 std::strlen(R"("buffers":[{"byteLength")"), with);
    write_bytes(folder / "m.gltf", "\xef\xbb\xbf" + json);
    EXPECT_THROW(read_mesh_file(folder / "m.gltf", Context()), Error);
    write_bytes(folder / "my data.bin", kSquare);
    EXPECT_EQ(read_mesh_file(folder / "m.gltf", Context()).triangles.rows(), 2);
    std::string bytes;
    EXPECT_TRUE(formats::decode_data_uri("data:application/octet-stream;base64,AAEC/w==", bytes));
    EXPECT_EQ(bytes, std::string("\0\1\2\xff", 4));
}

TEST(Gltf, WhatIsCompressedIsNamed) {
    const std::string draco =
        parse_message(glb(square_json(R"({"mesh":0})", "",
                                      R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
                          kSquare),
                      "glb");
    EXPECT_NE(draco.find("KHR_draco_mesh_compression"), std::string::npos) << draco;
}

TEST(Gltf, EveryTruncatedLengthAndEveryFlippedBitIsHandled) {
    const std::string whole = glb(square_json(R"({"mesh":0})", R"(,"COLOR_0":3)"), kSquare);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(parse_message(whole.substr(0, size), "glb"), "read") << size;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::string damaged = whole;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
        parse_message(damaged, "glb");
    }
}

TEST(Gltf, CirclesOfNodesAndForgedCountsEndInErrors) {
    EXPECT_NE(
        parse_message(glb(square_json(R"({"children":[1]},{"children":[0]})"), kSquare), "glb"),
        "read");
    std::string json = square_json(R"({"mesh":0})");
    json.replace(json.find(R"("count":5)"), 9, R"("count":500000000)");
    EXPECT_NE(parse_message(glb(json, kSquare), "glb"), "read");
    // One mesh at a thousand places.
    std::string nodes = R"({"children":[1)", list;
    for (int k = 2; k < 1000; ++k) nodes += "," + std::to_string(k);
    nodes += "]}";
    for (int k = 1; k < 1000; ++k) nodes += R"(,{"mesh":0})";
    EXPECT_EQ(parse_message(glb(square_json(nodes), kSquare), "glb"), "read");
}

TEST(Gltf, VerticesWithEqualPlacesKeepTheirNumbersInAFileOfOurs) {
    ScratchFolder folder;
    TriMesh mesh = grid(4);
    mesh.vertices.row(5) = mesh.vertices.row(6);  // two lips that touch
    write_mesh_file(folder / "m.glb", mesh, Context());
    const TriMesh back = read_mesh_file(folder / "m.glb", Context());
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(Gltf, NamedMorphTargetsComeBackForSplitVertices) {
    ScratchFolder folder;
    const TriMesh mesh = colorful();
    std::vector<MorphTarget> targets(2);
    targets[0] = {"smile", Points::Constant(4, 3, 0.25)};
    targets[0].offsets(2, 1) = -1.5;
    targets[1] = {"mouth \"open\"", Points::Zero(4, 3)};
    write_morph_mesh(folder / "m.glb", mesh, targets, Context());
    const MorphMesh back = read_morph_mesh(folder / "m.glb", Context());
    EXPECT_EQ(back.mesh.vertices, mesh.vertices);
    ASSERT_EQ(back.targets.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(back.targets[k].name, targets[k].name);
        EXPECT_EQ(back.targets[k].offsets, targets[k].offsets);
    }
    EXPECT_THROW(write_morph_mesh(folder / "m.ply", mesh, targets, Context()), Error);
    targets[1].offsets.resize(3, 3);
    EXPECT_THROW(write_morph_mesh(folder / "m.glb", mesh, targets, Context()), Error);
}

TEST(Gltf, APublishedHeadKeepsItsTextureCoordinates) {
    const std::string folder = std::string(MIEN_SHARED_DATA) + "/scans/real/lee_perry_smith/";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no scans in " << folder;
    const TriMesh mesh = read_mesh_file(folder + "lee_perry_smith.glb", Context());
    const TriMesh ply = read_mesh_file(folder + "lee_perry_smith.ply", Context());
    EXPECT_EQ(mesh.triangles.rows(), 17684);
    EXPECT_NEAR(static_cast<double>(mesh.vertices.rows()), static_cast<double>(ply.vertices.rows()),
                5);
    EXPECT_EQ(mesh.texture_triangles.rows(), 17684);
    EXPECT_EQ(mesh.materials.at(0).name, "Material.002");
    ScratchFolder scratch;
    write_mesh_file(scratch / "m.glb", mesh, Context());
    const TriMesh back = read_mesh_file(scratch / "m.glb", Context());
    EXPECT_EQ(back.triangles, mesh.triangles);
    for (Index k = 0; k < mesh.texture_triangles.size(); ++k)
        ASSERT_LT((back.texture.row(back.texture_triangles.data()[k]) -
                   mesh.texture.row(mesh.texture_triangles.data()[k]))
                      .norm(),
                  1e-7f);
}

TEST(Gltf, PointsWithoutTrianglesComeBack) {
    ScratchFolder folder;
    TriMesh mesh = tetrahedron();
    mesh.triangles.resize(0, 3);
    write_mesh_file(folder / "m.glb", mesh, Context());
    const TriMesh back = read_mesh_file(folder / "m.glb", Context());
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.triangles.rows(), 0);
}

}  // namespace
