// Levels of a template from fine to coarse with linear maps between them, for graph networks and
// for multi-resolution registration (kosk-2024, 3.3.2-3.3.4).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/safetensors.hpp"
#include "geometry/laplacian.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

using RowSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct MeshLevel {
    TriMesh mesh;    ///< triangles are empty where only the connectivity was sampled
    RowSparse down;  ///< #V of this level x #V of the finer one; empty for level 0. Rows sum to 1
    RowSparse up;    ///< #V of the finer level x #V of this one. Rows sum to 1
    std::vector<std::uint32_t> kept;  ///< number in the finer level of each vertex
    VertexRings
        graph;  ///< of a new connectivity hierarchy, which has no triangles; not kept in files
};

struct MeshHierarchy {
    std::string kind;  ///< "quadric" or "connectivity"
    std::vector<MeshLevel> levels;
};

/// Quadric edge collapse by `factor` a level (Ranjan et al. 2018): down picks the kept vertices, up
/// places each fine vertex on the closest coarse triangle by barycentric weights. Stops early when
/// no collapse is legal. factor > 1.
std::shared_ptr<const MeshHierarchy> quadric_hierarchy(const TriMesh& mesh, Index num_levels,
                                                       double factor, const Context& context);

/// From the connectivity alone (Zhou et al. 2020): vertices are kept so that every vertex is within
/// stride - 1 edges of a kept one and kept ones are at least `stride` edges apart; down averages
/// the vertices within `radius` edges, up spreads a vertex over the same neighbourhood. stride >=
/// 1, radius >= stride - 1. The same for every face in correspondence.
std::shared_ptr<const MeshHierarchy> connectivity_hierarchy(const TriMesh& mesh, Index num_levels,
                                                            Index stride, Index radius,
                                                            const Context& context);

/// safetensors, kind "mien-mesh-hierarchy", format 1: per level L vertices_L f64, triangles_L u32,
/// kept_L u32 and the maps as CSR: down_L.rows, up_L.rows u32 (#rows + 1), .cols u32, .values f64.
void save_mesh_hierarchy(const std::string& path, const MeshHierarchy& hierarchy,
                         const Context& context);
std::shared_ptr<const MeshHierarchy> load_mesh_hierarchy(const std::string& path,
                                                         const SafetensorsReadOptions& options,
                                                         const Context& context);

}  // namespace mien
