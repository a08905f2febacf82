// Surface areas and the volume of a closed mesh.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// #V, mm^2: each vertex gets a third of its triangles' areas. Sums to the surface's area.
Vector vertex_areas(const PointsRef& vertices, const TrianglesRef& triangles);
double surface_area_mm2(const PointsRef& vertices, const TrianglesRef& triangles);

struct ZoneArea {
    std::string name;
    double area_mm2 = 0.0;
};
/// Zones in the order given; the areas of disjoint zones and of their complement add up.
std::vector<ZoneArea> zone_areas(const PointsRef& vertices, const TrianglesRef& triangles,
                                 const std::vector<Zone>& zones);

/// How the area of some vertices (a third of each triangle per corner, as above) grows with each
/// place: #V x 3, mm^2 per mm. `inside`: #V, 1 where a vertex belongs to them.
Points area_gradient(const PointsRef& vertices, const TrianglesRef& triangles,
                     const std::vector<char>& inside);

/// What a mesh lacks to enclose a volume.
struct ClosureReport {
    Index open_edges = 0;          ///< edges of one triangle
    Index non_manifold_edges = 0;  ///< edges of three or more
    Index inconsistent_edges = 0;  ///< edges of two triangles that run through it the same way
    bool closed() const { return open_edges + non_manifold_edges + inconsistent_edges == 0; }
};
ClosureReport examine_closure(const TrianglesRef& triangles, Index num_vertices);

enum class OpenRims {
    refuse,          ///< throws Status::invalid_mesh, saying how many edges are open
    fan_to_centroid  ///< closes each rim by a fan from its vertices' mean
};

/// Divergence theorem, sum of det(p0, p1, p2) / 6 about the mesh's centroid (so that a far-away
/// mesh loses no digits). Positive for outward normals. Throws Status::invalid_mesh for a mesh that
/// is not closed (by the rule `rims`), not manifold along edges or not consistently oriented.
double closed_volume_ml(const PointsRef& vertices, const TrianglesRef& triangles, OpenRims rims,
                        const Context& context);

}  // namespace mien
