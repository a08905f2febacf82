// Which way triangles face: pieces whose windings disagree are made consistent. A piece is what
// triangles are joined into across edges of exactly two sides; within it, a triangle that runs
// along such an edge in its neighbour's direction is wound the other way. Pieces that touch nowhere
// (a strip of one camera) are compared by where they face from the middle of all.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"
#include "mesh/triangle_fans.hpp"

namespace mien {

struct WindingSettings {
    /// 0 to 1: a piece is turned over as a whole when it faces the middle at least so clearly while
    /// most of the surface faces away, or the other way round. By judgement: caps of a head score
    /// 0.6 and more, nostrils and lids about 0.
    double clearly = 0.4;
    /// 0 to 1: and has at least this share of the triangles.
    double least_share = 0.005;
};

struct WindingReport {
    std::vector<std::uint32_t> turned;  ///< triangles that were wound the other way, ascending
    Index num_pieces = 0;               ///< joined across edges
    Index num_impossible_edges = 0;     ///< edges that no choice makes consistent (Moebius bands)
    /// -1 to 1: how far the surface faces away from its middle, by area, after the change. Below
    /// about -0.3 a head faces inwards.
    double outward = 0;
};

/// Turns the minority over; the larger part by area keeps its winding. Colours, texture corners and
/// numbers of triangles stay; corners 1 and 2 of a turned triangle change places, in the texture
/// too. `mesh` must have passed check_mesh(). O(F log degree).
WindingReport make_windings_consistent(TriMesh& mesh, const WindingSettings& settings,
                                       const Context& context);

/// The same with the fans of `mesh`, whose triangles name no vertex twice; they are made anew when
/// any was turned. O(F) where all are wound alike.
WindingReport make_windings_consistent(TriMesh& mesh, TriangleFans& fans,
                                       const WindingSettings& settings, const Context& context);

/// Turns every triangle over.
void turn_over(TriMesh& mesh);

/// -1 to 1: sum of area (n . d) over sum of area, d the direction from the middle of the surface.
double outward_share(const TriMesh& mesh);

}  // namespace mien
