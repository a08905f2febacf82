// Which place of the scan does each template vertex stand for? Closest point on the surface, then
// filters, then a robust weight that falls with the distance: hair, collars, spikes and the far rim
// of a hole lose their say instead of being cut off at once (2.5.2.3 names the filters).
#pragma once

#include <vector>

#include "base/context.hpp"
#include "base/scalar_math.hpp"
#include "registration/scan_surface.hpp"

namespace mien {

enum class RobustWeight { none, welsch, huber, tukey };

struct CorrespondenceOptions {
    bool reject_border = true;  ///< hits on the scan's border
    double max_angle_deg = 60;  ///< between the normals of vertex and hit, fading over 5 degrees to
                                ///< both sides; 180: no filter
    double max_distance_mm = 1e30;
    bool mutual = false;  ///< the hit's nearest template vertex must be near the vertex
    double mutual_distance_mm = 3;
    RobustWeight robust = RobustWeight::welsch;
    double robust_scale_mm = 3;  ///< where the weight falls to exp(-1/2) (Welsch)
};

struct Correspondences {
    std::vector<SurfaceHit> hits;  ///< #V; also the next round's hints
    Points normals;                ///< #V x 3 of the scan at the hit, scan frame
    Vector weight;                 ///< #V, 0 where a filter said no
};

/// `places` and `place_normals` are the template's, #V x 3, scan frame. `scan_weight` is empty or
/// one weight per scan vertex. Old hits in `result` are used as hints.
void find_correspondences(const ScanSurface& scan, const PointsRef& places,
                          const PointsRef& place_normals, const Vector& scan_weight,
                          const CorrespondenceOptions& options, Correspondences& result,
                          const Context& context);

/// Weight of a residual: 1 at zero.
double robust_weight(RobustWeight kind, double residual, double scale);

}  // namespace mien
