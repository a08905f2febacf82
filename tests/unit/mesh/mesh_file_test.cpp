#include "mesh/mesh_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cstring>
#include <random>

#include "base/error.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

/// Texture coordinates corner by corner, however they are numbered.
void expect_same_texture(const TriMesh& a, const TriMesh& b) {
    ASSERT_EQ(a.texture_triangles.rows(), b.texture_triangles.rows());
    for (Index t = 0; t < a.texture_triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(a.texture.row(a.texture_triangles(t, k)),
                      b.texture.row(b.texture_triangles(t, k)));
}

TEST(MeshFile, PlyAndObjBringEverythingBack) {
    ScratchFolder folder;
    const TriMesh mesh = colorful();
    for (const char* name : {"m.ply", "m.obj", "M.PLY", "m.Obj"}) {
        write_mesh_file(folder / name, mesh, Context());
        const TriMesh back = read_mesh_file(folder / name, Context());
        EXPECT_EQ(back.vertices, mesh.vertices) << name;
        EXPECT_EQ(back.triangles, mesh.triangles) << name;
        EXPECT_EQ(back.colors, mesh.colors) << name;
        expect_same_texture(back, mesh);
    }
}

TEST(MeshFile, OffBringsColoursBackAndStlTheSurface) {
    ScratchFolder folder;
    const TriMesh mesh = colorful();
    write_mesh_file(folder / "m.off", mesh, Context());
    const TriMesh off = read_mesh_file(folder / "m.off", Context());
    EXPECT_EQ(off.vertices, mesh.vertices);
    EXPECT_EQ(off.triangles, mesh.triangles);
    EXPECT_EQ(off.colors, mesh.colors);
    write_mesh_file(folder / "m.stl", mesh, Context());
    const TriMesh stl = read_mesh_file(folder / "m.stl", Context());
    ASSERT_EQ(stl.vertices.rows(), 4);
    ASSERT_EQ(stl.triangles.rows(), 4);
    for (Index t = 0; t < 4; ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(stl.vertices.row(stl.triangles(t, k)),
                      mesh.vertices.row(mesh.triangles(t, k)));
}

TEST(MeshFile, RandomCoordinatesComeBackToFloatPrecision) {
    ScratchFolder folder;
    TriMesh mesh = grid(20);
    std::mt19937 random(5);
    for (Index i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertices.data()[i] = (double(random()) / 4294967296.0 - 0.5) * 300.0;
    for (const char* name : {"m.ply", "m.obj", "m.off"}) {
        write_mesh_file(folder / name, mesh, Context());
        const TriMesh back = read_mesh_file(folder / name, Context());
        EXPECT_LT((back.vertices - mesh.vertices).cwiseAbs().maxCoeff(), 1e-5) << name;
        EXPECT_EQ(back.triangles, mesh.triangles) << name;
    }
}

TEST(MeshFile, EveryColourByteSurvivesText) {
    ScratchFolder folder;
    TriMesh mesh = grid(16);
    mesh.colors.resize(256, 3);
    for (Index v = 0; v < 256; ++v) mesh.colors.row(v).setConstant(static_cast<std::uint8_t>(v));
    for (const char* name : {"m.obj", "m.off", "m.ply"}) {
        write_mesh_file(folder / name, mesh, Context());
        EXPECT_EQ(read_mesh_file(folder / name, Context()).colors, mesh.colors) << name;
    }
}

TEST(MeshFile, APointCloudKeepsItsPoints) {
    ScratchFolder folder;
    TriMesh mesh = tetrahedron();
    mesh.triangles.resize(0, 3);
    for (const char* name : {"m.ply", "m.obj", "m.off"}) {
        write_mesh_file(folder / name, mesh, Context());
        EXPECT_EQ(read_mesh_file(folder / name, Context()).vertices, mesh.vertices) << name;
    }
    EXPECT_THROW(write_mesh_file(folder / "m.stl", mesh, Context()), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "m.stl"));
}

TEST(MeshFile, ReadsAndWritesWhateverTheLocaleSays) {
    const char* german = nullptr;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"})
        if (german == nullptr) german = std::setlocale(LC_ALL, name);
    const TriMesh mesh = parse_mesh("v 1.5 2.25 -3e-1\n", "obj");
    if (german != nullptr) std::setlocale(LC_ALL, "C");
    EXPECT_EQ(mesh.vertices(0, 0), 1.5);
    EXPECT_EQ(mesh.vertices(0, 2), -0.3);
}

TEST(MeshFile, UnknownExtensionsMissingFilesAndFoldersAreTypedErrors) {
    ScratchFolder folder;
    auto status = [](const std::string& path) {
        try {
            read_mesh_file(path, Context());
            return Status::ok;
        } catch (const Error& error) {
            return error.status();
        }
    };
    write_bytes(folder / "m.txt", "x");
    write_bytes(folder / "empty.ply", "");
    std::filesystem::create_directory(folder / "folder.ply");
    EXPECT_EQ(status(folder / "m.txt"), Status::invalid_argument);
    EXPECT_EQ(status(folder / "noextension"), Status::io);
    EXPECT_THROW(write_mesh_file(folder / "noextension", tetrahedron(), Context()), Error);
    EXPECT_THROW(write_mesh_file(folder / "folder.d/noextension", tetrahedron(), Context()), Error);
    EXPECT_EQ(status(folder / "missing.ply"), Status::io);
    EXPECT_EQ(status(folder / "folder.ply"), Status::io);
    EXPECT_EQ(status(folder / "empty.ply"), Status::bad_format);
}

TEST(MeshFile, WhatCannotBeWrittenLeavesTheOldFile) {
    ScratchFolder folder;
    const TriMesh good = tetrahedron();
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.off"}) {
        write_mesh_file(folder / name, good, Context());
        const std::string before = read_bytes(folder / name);
        TriMesh bad = good;
        bad.vertices(1, 1) = std::numeric_limits<double>::quiet_NaN();
        EXPECT_THROW(write_mesh_file(folder / name, bad, Context()), Error);
        bad = good;
        bad.triangles(0, 0) = 4;
        EXPECT_THROW(write_mesh_file(folder / name, bad, Context()), Error);
        EXPECT_EQ(read_bytes(folder / name), before);
    }
    TriMesh huge = good;
    huge.vertices(2, 0) = 1e300;
    EXPECT_THROW(write_mesh_file(folder / "m.stl", huge, Context()), Error);
    EXPECT_EQ(folder.num_entries(), 4u);
}

TEST(MeshFile, ReadingCanBeCancelledAndKeepsToItsBudget) {
    ScratchFolder folder;
    for (const char* name : {"m.ply", "m.stl", "m.obj", "m.off"}) {
        write_mesh_file(folder / name, grid(40), Context());
        CancelToken token;
        token.request();
        Context cancelled;
        cancelled.cancel = &token;
        try {
            read_mesh_file(folder / name, cancelled);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::cancelled) << name;
        }
        Context poor;
        poor.max_bytes = 10000;
        EXPECT_THROW(read_mesh_file(folder / name, poor), Error) << name;
    }
}

TEST(MeshFile, RealScansAreRead) {
    const std::string data = MIEN_SHARED_DATA;
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "no scans in " << data;
    const TriMesh james = read_mesh_file(data + "/scans/real/james/james.obj", Context());
    EXPECT_GT(james.vertices.rows(), 1000);
    EXPECT_GT(james.triangles.rows(), 1000);
    const TriMesh scan = read_mesh_file(data + "/scans/sim01/scan.ply", Context());
    EXPECT_EQ(scan.vertices.rows(), 100157);
    EXPECT_EQ(scan.triangles.rows(), 198122);
    EXPECT_EQ(scan.colors.rows(), 100157);
}

}  // namespace
