// Search of the pose without landmarks. The tip of the nose is what stands out along the viewing
// direction: for each direction over the whole sphere, the scan's summits along it are tried as the
// tip, with the template rolled about the direction; a rough score picks candidates, trimmed ICP
// sharpens them, a finer score decides.
//
//   score = mean over the probe of exp(-d^2 / 2 s^2) max(0, n_t . n_s)
//
// Directions and rolls are laid out in the scan's own frame (geometry/principal_frame.hpp): a scan
// that was turned before it was given is searched in the same steps, and ends in the same fit.
#pragma once

#include "model/deformation_model.hpp"
#include "registration/search_field.hpp"

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

/// Tags in brackets: registration/settings.hpp. All [J]: search scores of right poses are
/// 0.54 to 0.95, of wrong ones, halves and no faces 0.18 to 0.54.
struct SearchSettings {
    int views = 110;                 ///< >= 1: directions over the sphere, 17 degrees apart
    int rolls = 12;                  ///< >= 1: turns about each
    int summits = 4;                 ///< >= 1: per direction
    double summit_distance_mm = 30;  ///< mm, >= 0: between them
    double summit_facing = 0.6;      ///< cosine: a tip faces the viewer
    Index scan_vertices = 4000;      ///< >= 1: looked at for summits
    SearchFieldSettings field;
    ProbeSettings coarse{70, 75}, fine{400, 85};
    double probe_facing = 0.2;    ///< cosine to +z: the face, and not its sides
    Index fewest_probes = 10;     ///< fewer: the template shows no face towards +z
    double scout_scale_mm = 15;   ///< mm, > 0: of the rough score
    std::size_t sharpened = 120;  ///< >= 1: candidates that are sharpened after that
    SharpenSettings first{3, 15, 10}, second{15, 12, 3}, third{8, 5, 3};
    double coarse_scale_mm = 6, fine_scale_mm = 3;  ///< mm, > 0: of the scores
    double reach = 3;             ///< > 0, scales: farther hits are not looked for
    double overshoot = 1.5;       ///< >= 1: of a step towards the hit: point to point crawls
    double sharpen_facing = 0.2;  ///< cosine: pairs that face otherwise are left out
    double least_weight = 5;      ///< > 0: with less in sum a round has nothing to hold on to
    std::size_t candidates = 12;  ///< >= 1: sharpened further
    double good = 0.45;           ///< 0 to 1: below, the scan is tried turned inside out
    double turned_by = 0.05;      ///< >= 0: by how much that must score higher
};

struct SearchResult {
    Similarity motion;
    double score = 0;  ///< 0 to 1
};

/// Searches all rotations and any shift. Deterministic; a score of 0 where nothing of the scan
/// faces any way. Throws Status::no_solution when the template shows no face towards +z (its
/// frontal view, +y up). O(views rolls summits) rough scores.
SearchResult search_pose(const DeformationModel& model, const ScanView& scan,
                         const SearchSettings& settings, const Context& context);

/// When nothing good is found the scan may be `scan.turn_over()`ed: its triangles may face inwards.
SearchResult search_pose_and_side(const DeformationModel& model, ScanView& scan,
                                  const SearchSettings& settings, const Context& context);

}  // namespace mien
