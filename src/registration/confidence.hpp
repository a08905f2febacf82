// How sure is a fit of each place? The posterior covariance of the coefficients, carried to the
// vertices, plus what the coefficients cannot know: the modes left out, and places where nothing
// was scanned.
//
//   Sigma = (I + sum_i w_i (n_i' B_i)' (n_i' B_i) / sigma^2 + sum_pins B' B / s^2)^-1,
//   deviation_i^2 = f_i^2 (tr B_i Sigma B_i' + left_i (1 - 0.7 w_i)) / 3
//
// B_i a vertex' modes times their prior deviations, left_i the prior variance of the modes left
// out, f_i a calibrated factor between that beside the scan and that away from it.
#pragma once

#include "registration/prior.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ConfidenceSettings {
    Index pca_modes = 80;            ///< >= 0: strongest trained modes in the posterior [J]
    Index kernel_modes_beside = 30;  ///< >= 0: strongest kernel modes beside trained ones [J]
    Index kernel_modes_alone = 60;   ///< >= 0: and without [J]
    Index rows = 1500;             ///< >= 1, about: places that stand for the surface. Neighbours'
                                   ///< errors are alike, so each counts as one observation of
                                   ///< the surface's plane, and not as one per vertex [J]
    double least_weight = 0.05;    ///< 0 to 1: places seen less are left out [J]
    double least_sigma_mm = 0.5;   ///< mm, > 0: floor of an observation's noise [J]
    double least_variance = 1e-4;  ///< > 0: floor of a mode's prior variance [J]
    /// Share of the modes left out that the surface and its curvature tell, 0 to 1. [T] as the
    /// factors
    double seen_share = 0.7;
    /// Factors, > 0, for what the formula leaves out: hits that slide together, noise that is not
    /// independent, faces outside the training span, and, away from the scan, all that no
    /// observation checks. Set on scans of other people than those that the tables are made with,
    /// so that the 95 % radius holds nine of ten or more. [T] "within the radius"
    double beside_trained = 2.3, beside_kernel = 1.7, away_trained = 4.0, away_kernel = 3.15;
};

/// #V standard deviations per axis (root mean square of the three), mm. Dense algebra over the
/// strongest modes only: a few hundred unknowns. `weight`: final robust weight of each vertex;
/// `normals_model`: #V x 3, model frame; `sigma_mm`: last noise level. Throws Status::no_solution
/// when the information of the modes is not positive definite.
Vector place_deviation(const DeformationModel& model, const FitState& state,
                       const FitFreedom& freedom, const Vector& weight,
                       const PointsRef& normals_model, const std::vector<Pin>& pins,
                       double sigma_mm, const ConfidenceSettings& settings, const Context& context);

}  // namespace mien
