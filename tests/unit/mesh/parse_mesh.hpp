// A mesh file read from memory, and what its reader said of it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/mesh_file.hpp"

namespace mien::testing {

/// From a block of exactly that size, so that a sanitizer sees a reader that goes on behind its
/// end.
inline TriMesh parse_mesh(const std::string& bytes, const char* extension) {
    const std::vector<char> exact(bytes.begin(), bytes.end());
    return read_mesh_memory(exact.data(), exact.size(), extension, Context());
}

inline Status parse_status(const std::string& bytes, const char* extension) {
    try {
        parse_mesh(bytes, extension);
        return Status::ok;
    } catch (const Error& error) {
        return error.status();
    }
}

/// "read", or the message.
inline std::string parse_message(const std::string& bytes, const char* extension) {
    try {
        parse_mesh(bytes, extension);
        return "read";
    } catch (const Error& error) {
        EXPECT_NE(error.status(), Status::internal);
        return error.what();
    }
}

}  // namespace mien::testing
