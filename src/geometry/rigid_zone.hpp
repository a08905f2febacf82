// Rigid alignment of one face to another on a stable zone (forehead, nose bridge): what must not
// have changed decides where "before" and "after" lie, and how surely.
//
// Minimises sum_i w_i r_i' M_i r_i over motions, r_i = R p_i + t - q_i, M_i = n_i n_i' + tau (1 -
// n_i n_i'). A fitted template slides over smooth skin by much more than it lifts off, so that
// tangential differences weigh less (tau = 1 is Horn's least squares). Tukey's bisquare of the
// normal residual keeps what did change out.
//
// Covariance: s^2 (sum w J' M J)^-1 n / n_eff, s^2 the mean of r' M r. Errors of neighbours go
// together: n_eff = area / (2 pi l^2) independent places, l being the correlation length.
#pragma once

#include <vector>

#include "base/types.hpp"
#include "geometry/surface_errors.hpp"

namespace mien {

struct RigidZoneOptions {
    double tangential = 0.1;                               ///< tau, 0 < tau <= 1
    double correlation_length_mm = kSurfaceCorrelationMm;  ///< >= 0
    int iterations = 30;
};

struct RigidZoneResult {
    Similarity motion;                 ///< source -> target, scale 1
    double rms_mm = 0.0;               ///< along the normal, over the pairs that counted
    Index pairs = 0;                   ///< with a weight above zero
    Vector3 centre = Vector3::Zero();  ///< of the zone on the target
    /// Of (rotation vector about `centre`, translation): rad^2, rad mm, mm^2.
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Pairs of points with normals (unit, of the target) and areas (mm^2) per pair; robust as above,
/// starting from `start`. Throws Status::no_solution for fewer than 10 pairs or pairs without
/// extent.
RigidZoneResult align_pairs(const PointsRef& source, const PointsRef& target,
                            const PointsRef& normals, const Vector& areas, const Similarity& start,
                            const RigidZoneOptions& options);

/// Faces in correspondence; `zone` empty: all vertices.
RigidZoneResult align_on_zone(const PointsRef& source, const PointsRef& target,
                              const TrianglesRef& triangles, const std::vector<std::uint32_t>& zone,
                              const RigidZoneOptions& options);

}  // namespace mien
