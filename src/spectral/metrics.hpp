// How far two faces are apart: geometric norms, and two measures of what an eye would notice
// (kosk-2024, 3.3.10; Vasa & Rus 2012; Wang, Torkhani & Montanvert 2012).
#pragma once

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Mean over the vertices of |dx| + |dy| + |dz|, mm (4.6). Same vertex count, else
/// Status::mismatch.
double l1_distance(const PointsRef& a, const PointsRef& b);
/// Mean over the vertices of the Euclidean distance, mm.
double l2_distance(const PointsRef& a, const PointsRef& b);
/// Largest distance from a vertex of one surface to the other surface, both ways, mm. Works across
/// connectivities. Vertices stand for the surface: an inner point of a triangle may be farther.
double hausdorff_distance(const TriMesh& a, const TriMesh& b, const Context& context);

/// Dihedral Angle Mesh Error: area-weighted, masked mean of the change of the oriented dihedral
/// angles, rad. Same triangles. Invariant to similarity motions of either mesh. Not symmetric: the
/// first mesh is the reference whose angles mask.
double dame(const TriMesh& reference, const TriMesh& other, const Context& context);

/// Fast Mesh Perceptual Distance in [0, 1]: difference of the meshes' global roughness, the
/// Laplacian of the angle defect after saturation and masking. Any two connectivities; a surface
/// whose triangles are split is the same surface. Symmetric, invariant to similarity motions of
/// either mesh.
double fmpd(const TriMesh& a, const TriMesh& b, const Context& context);

/// The same, where they come from: one value per vertex.

/// |dx| + |dy| + |dz|, or the Euclidean distance, mm. Same vertex count, else Status::mismatch.
Vector vertex_distances(const PointsRef& a, const PointsRef& b, bool sum_of_axes);
/// Distance of each vertex of `from` from the surface `to`, mm. Any two connectivities.
Vector surface_distances(const TriMesh& from, const TriMesh& to, const Context& context);
/// Masked change of the dihedral angles around each vertex of the reference, weighted with area,
/// rad; 0 where there is no inner edge. Same triangles.
Vector dame_field(const TriMesh& reference, const TriMesh& other, const Context& context);
/// Local roughness r_i of FMPD (see metrics.cpp), rad; zero at borders. A vertex inside a flat fan
/// or on a straight crease has the value of the vertex that stands for it (flat_vertices.hpp).
Vector local_roughness(const TriMesh& mesh, const Context& context);
/// How much rougher (> 0) or smoother (< 0) the other mesh looks at each vertex: the difference of
/// the roughness after saturation and masking, which FMPD takes the mean of. Same vertex count,
/// else Status::mismatch.
Vector fmpd_field(const TriMesh& reference, const TriMesh& other, const Context& context);

}  // namespace mien
