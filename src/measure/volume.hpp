// Volume between two faces in correspondence: signed, positive, negative and absolute, whole and
// per zone, exact where the two surfaces cross inside a pair of triangles.
//
// Definition. A point with barycentric coordinates b of a triangle moves on a straight line from
// the before face to the after face, x(b, t) = p(b) + t d(b), t in [0, 1]. The region swept by the
// triangle has the signed volume
//     V = integral over b, t of det(dx/db1, dx/db2, dx/dt) = mean over the triangle of N . d(b),
// where N = integral over t of the moving triangle's area vector = (N(0) + 4 N(1/2) + N(1)) / 6,
// exactly, because N(t) is quadratic in t. The density c(b) = N . d(b) is linear in b, so its
// positive and its negative part are integrated in closed form by cutting the triangle along c = 0.
// The walls between neighbouring regions are ruled by the same straight lines and cancel, so for
// closed faces the signed total is volume(after) - volume(before), to rounding.
//
// Departure from jousse-2022, 4.1.2 (three unsigned tetrahedra per pair, "small errors when the two
// triangles are intersecting"): no error at crossings, a sign, and no dependence on how the prism
// is cut into tetrahedra.
//
// Zones. Vertex i gets the integral of its hat function times the density, so a zone's edge runs
// linearly through the one ring of triangles that it shares with its neighbour. The shares of all
// vertices add up to the whole, hence disjoint zones and the rest do too.
//
// Sign. Positive: the after face lies outside the before face, along the normal of
// counter-clockwise triangles. A volume does not change when both faces are moved together.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Millilitres. signed_ml = positive_ml + negative_ml, absolute_ml = positive_ml - negative_ml.
struct VolumeParts {
    double signed_ml = 0.0;
    double positive_ml = 0.0;  ///< >= 0: gained
    double negative_ml = 0.0;  ///< <= 0: lost
    double absolute_ml = 0.0;
};

/// Each vertex' share, mm^3; positive >= 0 >= negative.
struct VertexVolumes {
    Vector positive_mm3;  ///< #V
    Vector negative_mm3;  ///< #V
};

struct ZoneVolume {
    std::string name;
    VolumeParts volume;
    double area_before_mm2 = 0.0;  ///< by the same hat functions
    double area_after_mm2 = 0.0;
};

struct VolumeReport {
    ZoneVolume whole;               ///< name "whole"
    std::vector<ZoneVolume> zones;  ///< in the order given
    ZoneVolume rest;                ///< name "rest": vertices of no zone
    bool zones_disjoint = true;     ///< then zones + rest = whole
};

/// Shares of all vertices. before and after are #V x 3 and share `triangles`. Throws
/// Status::mismatch for different vertex counts, invalid_mesh (first offending index) for values
/// that are not finite or indices out of range. Linear time, 48 bytes per triangle.
VertexVolumes volume_per_vertex(const PointsRef& before, const PointsRef& after,
                                const TrianglesRef& triangles, const Context& context);

/// Sum of the shares of some vertices (each counted once, whatever the order or repetition).
VolumeParts volume_of(const VertexVolumes& shares, const std::vector<std::uint32_t>& vertices);
/// Sum of all shares.
VolumeParts volume_of(const VertexVolumes& shares);

/// The whole report. A zone vertex beyond #V throws Status::mismatch naming the zone.
VolumeReport measure_volume(const PointsRef& before, const PointsRef& after,
                            const TrianglesRef& triangles, const std::vector<Zone>& zones,
                            const Context& context);

}  // namespace mien
