// Small helpers for tests that speak to the shared library alone.
#pragma once

#include <gtest/gtest.h>
#include <mien/mien.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace mien_test {

/// An error record ready for use.
inline mien_error fresh_error() {
    mien_error error;
    std::memset(&error, 0, sizeof error);
    error.struct_size = sizeof error;
    return error;
}

struct Session {
    explicit Session(int num_threads = 1, std::uint64_t max_bytes = 0) {
        mien_session_options options;
        mien_session_options_init(&options, sizeof options);
        options.num_threads = num_threads;
        options.max_bytes = max_bytes;
        EXPECT_EQ(MIEN_OK,
                  mien_session_create_with_options(MIEN_ABI_VERSION, &options, &handle, nullptr));
    }
    ~Session() { mien_session_release(handle); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    operator mien_session*() const { return handle; }
    mien_session* handle = nullptr;
};

/// A unit square of two triangles.
struct Square {
    float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    std::uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
    mien_mesh_arrays arrays() const {
        mien_mesh_arrays a;
        mien_mesh_arrays_init(&a, sizeof a);
        a.positions = {positions, 4, 0, MIEN_DTYPE_F32, 0};
        a.triangles = triangles;
        a.triangle_count = 2;
        return a;
    }
};

using Mesh = std::unique_ptr<mien_mesh, void (*)(mien_mesh*)>;

inline Mesh make_square(mien_session* session) {
    mien_mesh* mesh = nullptr;
    const Square square;
    const mien_mesh_arrays arrays = square.arrays();
    EXPECT_EQ(MIEN_OK, mien_mesh_create(session, &arrays, &mesh, nullptr));
    return Mesh(mesh, mien_mesh_release);
}

/// A writable folder of this test program.
inline std::string temporary_path(const std::string& name) {
    return ::testing::TempDir() + "mien_abi_" + name;
}

}  // namespace mien_test
