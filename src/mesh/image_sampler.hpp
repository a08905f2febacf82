// The colour of a surface where it is hit: from the texture's images, between their pixels, and not
// from the mesh's vertices, which lie tens of pixels apart.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "mesh/image.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Holds decoded images and what it needs of the mesh; immutable, safe to share between threads.
class ImageSampler {
  public:
    /// Knows no triangle.
    ImageSampler() = default;

    /// Decodes the images that the materials of `mesh`'s triangles use. An image that cannot be
    /// decoded (damaged, of another kind, a build without decoders) is a warning in the log, and
    /// its triangles have no colour. Throws memory_budget, no_memory, cancelled. O(pixels).
    ImageSampler(const TriMesh& mesh, const Context& context);

    /// No triangle has an image.
    bool empty() const { return images_.empty(); }
    bool covers(std::uint32_t triangle) const {
        return triangle < image_of_.size() && image_of_[triangle] >= 0;
    }

    /// Red green blue, 0 to 255, at a place of a triangle that covers(): bilinear between the four
    /// pixels around it; coordinates beyond 0 to 1 repeat the image. Times the material's colour.
    Vector3 color(std::uint32_t triangle, const Vector3& barycentric) const;

    /// The mean over a disc of radius_mm around the place, by a few samples that stay within the
    /// triangle (beyond its edge the image may show another part of the face).
    Vector3 color(std::uint32_t triangle, const Vector3& barycentric, double radius_mm) const;

    /// #V x 3: for each vertex the mean over the corners of triangles that have an image; where
    /// there is none, the mesh's vertex colour, or grey without one.
    Colors vertex_colors(const TriMesh& mesh, double radius_mm) const;

  private:
    Vector3 pixel(const Image& image, double u, double v) const;

    std::vector<Image> images_;
    std::vector<std::int32_t> image_of_;  ///< per triangle, -1: none
    std::vector<Vector3> tint_of_image_use_;
    std::vector<std::uint32_t> tint_of_;  ///< per triangle
    Points vertices_;
    Triangles triangles_, texture_triangles_;
    TextureCoordinates texture_;
};

}  // namespace mien
