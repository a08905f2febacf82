// Volume between two surfaces that are not in correspondence, as clinics measure it today: the
// before surface is carried onto the after surface point by point, and the swept volume is measured
// as between faces in correspondence (volume.hpp).
//
// Carrying along one direction makes the volume a height-field integral, exact over the before
// triangles up to the resolution of the surfaces; the closest point and the vertex normal suit
// surfaces that turn away from any one direction, and underestimate where the change is not small
// against the surface's radius of curvature.
#pragma once

#include "base/context.hpp"
#include "geometry/rigid_zone.hpp"
#include "measure/volume.hpp"

namespace mien {

enum class Carry : std::int32_t { closest_point = 1, direction = 2, vertex_normal = 3 };

struct ScanVolumeOptions {
    Carry carry = Carry::closest_point;
    Vector3 direction = Vector3::UnitZ();  ///< any length but zero, for Carry::direction
    double max_distance_mm = 20.0;         ///< farther than that there is no partner
    std::vector<Zone> zones;               ///< of the before surface; empty: all of it
};

struct ScanVolumeReport {
    VolumeReport volume;
    Points carried;           ///< #V before: where each vertex went (itself when it has no partner)
    std::vector<char> valid;  ///< #V
    std::vector<double> zone_coverage;  ///< share of each zone's area that had a partner, 0 .. 1
    double whole_coverage = 0.0;
};

/// `after` must be aligned with `before` already. A triangle counts when all three vertices have a
/// partner. Throws Status::no_solution when none does, mismatch when they are not in one unit.
ScanVolumeReport measure_scan_volume(const TriMesh& before, const TriMesh& after,
                                     const ScanVolumeOptions& options, const Context& context);

struct ScanAlignmentOptions {
    RigidZoneOptions rigid;
    double max_distance_mm = 15.0;  ///< first round; shrinks to 2 mm with the residual
    int rounds = 40;
};

/// Iterated closest points from the zone of `target` (vertex numbers; empty: all) to `source`,
/// point to plane, robust. Pairs on borders do not count. `start` must bring the source within
/// max_distance_mm. The motion takes source to target.
RigidZoneResult align_scans_on_zone(const TriMesh& source, const TriMesh& target,
                                    const std::vector<std::uint32_t>& zone, const Similarity& start,
                                    const ScanAlignmentOptions& options, const Context& context);

/// Two fits of one template: by correspondence first, then by surface. A fit lies on its scan to a
/// tenth of a millimetre but slides along it by more than one, and a slide over the nose would tilt
/// the whole face.
RigidZoneResult align_fits_on_zone(const PointsRef& source, const TriMesh& target,
                                   const std::vector<std::uint32_t>& zone, const Context& context);

}  // namespace mien
