// Neutralization of a whole mesh: in the model's topology, or in a larger one whose first vertices
// are the model's (a template of the head, a model of the face). There the displacement runs out
// smoothly over the surface behind the model's rim:
//     (K + M / l^2) u = 0 on the other vertices, u given on the model's,
// K the stiffness matrix, M the mass matrix, l the length over which the displacement decays.
#pragma once

#include "base/context.hpp"
#include "expression/neutralize.hpp"
#include "expression/visits.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct NeutralizeMeshOptions {
    NeutralizeOptions neutralize;
    double decay_mm = 25.0;  ///< l, > 0
};

/// How a mesh's vertices relate to a model's.
enum class TopologyMatch { same, prefix, none };
TopologyMatch match_topology(const ExpressionModel& model, Index num_vertices,
                             const TrianglesRef& triangles);

/// Weights per vertex of the mesh or empty. neutral_vertices and uncertainty_mm have a row per
/// vertex of the mesh (no uncertainty, zero, is known behind the rim). Throws as neutralize();
/// Status::mismatch when the mesh does not begin with the model's vertices and triangles.
NeutralizationResult neutralize_mesh(const Context& context, const ExpressionModel& model,
                                     const TriMesh& mesh, const Vector& weights_per_vertex,
                                     const NeutralizeMeshOptions& options);

/// neutralize_visits() of meshes, each in the model's topology or in a larger one that begins with
/// it; all in the same one. `weights` is empty or has an entry per mesh, itself empty or with a
/// weight per vertex of the mesh; treated vertices behind the model's rim are left out: there is no
/// expression. The results have a row per vertex of the mesh; the shared face takes what lies
/// behind the rim from the first mesh.
VisitsResult neutralize_visit_meshes(const Context& context, const ExpressionModel& model,
                                     const std::vector<std::shared_ptr<const TriMesh>>& meshes,
                                     const std::vector<Vector>& weights, VisitsOptions options,
                                     double decay_mm = NeutralizeMeshOptions().decay_mm);

/// Extends displacements of the first rows to all vertices. Vertices that no triangle joins to a
/// known one do not move.
Points extend_displacement(const PointsRef& vertices, const TrianglesRef& triangles,
                           const PointsRef& known, double decay_mm);

}  // namespace mien
