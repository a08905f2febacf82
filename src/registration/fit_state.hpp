// What a fit changes, and what it goes by: spoken by the start, the fit and all after it.
#pragma once

#include <vector>

#include "registration/color_features.hpp"
#include "registration/scan_surface.hpp"
#include "registration/solver.hpp"

namespace mien {

/// A template vertex held to a place, scan frame.
struct Pin {
    Index vertex = 0;
    Vector3 place = Vector3::Zero();
    double sigma_mm = 1.5;  ///< standard deviation per axis, > 0
};

/// The unknowns of a fit, and the shape that they give.
struct FitState {
    Similarity motion;  ///< model frame -> scan frame
    FitCoefficients coefficients;
    Eigen::MatrixXf kernel_mean;  ///< r x 3: kernel coefficients that the prior expects (an open
                                  ///< jaw); empty: zeros
    double kernel_amplitude = 1;  ///< factor on the kernel's standard deviation
    Points displacement;          ///< #V x 3, model frame; empty before the first fit
    Points places;                ///< #V x 3, scan frame; empty before the first fit

    /// How far the kernel's coefficients are from those that the prior expects.
    Eigen::MatrixXf kernel_off() const {
        if (kernel_mean.rows() == 0) return coefficients.kernel;
        return coefficients.kernel - kernel_mean.topRows(coefficients.kernel.rows());
    }
};

/// What a fit goes by. Borrowed: all must outlive the fit.
struct FitProblem {
    const DeformationModel& model;
    const ScanView& scan;
    const std::vector<std::uint8_t>& inner;  ///< #V: 1 is excluded from correspondence (inner.hpp)
    const ColorFeatures& colors;             ///< perhaps empty
    const std::vector<Pin>& pins;            ///< perhaps empty
};

}  // namespace mien
