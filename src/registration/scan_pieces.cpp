#include "registration/scan_pieces.hpp"

#include <algorithm>
#include <cstdio>
#include <Eigen/Geometry>

#include "mesh/topology.hpp"

namespace mien {
namespace {

using Box = Eigen::AlignedBox3d;

Box box_of(const TriMesh& mesh, const ConnectedComponents& pieces, std::uint32_t piece) {
    Box box;
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        if (pieces.of_vertex[static_cast<std::size_t>(v)] == piece)
            box.extend(Vector3(mesh.vertices.row(v).transpose()));
    return box;
}

}  // namespace

PieceFindings find_pieces(const TriMesh& mesh, const PieceSettings& settings) {
    PieceFindings found;
    if (!settings.enabled || mesh.triangles.rows() == 0) return found;
    const ConnectedComponents pieces = connected_components(mesh.triangles, mesh.vertices.rows());
    const std::vector<Index>& sizes = pieces.num_triangles;
    if (sizes.size() < 2 || sizes[1] < settings.least_triangles ||
        static_cast<double>(sizes[1]) < settings.as_large * static_cast<double>(sizes[0]))
        return found;
    const Box first = box_of(mesh, pieces, 0), second = box_of(mesh, pieces, 1);
    const Box common = first.intersection(second);
    // An empty common box has sizes below zero.
    const double shared = common.isEmpty() ? 0 : common.volume();
    const double all = first.merged(second).volume();
    char text[300];
    if (all > 0 && shared > settings.over * all) {
        std::snprintf(
            text, sizeof text,
            "two pieces of the scan, of %lld and %lld triangles, lie over each other: two "
            "scans in one file, or a double shell; keep one of them, since the fit "
            "follows either",
            static_cast<long long>(sizes[0]), static_cast<long long>(sizes[1]));
        found.doubt = text;
    } else if (all > 0 && shared < settings.beside * all) {
        std::snprintf(text, sizeof text,
                      "the scan has a second piece of %lld triangles %.0f mm beside the largest of "
                      "%lld: if it is another face, check which of them was fitted, or cut it off",
                      static_cast<long long>(sizes[1]), (second.center() - first.center()).norm(),
                      static_cast<long long>(sizes[0]));
        found.note = text;
    }
    return found;
}

}  // namespace mien
