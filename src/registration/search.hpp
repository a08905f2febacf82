// Search of the pose without landmarks. The tip of the nose is what stands out along the viewing
// direction: for each rotation of a grid, the scan's local summits along that direction are tried
// as the tip; a coarse score picks candidates, trimmed ICP sharpens them, a finer score decides.
//
//   score = mean over the probe of exp(-d^2 / 2 s^2) max(0, n_t . n_s)
#pragma once

#include "model/deformation_model.hpp"
#include "registration/scan_surface.hpp"

namespace mien {

/// Vertices of the template's face that a pose is judged by, thinned to an even grid.
struct ProbeSettings {
    Index vertices;    ///< >= 10, about
    double radius_mm;  ///< mm, > 0: about the nose's tip
};

/// Robust point-to-point rounds with a scale that shrinks.
struct SharpenSettings {
    int rounds;               ///< >= 0
    double start_mm, end_mm;  ///< mm, > 0: scale of the weights, first and last
};

/// Tags in brackets: registration/settings.hpp. All by judgement: search scores of right poses are
/// 0.56 to 0.95, of wrong ones and no faces 0.18 to 0.54.
struct SearchSettings {
    double range_deg = 66, step_deg = 22;  ///< deg, > 0: rotations off the model's frontal view
    int summits = 4;                       ///< >= 1: per rotation
    double summit_distance_mm = 30;        ///< mm, >= 0: between them
    double summit_facing = 0.6;            ///< cosine: a tip faces the viewer
    Index scan_vertices = 4000;            ///< >= 1: looked at for summits
    ProbeSettings coarse{70, 75}, fine{400, 85};
    double probe_facing = 0.2;  ///< cosine to +z: the face, and not its sides
    Index fewest_probes = 10;   ///< fewer: the template shows no face towards +z
    SharpenSettings first{3, 15, 10}, second{15, 12, 3}, third{8, 5, 3};
    double coarse_scale_mm = 6, fine_scale_mm = 3;  ///< mm, > 0: of the scores
    double reach = 3;             ///< > 0, scales: farther hits are not looked for
    double overshoot = 1.5;       ///< >= 1: of a step towards the hit: point to point crawls
    double sharpen_facing = 0.2;  ///< cosine: pairs that face otherwise are left out
    double least_weight = 5;      ///< > 0: with less in sum a round has nothing to hold on to
    std::size_t candidates = 12;  ///< >= 1: sharpened further
    double good = 0.45;           ///< 0 to 1: below, the scan is tried turned inside out
    double turned_by = 0.05;      ///< >= 0: by how much that must score higher
    // All rotations, when the frontal ones find nothing sure
    double sure = 0.75;                ///< 0 to 1: below, all rotations are tried too
    double all_step_deg = 33;          ///< deg, > 0: between them, about each turn of the cube
    double all_scale_mm = 15;          ///< mm, > 0: of the first score, without sharpening
    std::size_t all_candidates = 150;  ///< >= 1: sharpened after that
};

struct SearchResult {
    Similarity motion;
    double score = 0;  ///< 0 to 1
};

/// Searches rotations about the model's frontal view (+z out of the face, +y up) and any shift.
/// Deterministic. Throws Status::no_solution when the template shows no face towards +z.
SearchResult search_pose(const DeformationModel& model, const ScanView& scan,
                         const SearchSettings& settings, const Context& context);

/// Searches all rotations and any shift. Deterministic; three times the cost.
SearchResult search_all_poses(const DeformationModel& model, const ScanView& scan,
                              const SearchSettings& settings, const Context& context);

/// Frontal rotations first, all when these find nothing sure. When nothing good is found the scan
/// may be `scan.turn_over()`ed: its triangles may face inwards.
SearchResult search_pose_and_side(const DeformationModel& model, ScanView& scan,
                                  const SearchSettings& settings, const Context& context);

}  // namespace mien
