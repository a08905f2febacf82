// A triangle mesh seen from inside the surface: edge lengths instead of coordinates. Any mesh, with
// borders, needles, duplicate vertices, non-manifold edges or flipped triangles, becomes an
// intrinsic Delaunay triangulation of a closed two-sided cover on the same vertices, on which every
// cotangent weight is >= 0 (Sharp and Crane, "A Laplacian for nonmanifold triangle meshes", 2020).
// That is what makes heat flow obey the maximum principle, so that distances never turn negative
// or NaN, and lets a direct solver work without cancellation.
#pragma once

#include <vector>

#include "base/types.hpp"

namespace mien {

struct IntrinsicMesh {
    Index num_vertices = 0;
    Triangles triangles;         ///< corners; one vertex may occur twice in an intrinsic triangle
    Points lengths;              ///< (t, k): length of the edge opposite corner k, mm, > 0
    Vector weights;              ///< per triangle: how much of the surface it stands for (1 or 1/2)
    std::vector<int> component;  ///< per vertex, 0 .. num_components - 1
    int num_components = 0;
    std::vector<char> on_border;  ///< per vertex: 1 on an edge with a single triangle
    double mean_edge_mm = 0;      ///< of the input's edges
    double mollification_mm = 0;  ///< added to every edge so that no triangle is degenerate
    Index num_flips = 0;

    /// 2 x area of triangle t, from its lengths (Kahan's stable order).
    double double_area(Index t) const;
    /// Cotangent of the angle at corner k of triangle t.
    double cotangent(Index t, int k) const;
};

/// `delaunay` false stops after the cover and the mollification. Triangles with a repeated vertex
/// are left out; vertices without triangle are components of their own. Throws
/// Status::invalid_mesh for coordinates that are not finite or indices out of range. O(#F log #F).
IntrinsicMesh build_intrinsic_mesh(const PointsRef& vertices, const TrianglesRef& triangles,
                                   bool delaunay = true);

}  // namespace mien
