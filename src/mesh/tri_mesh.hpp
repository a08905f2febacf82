// A triangle mesh as plain arrays. A scan may be anything a scanner makes: open, in pieces, not
// manifold. Only what check_mesh() promises may be assumed of it.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// A texture image: the bytes of its file as they were read, which are written again unchanged, or
/// pixels of a host's. mesh/image.hpp decodes.
struct TextureImage {
    std::string name;                  ///< UTF-8 file name without its folder; may be empty
    std::string encoded;               ///< a JPEG or PNG file, or another kind that is only kept
    Index width = 0, height = 0;       ///< of `pixels`; 0 for an encoded one
    std::vector<std::uint8_t> pixels;  ///< height x width x 3 from the top row; empty when encoded
};

struct Material {
    std::string name;                             ///< UTF-8; may be empty
    std::array<float, 3> color{{1.f, 1.f, 1.f}};  ///< 0..1 red green blue; an image is times this
    std::int32_t image = -1;                      ///< number of its base colour's image, -1: none
};

/// Texture coordinates: (0, 0) is the lower left corner of the image, (1, 1) the upper right.
struct TriMesh {
    Points vertices;              ///< #V x 3, mm
    Triangles triangles;          ///< #F x 3; may be empty (a point cloud)
    Colors colors;                ///< #V x 3 or empty
    TextureCoordinates texture;   ///< #T x 2 or empty
    Triangles texture_triangles;  ///< #F x 3 indices into `texture`, or empty
    std::vector<Material> materials;
    std::vector<std::uint32_t> triangle_materials;  ///< #F, or empty: all are of the first material
    /// Shared, never null: copies of a mesh do not copy its images.
    std::vector<std::shared_ptr<const TextureImage>> images;

    /// What is no geometry: texture coordinates, materials and images, for another mesh of the same
    /// triangles.
    void take_appearance_of(const TriMesh& other) {
        texture = other.texture;
        texture_triangles = other.texture_triangles;
        materials = other.materials;
        triangle_materials = other.triangle_materials;
        images = other.images;
    }
};

/// Named vertex of a template.
struct Landmark {
    std::string name;
    std::uint32_t vertex = 0;
};

/// Named point on a scan, mm.
struct LandmarkPoint {
    std::string name;
    Vector3 point = Vector3::Zero();
};

/// Named vertex set of a template.
struct Zone {
    std::string name;
    std::vector<std::uint32_t> vertices;
};

/// Throws Status::invalid_mesh with the first offending index: no vertex, a coordinate that is not
/// finite, a triangle index out of range, attribute arrays of another length.
void check_mesh(const TriMesh& mesh, const char* what);

}  // namespace mien
