// Where a fit begins: robust alignment to landmarks, or a search over poses for scans without any.
#pragma once

#include <string>
#include <vector>

#include "model/deformation_model.hpp"
#include "registration/nicp.hpp"
#include "registration/scan_surface.hpp"

namespace mien {

/// Motion that brings most of the pinned vertices near their places, whatever a minority does: the
/// best of many three-point motions by the median distance (least median of squares), then a
/// reweighted least-squares fit. Throws Status::no_solution when the pins lie on a line.
Similarity align_robustly(const DeformationModel& model, const std::vector<Pin>& pins,
                          bool with_scale);

/// Numbers of pins that the others, under the model's prior, contradict: leave-one-out prediction
///   r_k = (C^-1 d)_k, S_k = (C^-1)_kk,  reject while max r_k' S_k^-1 r_k > limit,
/// C the prior covariance of the pinned places plus picking noise plus a free motion. Needs at
/// least five pins. When more than a tenth of them would go, none does: then it is the face that
/// the prior did not expect, not the picking.
std::vector<std::size_t> contradicting_pins(const DeformationModel& model,
                                            const std::vector<Pin>& pins, const Similarity& motion,
                                            double kernel_amplitude, double pca_amplitude);

/// Factors on the kernel's deviation (1/8 to 8; 1 when trained modes take part) and on the pins'
/// picking error (1/4 to 1.4).
struct PinEvidence {
    double amplitude = 1, noise = 1;
};
/// Under which the pins' displacements are likeliest (marginal likelihood, motions left out); ones
/// for fewer than ten pins.
PinEvidence weigh_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                       const Similarity& motion, double kernel_amplitude, double pca_amplitude);

struct SearchResult {
    Similarity motion;
    double score =
        0;  ///< share of the template's inner face near the scan, facing the same way, 0..1
};

/// Searches rotations up to about 65 degrees off the model's frontal view (+z out of the face, +y
/// up) and any shift. Deterministic.
SearchResult search_pose(const DeformationModel& model, const ScanSurface& scan,
                         const Context& context);

/// What one unit of the scan is in mm, by its extent: 1, 10, 25.4, 100 or 1000; 0 when nothing fits
/// a head.
double detect_unit_mm(const PointsRef& vertices);

}  // namespace mien
