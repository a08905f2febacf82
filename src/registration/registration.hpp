// From a raw scan to the template on it: start, correspondence, weighted solve, grown mode by mode
// and sharpened noise level by noise level (non-rigid ICP, 2.5), then what is left of the gap.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"
#include "model/deformation_model.hpp"
#include "registration/correspondence.hpp"
#include "registration/verdict.hpp"

namespace mien {

/// The numbers are the C ABI's numbers.
enum class ModeGrowth : std::int32_t { constant = 0, linear = 1, exponential = 2, cubic = 3 };

/// Where a fit begins.
enum class StartKind : std::int32_t {
    automatic = 0,  ///< landmarks when at least three match, else a search over all poses
    landmarks = 1,
    pose = 2,  ///< given by the host
    search = 3,
};

/// What one unit of the scan is.
enum class UnitRule : std::int32_t {
    detect = 0,       ///< by the size of what was scanned; scale to millimetres
    millimetres = 1,  ///< as given
    refuse = 2,       ///< throw Status::invalid_argument when it does not look like millimetres
};

struct RegistrationOptions {
    // Start
    StartKind start = StartKind::automatic;
    Similarity pose;  ///< template -> scan (mm), for StartKind::pose
    UnitRule units = UnitRule::detect;
    bool skin_weights = false;  ///< weigh scan vertices by the probability of skin colour
    Vector scan_weights;        ///< one per scan vertex in [0, 1], or empty
    // Prior
    ModeGrowth growth = ModeGrowth::constant;
    Index max_scalar_modes = -1;  ///< -1: all of the model's (three deformation modes each)
    Index max_pca_modes = -1;     ///< -1: all of the model's
    double kernel_amplitude =
        0;  ///< factor on the kernel's standard deviation; 0: the landmarks' likeliest
    double pca_amplitude = 1;
    // Data
    double landmark_sigma_mm = 2;  ///< picking error per axis
    double sigma_start_mm = 3;     ///< noise level of a surface hit, first ...
    double sigma_end_mm = 0.5;     ///< ... and last
    double robust_factor = 2;      ///< robust scale in noise levels
    double tangential =
        0.1;  ///< weight of sliding along the surface against leaving it; 1: point to point
    double normal_length_mm =
        5;  ///< how far a turn of the normal by one radian counts as a shift; 0: not
    double data_weight = 0.03;  ///< independent hits per vertex (neighbours' errors are alike)
    CorrespondenceOptions correspondence;
    bool color_features =
        true;  ///< lips and brows hold the fit along the skin where the scan has colours
    double color_weight = 0.1;  ///< independent observations of them per vertex
    // Loop
    int iterations = 16;
    double stop_movement_mm = 0.01;  ///< mean movement below which the last noise level ends
    double sparse_rounds = 0.85;  ///< share of the rounds that look at a part of the vertices only
    Index sparse_stride = 3;      ///< and that part: one in so many
    double solver_tolerance =
        0.1;  ///< by how much a round reduces its equations' residual; the next goes on
    bool estimate_motion = true;
    int estimate_scale =
        -1;  ///< 1, 0, or -1: only for models without trained modes (those know sizes)
    double residual_sd_mm =
        0.7;  ///< what trained modes leave to the kernel, when its amplitude is automatic
    Index max_residual_modes = 250;  ///< and the scalar modes spent on it
    // Approach, when no landmark holds the fit
    double approach_sigma_mm = 12;  ///< noise level of its first round; it ends at sigma_start_mm
    int approach_rounds = 30;
    double approach_weight = 0.05;
    double approach_tangential = 0.02;
    Index approach_pca_modes = 40;
    Index approach_scalar_modes = 20;
    double free_data_weight = 0.02;  ///< of the fit after it: hits that slide together tell less
    double free_color_weight = 0.13;
    // Rest
    bool close_gap = true;  ///< smooth residual field along the normals
    double gap_smoothness = 20;
    bool repair = true;  ///< straighten folded triangles
    double max_turn_rad =
        1.05;  ///< against their neighbourhood, before a triangle counts as folded
    double normal_smoothing_mm = 2;
};

struct RegistrationResult {
    TriMesh fitted;        ///< template topology, scan frame, mm
    Vector residual_mm;    ///< #V signed distance to the scan along the normal, NaN-free
    Vector weight;         ///< #V in [0, 1]: how much of the scan's say counted
    Vector confidence_mm;  ///< #V standard deviation of the place
    std::vector<SurfaceHit> correspondence;  ///< #V, on the scan
    std::vector<double> energy;              ///< one per iteration
    Similarity start, motion;                ///< template -> scan, before and after
    Verdict verdict;
    int iterations = 0;
    double sigma_mm = 0;                         ///< last noise level
    std::vector<std::string> unknown_landmarks;  ///< names the model does not have
};

/// Fits the model to `scan` (mm). Landmarks are matched by name; at least three must match. Throws
/// Status::invalid_argument for settings out of range, invalid_mesh, not_found when too few
/// landmarks match, no_solution when the fit has nothing to hold on to.
RegistrationResult register_scan(const DeformationModel& model, const TriMesh& scan,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationOptions& options, const Context& context);

}  // namespace mien
