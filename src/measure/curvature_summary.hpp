// Curvature of a face, per vertex and per zone (geometry/curvature.hpp estimates it).
//
// Means over a zone are weighted with the vertices' areas, so that they describe the skin and not
// the mesh: the mean of the Gaussian curvature times the area is the zone's integral of it.
#pragma once

#include <string>
#include <vector>

#include "geometry/curvature.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct CurvatureSummary {
    std::string name;
    double mean_mean_per_mm = 0.0;       ///< of (k1 + k2) / 2
    double sd_mean_per_mm = 0.0;         ///< over the zone
    double mean_gaussian_per_mm2 = 0.0;  ///< of k1 k2
    double mean_maximal_per_mm = 0.0;    ///< of k1
    double mean_minimal_per_mm = 0.0;    ///< of k2
    double bending_per_mm =
        0.0;  ///< root mean square of sqrt((k1^2 + k2^2) / 2): 0 only where flat
};

struct CurvatureReport {
    CurvatureField field;
    CurvatureSummary whole;
    std::vector<CurvatureSummary> zones;
};

/// Throws Status::invalid_mesh, Status::invalid_argument (radius), Status::mismatch (zones). O(0.1
/// ms #V).
CurvatureReport measure_curvature(const PointsRef& vertices, const TrianglesRef& triangles,
                                  const std::vector<Zone>& zones, const CurvatureOptions& options,
                                  const Context& context);

}  // namespace mien
