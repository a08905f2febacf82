// Stage 1, intake: a raw scan becomes one that fits can use: cleaned, in millimetres, weighted, in
// a search tree. Nothing here knows a model, so one prepared scan serves any number of fits.
#pragma once

#include "mesh/winding.hpp"
#include "registration/scan_pieces.hpp"
#include "registration/scan_surface.hpp"
#include "registration/skin.hpp"
#include "registration/units.hpp"

namespace mien {

struct IntakeSettings {
    UnitRule units = UnitRule::detect;
    bool skin_weights = false;  ///< weigh scan vertices by the probability of skin colour
    Vector weight_per_vertex;   ///< the host's, per vertex of the raw scan in [0, 1], or empty
    double unit_to_mm = 0;      ///< mm, > 0: one unit of the scan when it is known; 0: by `units`
    UnitSettings unit;
    WindingSettings windings;
    SkinSettings skin;
    PieceSettings pieces;
    ColorSignalSettings signals;
    double image_radius_mm = 0.7;  ///< mm, 0 to 5: the disc of a texture image whose mean a look
                                   ///< takes: what a scan of 1.4 mm between vertices shows [J]
    ScanSurfaceSettings surface;
};

/// Immutable; safe to share between threads and fits.
struct PreparedScan {
    ScanSurface surface;    ///< mm
    double unit_to_mm = 1;  ///< what one unit of the raw scan was taken for
    std::vector<std::uint32_t> vertex_to_raw, triangle_to_raw;  ///< numbers as the scan was given
    std::vector<std::uint8_t> turned;  ///< 1 per triangle whose corners 1 and 2 changed places to
                                       ///< be wound as the others; empty: none
    Index num_turned = 0;
    double outward = 0;  ///< -1 to 1, how far the surface faces away from its middle

    PieceFindings pieces;

    /// The raw scan's number of the primitive (triangle, or point of a cloud) that was hit.
    std::uint32_t raw_primitive(const SurfaceHit& hit) const {
        return surface.tree.is_point_cloud() ? vertex_to_raw[hit.triangle]
                                             : triangle_to_raw[hit.triangle];
    }
    /// The hit's barycentric coordinates in the order of the raw triangle's corners.
    Vector3 raw_barycentric(const SurfaceHit& hit) const {
        if (surface.tree.is_point_cloud() || turned.empty() || !turned[hit.triangle])
            return hit.barycentric;
        return Vector3(hit.barycentric[0], hit.barycentric[2], hit.barycentric[1]);
    }
};

/// Throws Status::invalid_mesh when nothing usable is left, mismatch for weights of another number
/// than vertices, invalid_argument for weights outside of [0, 1] and for a unit that the rule
/// refuses. O(V + F log F).
PreparedScan prepare_scan(const TriMesh& raw, const IntakeSettings& settings,
                          const Context& context);

}  // namespace mien
