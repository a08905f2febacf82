// Distances between two faces, in correspondence or not: per vertex, per zone, Hausdorff.
//
// All means and percentiles are weighted with the vertices' areas, so that they describe the skin
// and not the mesh's density.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct DistanceSummary {
    std::string name;
    double mean_signed_mm = 0.0;  ///< along the normal of the before face; positive: outside
    double sd_signed_mm = 0.0;
    double mean_absolute_mm = 0.0;  ///< mean of |signed|
    double rms_mm = 0.0;            ///< of the length, whatever its direction
    double mean_length_mm = 0.0;
    double median_length_mm = 0.0;
    double p95_length_mm = 0.0;
    double max_length_mm = 0.0;  ///< one-sided Hausdorff distance at the vertices
    Index num_vertices = 0;
};

struct DistanceReport {
    Vector signed_mm;  ///< #V, displacement . normal of the before face
    Vector length_mm;  ///< #V, length of the displacement; not a number where there was none
    DistanceSummary whole;
    std::vector<DistanceSummary> zones;
    double hausdorff_mm = 0.0;  ///< larger of both sides where both were measured
};

/// Faces in correspondence: the displacement of each vertex.
DistanceReport measure_distance(const PointsRef& before, const PointsRef& after,
                                const TrianglesRef& triangles, const std::vector<Zone>& zones,
                                const Context& context);

/// From each vertex of `from` to the closest point of `to`, which may be any scan (or a cloud of
/// points). Vertices farther than max_distance_mm (<= 0: no limit) or whose closest point lies on
/// the border of `to` (nothing is known beyond it) are left out when skip_borders. Zones are of
/// `from`. hausdorff_mm takes both directions.
DistanceReport measure_surface_distance(const TriMesh& from, const TriMesh& to,
                                        const std::vector<Zone>& zones, double max_distance_mm,
                                        bool skip_borders, const Context& context);

/// Weighted quantile of the finite values, q in [0, 1]: the smallest value with at least the share
/// q of the weight at or below it. Not a number when no value is finite.
double weighted_quantile(const Vector& values, const Vector& weights,
                         const std::vector<char>& inside, double q);

}  // namespace mien
