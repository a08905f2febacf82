// A template as an OpenMesh half-edge structure. Scans stay plain arrays: OpenMesh refuses what is
// not manifold. Vertex and face handles keep the numbers of the arrays.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct HalfEdgeTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    using TexCoord2D = OpenMesh::Vec2f;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Throws Status::invalid_mesh with the first triangle that has a vertex twice, the first edge of
/// three or more triangles, the first edge whose two triangles are oriented against each other, or
/// the first vertex whose triangles form more than one fan (detail index: triangle, or lower vertex
/// of the edge, or vertex). Vertices without triangles are allowed and stay isolated.
HalfEdgeMesh build_half_edge_mesh(const TriMesh& mesh, const char* what, const Context& context);

/// The same into an empty structure: a copy of one leaks when memory runs out within it.
void fill_half_edge_mesh(const TriMesh& mesh, const char* what, HalfEdgeMesh& half_edges,
                         const Context& context);

/// Back to arrays; colours and texture are not carried. Deleted elements must have been collected.
TriMesh from_half_edge_mesh(const HalfEdgeMesh& half_edges);

}  // namespace mien
