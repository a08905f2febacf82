// The object behind mien_spectral_basis, and what the files over the room of spectral meshes share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "handle.hpp"
#include "mesh.hpp"
#include "spectral/spectral_basis.hpp"

struct mien_spectral_basis : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::spectral_basis;
    static constexpr const char* kName = "spectral basis";
    explicit mien_spectral_basis(std::shared_ptr<const mien::SpectralBasis> basis)
        : mien::abi::Object(kTag), data(std::move(basis)) {}
    const std::shared_ptr<const mien::SpectralBasis> data;
};

namespace mien::abi {

inline mien_mesh* make_mesh(Points&& vertices, const Triangles& triangles) {
    auto mesh = std::make_shared<TriMesh>();
    mesh->vertices = std::move(vertices);
    mesh->triangles = triangles;
    return new mien_mesh(std::shared_ptr<const TriMesh>(std::move(mesh)));
}

/// Counts of the host's that are larger than any mesh mean "all".
inline Index as_index(std::uint64_t value) {
    return static_cast<Index>(
        std::min<std::uint64_t>(value, std::numeric_limits<std::int32_t>::max()));
}

}  // namespace mien::abi
