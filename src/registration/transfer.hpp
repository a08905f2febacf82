// Landmarks, contours and zones between a fitted template and the scan under it, both ways
// (1.2, 5.2). Both lie in one frame, so a place goes to the nearest place of the other surface that
// faces the same way.
#pragma once

#include <string>
#include <vector>

#include "mesh/tri_mesh.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {

/// A place farther away than this has no place on the other surface unless the caller says so: a
/// landmark on an ear that was not scanned must not end on the cheek.
inline constexpr double kTransferDistanceMm = 10;

enum class TransferDirection : std::int32_t { to_scan = 0, to_template = 1 };

/// Trees over both surfaces. Immutable; keeps copies.
class SurfaceTransfer {
  public:
    /// Throws Status::invalid_mesh when the template has no triangles, mismatch when the two are
    /// not in one unit.
    SurfaceTransfer(const TriMesh& fitted, const TriMesh& scan, const Context& context);

    /// Nearest places on the other surface; beyond max_distance_mm the hit is invalid.
    std::vector<SurfaceHit> points(const PointsRef& places, TransferDirection direction,
                                   double max_distance_mm, const Context& context) const;

    /// Vertices of the other surface whose nearest place on this one lies in the zone: the
    /// barycentric share of the zone's vertices is at least one half, and it is within
    /// max_distance_mm. Ascending.
    std::vector<std::uint32_t> zone(const std::vector<std::uint32_t>& vertices,
                                    TransferDirection direction, double max_distance_mm,
                                    const Context& context) const;

    const TriMesh& fitted() const { return fitted_; }
    const TriMesh& scan() const { return scan_; }

  private:
    void check_units(const Context& context) const;
    TriMesh fitted_, scan_;
    TriangleTree fitted_tree_, scan_tree_;
};

/// {"points": {name: [x, y, z]}, "distances_mm": {...}} of the model's landmarks on the scan.
std::string transferred_landmarks_json(const SurfaceTransfer& transfer,
                                       const std::vector<Landmark>& landmarks,
                                       double max_distance_mm, const Context& context);
/// {"zones": {name: [scan vertex, ...]}} of the model's zones.
std::string transferred_zones_json(const SurfaceTransfer& transfer, const std::vector<Zone>& zones,
                                   double max_distance_mm, const Context& context);

}  // namespace mien
