// The mesh behind mien_mesh. Results that contain meshes embed one of these.
#pragma once

#include <memory>
#include <utility>

#include "handle.hpp"
#include "mesh/tri_mesh.hpp"

struct mien_mesh : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::mesh;
    static constexpr const char* kName = "mesh";
    explicit mien_mesh(std::shared_ptr<const mien::TriMesh> data)
        : Object(kTag), mesh(std::move(data)) {}
    std::shared_ptr<const mien::TriMesh> mesh;
};
