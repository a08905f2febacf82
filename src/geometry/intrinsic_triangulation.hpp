// A triangulation known by its edge lengths: the mesh in space to begin with, its intrinsic
// Delaunay triangulation after edge flips. Vertices never move; only who is joined to whom changes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// Corner c is vertex[c]; side c joins corners c and c + 1 (mod 3) and faces corner c + 2.
struct IntrinsicTriangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<double, 3> length;

    double area() const;  ///< Heron in Kahan's stable form; 0 where the sides make no triangle
    /// Cotangent of the angle at each corner; `area` must be positive.
    std::array<double, 3> cotangents(double area) const;
};

class IntrinsicTriangulation {
  public:
    /// Throws Status::invalid_mesh for no vertex, a coordinate that is not finite or an index out
    /// of range. Triangles that name a vertex twice are left out: they have neither area nor
    /// angles.
    IntrinsicTriangulation(const PointsRef& vertices, const TrianglesRef& triangles);

    /// Flips inner edges until cot a + cot b >= 0 at each. Edges at borders, between triangles of
    /// opposite orientation and with more than two triangles are hinges: they are never flipped.
    /// Returns the number of flips.
    std::size_t make_delaunay();

    const std::vector<IntrinsicTriangle>& triangles() const { return triangles_; }
    /// Length that was added to every edge (0 for a mesh without degenerate triangles).
    double mollification() const { return mollification_; }

  private:
    struct Side {
        std::int32_t triangle = -1;
        std::int32_t side = 0;
    };
    void glue();
    bool flip(std::int32_t triangle, int side);

    std::vector<IntrinsicTriangle> triangles_;
    std::vector<std::array<Side, 3>> neighbour_;
    double mollification_ = 0;
};

}  // namespace mien
