// The loop of a fit: correspond, solve, move, with more modes and less assumed noise each round.
#pragma once

#include <vector>

#include "registration/color_features.hpp"
#include "registration/registration.hpp"
#include "registration/solver.hpp"

namespace mien {

/// A template vertex held to a place, scan frame.
struct Pin {
    Index vertex = 0;
    Vector3 place = Vector3::Zero();
    double sigma_mm = 1.5;
};

/// What the loop changes, and what it goes by.
struct FitState {
    Similarity motion;  ///< model frame -> scan frame
    FitCoefficients coefficients;
    Points displacement;                    ///< #V x 3, model frame
    Points places;                          ///< #V x 3, scan frame
    std::vector<std::uint8_t> inner;        ///< #V or empty: vertices without a say (inner.hpp)
    const ColorFeatures* colors = nullptr;  ///< of the scan, or null
    Correspondences matches;
    std::vector<Correspondences> color_matches;
    Vector final_weight;  ///< #V, of the last round
    std::vector<double> energy;
    int iterations = 0;
    double kernel_amplitude = 1;
    double sigma_mm = 0;
};

/// Number of scalar modes at progress f in [0, 1] of the way to `all`.
Index modes_at(ModeGrowth growth, double f, Index first, Index all);

/// Deforms towards the pins alone: the posterior mean given the landmarks (2.2.3).
void fit_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const RegistrationOptions& options, FitState& state, const Context& context);

void fit_surface(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                 const std::vector<Pin>& pins, const RegistrationOptions& options, FitState& state,
                 const Context& context);

}  // namespace mien
