// From a raw scan to the template on it, in stages that each know only those before:
//
//   intake -> prior -> start -> fit -> gap -> inner parts -> verdict -> output
//
// Intake needs no model and the prior no scan, so a host that fits many times keeps either.
// Non-rigid ICP with a Gaussian process prior (chapter 2 of the thesis on registration).
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"
#include "model/deformation_model.hpp"
#include "registration/settings.hpp"

namespace mien {

struct RegistrationResult {
    TriMesh fitted;        ///< template topology, scan frame, mm
    Vector residual_mm;    ///< #V signed distance to the scan along the normal, NaN-free
    Vector weight;         ///< #V in [0, 1]: how much of the scan counted
    Vector confidence_mm;  ///< #V standard deviation of the place
    std::vector<SurfaceHit> correspondence;  ///< #V, on the scan as it was given
    std::vector<double> energy;              ///< one per iteration
    Similarity start, motion;                ///< template -> scan, before and after
    Verdict verdict;
    int iterations = 0;
    double sigma_mm = 0;                         ///< last noise level
    std::vector<std::string> unknown_landmarks;  ///< names the model does not have
};

/// Fits the model to `scan` (any unit). Landmarks, in the scan's unit, are matched by name; with at
/// least three that match the fit begins at them, else it searches the pose. Throws
/// Status::invalid_argument for settings out of range, invalid_mesh, not_found when too few
/// landmarks match, no_solution when the fit has nothing to hold on to. A second or two for a scan
/// of 50,000 vertices.
RegistrationResult register_scan(const DeformationModel& model, const TriMesh& scan,
                                 const std::vector<LandmarkPoint>& landmarks,
                                 const RegistrationSettings& settings, const Context& context);

/// The same from a scan that was prepared once (settings.intake is not read), and perhaps a prior
/// chosen before with the same model and settings.
RegistrationResult register_prepared(const DeformationModel& model, const PreparedScan& scan,
                                     const PriorState& prior,
                                     const std::vector<LandmarkPoint>& landmarks,
                                     const RegistrationSettings& settings, const Context& context);

}  // namespace mien
