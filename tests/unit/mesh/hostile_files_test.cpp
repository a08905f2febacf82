// Every truncated length and every flipped bit of a small file of each kind: an Error or a mesh
// that passes its check, nothing else. Sanitizers see what a plain build does not.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

/// True when the bytes were read as a mesh.
bool survives(const std::string& bytes, const std::string& extension) {
    // On the heap and of exact size, so that a sanitizer sees the first byte too far.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    try {
        const TriMesh mesh = read_mesh_memory(exact.data(), exact.size(), extension, Context());
        check_mesh(mesh, "read");
        return true;
    } catch (const Error& error) {
        EXPECT_NE(error.status(), Status::internal) << error.what();
        EXPECT_NE(error.status(), Status::ok);
        EXPECT_NE(error.what()[0], '\0');
        return false;
    }
}

struct Sample {
    std::string extension, bytes;
    bool binary;
};

std::vector<Sample> samples() {
    ScratchFolder folder;
    std::vector<Sample> all;
    for (const char* extension : {"ply", "obj", "stl", "off", "glb"}) {
        const std::string path = folder / (std::string("m.") + extension);
        write_mesh_file(path, colorful(), Context());
        const std::string name = extension;
        all.push_back({name, read_bytes(path), name == "ply" || name == "stl" || name == "glb"});
    }
    all.push_back({"ply",
                   "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                   false});
    all.push_back({"stl",
                   "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n",
                   false});
    all.push_back({"xyz", "X Y Z R G B\n0 0 0 255 0 0\n1.5 -2e1 3 0 7 255\n", false});
    return all;
}

TEST(HostileFiles, EveryTruncatedLengthIsHandled) {
    for (const Sample& sample : samples())
        for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
            const bool read = survives(sample.bytes.substr(0, size), sample.extension);
            EXPECT_FALSE(sample.binary && read) << sample.extension << size;
        }
}

TEST(HostileFiles, EveryFlippedBitIsHandled) {
    for (const Sample& sample : samples()) {
        ASSERT_TRUE(survives(sample.bytes, sample.extension));
        for (std::size_t bit = 0; bit < 8 * sample.bytes.size(); ++bit) {
            std::string damaged = sample.bytes;
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
            survives(damaged, sample.extension);
        }
    }
}

TEST(HostileFiles, EveryFormatReadsEveryOtherAsAnErrorOrAMesh) {
    for (const Sample& sample : samples())
        for (const char* extension : {"ply", "obj", "stl", "off", "glb", "xyz"})
            survives(sample.bytes, extension);
}

}  // namespace
