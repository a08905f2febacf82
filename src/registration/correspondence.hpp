// Which place of the scan does each template vertex stand for? Closest point on the surface, then
// filters, then a robust weight that falls with the distance: hair, collars, spikes and the far rim
// of a hole lose weight instead of being cut off at once (2.5.2.3 names the filters).
//
// Every filter is a ramp: at a hard cut rounding decides, and a turned scan ends elsewhere.
#pragma once

#include <limits>
#include <vector>

#include "base/context.hpp"
#include "registration/scan_surface.hpp"

namespace mien {

enum class RobustWeight { none, welsch, huber, tukey };

/// Tags in brackets: registration/settings.hpp.
struct CorrespondenceSettings {
    bool reject_border = true;  ///< hits on the scan's border [A]
    double border_ramp = 0.2;   ///< > 0, share of the way to the border's next row of vertices over
                                ///< which a hit gains its weight [J]
    double max_angle_deg = 60;  ///< > 0: between the normals of vertex and hit; from 180: no filter
                                ///< [A]
    double angle_ramp_deg = 5;  ///< > 0: to both sides of it [J]
    double max_distance_mm = std::numeric_limits<double>::infinity();  ///< mm, > 0
    double limit_mm = std::numeric_limits<double>::infinity();  ///< mm, > 0: farther hits do not
                                                                ///< count; infinite: no filter
    double limit_ramp = 0.2;  ///< 0 to 1: share of the limit over which they lose their weight [J]
    /// mm, > 0: mutual neighbours. The place nearest to a hit, of all that look for theirs, may lie
    /// so far from the one that the hit was found for, and counts in full up to half of it;
    /// infinite: not asked. Below the template's spacing hardly any hit is mutual.
    double mutual_mm = std::numeric_limits<double>::infinity();
    /// mm, >= 0: soft assignment. A vertex stands for the mean of the scan around its hit, weighed
    /// by a Gaussian of this deviation; 0: for the hit itself.
    double soft_mm = 0;
    RobustWeight robust = RobustWeight::welsch;  ///< [A]
    double robust_scale_mm = 3;  ///< mm, > 0: where the weight falls to exp(-1/2) (Welsch); the
                                 ///< rounds of a fit set their own
};

struct Correspondences {
    std::vector<SurfaceHit> hits;  ///< #V; also the next round's hints. Softly assigned ones keep
                                   ///< the nearest triangle, and hold the mean's point and distance
    Points normals;                ///< #V x 3 of the scan at the hit, scan frame
    Vector weight;                 ///< #V, 0 where a filter refused the hit
};

/// `places` and `place_normals` are the template's, #V x 3, scan frame. Old hits in `result` are
/// used as hints. Vertices that `left_out` marks (#V, or none) are not looked for: weight 0, no
/// hit. O(#V log F); seven times as many searches when soft, one more when mutual.
void find_correspondences(const ScanView& scan, const PointsRef& places,
                          const PointsRef& place_normals, const CorrespondenceSettings& settings,
                          Correspondences& result, const Context& context,
                          const std::vector<std::uint8_t>& left_out = {});

/// Weight of a residual: 1 at zero. `scale` in the residual's unit.
double robust_weight(RobustWeight kind, double residual, double scale);

}  // namespace mien
