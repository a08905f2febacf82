// What a mesh is and what is wrong with it, before anything is done with it.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/cleaning.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/topology.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct MeshReport {
    Index num_vertices = 0, num_triangles = 0, num_texture = 0;
    bool has_colors = false;
    Vector3 low = Vector3::Zero(), high = Vector3::Zero();  ///< corners of the box of all vertices
    double extent = 0;                                      ///< robust_extent(), in the mesh's unit
    std::vector<LengthUnit> units;                          ///< plausible ones, likeliest first
    Index num_components = 0;     ///< joined through vertices, unused vertices left out
    Index largest_component = 0;  ///< triangles
    Index num_border_loops = 0;   ///< closed chains of edges of one triangle
    double longest_border = 0;    ///< in the mesh's unit
    TopologyReport topology;
    Index num_turned = 0;          ///< triangles wound against most of their piece
    double outward = 0;            ///< WindingReport::outward
    Index num_equal_vertices = 0;  ///< vertices with the coordinates of an earlier one
    Index num_duplicate_triangles = 0;
    double mean_edge = 0;             ///< in the mesh's unit
    std::vector<std::string> faults;  ///< what is wrong and what to do, in words; empty: nothing
};

/// `mesh` must have passed check_mesh(). O(V + F log F).
MeshReport inspect_mesh(const TriMesh& mesh, const Context& context);

/// The same as a JSON object.
std::string mesh_report_json(const MeshReport& report);

}  // namespace mien
