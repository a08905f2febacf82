#include <cstdio>
#include <fstream>
#include <limits>

#include "handles.hpp"

namespace {

using namespace mien_test;

TEST(Mesh, KeepsWhatTheHostGave) {
    Session session;
    const Mesh mesh = make_square(session);
    uint64_t vertices = 0, triangles = 0;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_counts(mesh.get(), &vertices, &triangles, nullptr));
    EXPECT_EQ(4u, vertices);
    EXPECT_EQ(2u, triangles);
    double positions[12];
    uint64_t count = 0;
    EXPECT_EQ(MIEN_OK,
              mien_mesh_get_positions(mesh.get(), MIEN_DTYPE_F64, positions, 4, &count, nullptr));
    EXPECT_EQ(1.0, positions[3]);
    uint32_t indices[6];
    EXPECT_EQ(MIEN_OK, mien_mesh_get_triangles(mesh.get(), indices, 2, nullptr, nullptr));
    EXPECT_EQ(3u, indices[5]);
}

TEST(Mesh, ReadsStridedDoublesInPlace) {
    Session session;
    const double rows[3][4] = {{0, 0, 0, 9}, {1, 0, 0, 9}, {0, 1, 0, 9}};
    mien_mesh_arrays arrays;
    mien_mesh_arrays_init(&arrays, sizeof arrays);
    arrays.positions = {rows, 3, sizeof rows[0], MIEN_DTYPE_F64, 0};
    mien_mesh* mesh = nullptr;
    ASSERT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    const double* view = nullptr;
    ASSERT_EQ(MIEN_OK, mien_mesh_positions_view(mesh, &view, nullptr, nullptr));
    EXPECT_EQ(1.0, view[7]);
    mien_mesh_release(mesh);
}

TEST(Mesh, TwoCallProtocolWritesTheCountAndNothingElse) {
    Session session;
    const Mesh mesh = make_square(session);
    uint64_t count = 0;
    EXPECT_EQ(MIEN_OK,
              mien_mesh_get_positions(mesh.get(), MIEN_DTYPE_F32, nullptr, 0, &count, nullptr));
    EXPECT_EQ(4u, count);
    float untouched[12] = {7};
    count = 0;
    EXPECT_EQ(MIEN_E_BUFFER_TOO_SMALL,
              mien_mesh_get_positions(mesh.get(), MIEN_DTYPE_F32, untouched, 3, &count, nullptr));
    EXPECT_EQ(4u, count);
    EXPECT_EQ(7.0f, untouched[0]);
}

TEST(Mesh, NamesTheFirstVertexThatIsNotFinite) {
    Session session;
    Square square;
    square.positions[7] = std::numeric_limits<float>::quiet_NaN();
    const mien_mesh_arrays arrays = square.arrays();
    mien_mesh* mesh = reinterpret_cast<mien_mesh*>(&square);
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_MESH, mien_mesh_create(session, &arrays, &mesh, &error));
    EXPECT_EQ(nullptr, mesh);
    EXPECT_EQ(2, error.detail_index);
    EXPECT_NE(nullptr, std::strstr(error.message, "vertex 2"));
}

TEST(Mesh, NamesTheFirstTriangleOutOfRange) {
    Session session;
    Square square;
    square.triangles[4] = 4;
    const mien_mesh_arrays arrays = square.arrays();
    mien_mesh* mesh = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_MESH, mien_mesh_create(session, &arrays, &mesh, &error));
    EXPECT_EQ(1, error.detail_index);
}

TEST(Mesh, RefusesBadViews) {
    Session session;
    const Square square;
    mien_mesh* mesh = nullptr;
    mien_mesh_arrays arrays = square.arrays();
    arrays.positions.count = 0;
    EXPECT_EQ(MIEN_E_INVALID_MESH, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.positions.count = UINT64_MAX / 2;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.positions.data = nullptr;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.positions.data = reinterpret_cast<const char*>(square.positions) + 1;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.positions.stride_bytes = 8;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.positions.dtype = 77;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    arrays = square.arrays();
    arrays.triangles = nullptr;
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, &mesh, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, nullptr, &mesh, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_create(session, &arrays, nullptr, nullptr));
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, mien_mesh_create(nullptr, &arrays, &mesh, nullptr));
    EXPECT_NE(nullptr, make_square(session).get()) << "the session stays usable after every error";
}

TEST(Mesh, HandleOfAnotherTypeIsRefused) {
    Session session;
    auto* impostor = reinterpret_cast<mien_mesh*>(session.handle);
    uint64_t count = 0;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_INVALID_HANDLE, mien_mesh_get_counts(impostor, &count, nullptr, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "mesh"));
    mien_mesh_release(impostor);  // ignored
    EXPECT_NE(nullptr, make_square(session).get());
}

TEST(Mesh, OutlivesItsSession) {
    auto session = std::make_unique<Session>();
    const Mesh mesh = make_square(*session);
    session.reset();
    uint64_t vertices = 0;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_counts(mesh.get(), &vertices, nullptr, nullptr));
    EXPECT_EQ(4u, vertices);
}

TEST(Mesh, EveryRetainNeedsARelease) {
    Session session;
    mien_mesh* mesh = make_square(session).release();
    mien_mesh_retain(mesh);
    mien_mesh_release(mesh);
    uint64_t vertices = 0;
    EXPECT_EQ(MIEN_OK, mien_mesh_get_counts(mesh, &vertices, nullptr, nullptr));
    mien_mesh_release(mesh);
}

TEST(Mesh, FilesGoAndComeBack) {
    Session session;
    const Mesh mesh = make_square(session);
    for (const char* extension : {"ply", "obj", "stl", "off", "glb"}) {
        const std::string path = temporary_path(std::string("square.") + extension);
        ASSERT_EQ(MIEN_OK, mien_mesh_save(session, mesh.get(), path.c_str(), nullptr)) << extension;
        mien_mesh* read = nullptr;
        ASSERT_EQ(MIEN_OK, mien_mesh_load(session, path.c_str(), &read, nullptr)) << extension;
        uint64_t vertices = 0, triangles = 0;
        EXPECT_EQ(MIEN_OK, mien_mesh_get_counts(read, &vertices, &triangles, nullptr));
        EXPECT_EQ(4u, vertices) << extension;
        EXPECT_EQ(2u, triangles) << extension;
        mien_mesh_release(read);
    }
    mien_mesh* missing = nullptr;
    mien_error error = fresh_error();
    EXPECT_EQ(MIEN_E_IO,
              mien_mesh_load(session, temporary_path("none.ply").c_str(), &missing, &error));
    EXPECT_NE(nullptr, std::strstr(error.message, "none.ply"));
}

// It was MIEN_E_BAD_FORMAT, which hosts took for a damaged file.
TEST(Mesh, AnExtensionThatIsNoFormatIsAnArgumentAsTheHeaderSays) {
    Session session;
    const Mesh mesh = make_square(session);
    for (const char* name : {"square.doc", "square", "square."}) {
        const std::string path = temporary_path(name);
        mien_error error = fresh_error();
        EXPECT_EQ(MIEN_E_INVALID_ARGUMENT,
                  mien_mesh_save(session, mesh.get(), path.c_str(), &error))
            << name;
        EXPECT_NE(nullptr, std::strstr(error.message, "square")) << error.message;
        std::ofstream(path) << "solid";
        mien_mesh* read = nullptr;
        EXPECT_EQ(MIEN_E_INVALID_ARGUMENT, mien_mesh_load(session, path.c_str(), &read, &error))
            << name;
        EXPECT_EQ(nullptr, read);
        std::remove(path.c_str());
    }
}

TEST(Mesh, BudgetOfTheSessionHolds) {
    Session session(1, 100);
    const Square square;
    const mien_mesh_arrays arrays = square.arrays();
    mien_mesh* mesh = nullptr;
    EXPECT_EQ(MIEN_E_MEMORY_BUDGET, mien_mesh_create(session, &arrays, &mesh, nullptr));
}

}  // namespace
