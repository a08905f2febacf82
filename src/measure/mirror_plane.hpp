// The plane that divides a face into left and right: of all planes the one whose reflection brings
// each place closest to its partner on the other side.
//
// Minimises sum_v w_v |x_v - H x_m(v)|^2 over reflections H about n . x = d, m the template's
// mirror map. With weights that are alike for partners the centroid lies in the plane, and n is the
// eigenvector of the smallest eigenvalue of sum w sym(x_v x_m(v)'), x about the centroid: closed
// form. What is truly asymmetric must not turn the plane: weights are first those of least absolute
// distances, then Tukey's bisquare.
//
// Covariance: s^2 (sum w J'J)^-1 n / n_eff with s^2 the mean squared distance per axis, and n_eff =
// area of one side / (2 pi l^2) independent places: neighbours are asymmetric, and slide, together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/types.hpp"

namespace mien {

struct MirrorPlaneSettings {
    /// Tukey's cut-off in robust deviations of the distance, > 0; 4.685 keeps 95 % of the precision
    /// for normal errors.
    double cutoff = 4.685;
    /// Below it a robust deviation is not believed, mm, > 0: exact faces have none.
    double least_deviation_mm = 0.01;
    /// Over which pairs go together, mm, >= 0: a template slides along the skin by wide stretches.
    /// Measured on 24 fits of simulated scans, whose planes lay three times farther from the true
    /// faces' than 15 mm had said, and held against 24 others (tests/bench/README.md).
    double correlation_length_mm = 45.0;
    /// Pairs that go together where no length says so (0 mm), >= 1.
    double pairs_together = 1.0;
    int max_rounds = 50;  ///< of either weighting, 1 to 1000
};

struct MirrorPlane {
    Vector3 normal = Vector3::UnitX();  ///< unit, to the subject's left
    Vector3 centre = Vector3::Zero();   ///< in the plane, of the places that counted, mm
    double rms_mm = 0.0;                ///< of the distances between partners, weighted
    Index pairs = 0;                    ///< partners with a weight, and places of the plane itself
    /// Of (tilt about either direction of the plane, rad; offset at the centre, mm), in that order
    /// in the frame of directions().
    Matrix3 covariance = Matrix3::Zero();

    double offset_mm() const { return normal.dot(centre); }  ///< n . x = offset
    Vector3 reflect(const Vector3& x) const { return x - 2 * normal.dot(x - centre) * normal; }
    /// Two unit vectors of the plane.
    std::array<Vector3, 2> directions() const;
    /// A reflected copy moves rigidly when the plane does, by twice as much: covariance of its
    /// (rotation about `centre`, rad; translation, mm).
    Eigen::Matrix<double, 6, 6> motion_covariance() const;
    /// Root mean square over both directions, rad.
    double tilt_sd_rad() const;
    double offset_sd_mm() const;
};

/// The template's mirror map, and its side: +1 left, 0 in the plane, -1 right, #V each.
struct MirrorMap {
    std::vector<std::uint32_t> partner;
    std::vector<std::int8_t> side;
};
/// From a map (model/mirror.hpp) and the template that it was made of (about x = 0, +x left).
MirrorMap mirror_sides(std::vector<std::uint32_t> partner, const PointsRef& template_vertices);

/// points: #V x 3; weights: #V, >= 0 (areas). Throws Status::mismatch for lengths that differ,
/// Status::no_solution for fewer than three pairs with a weight, or pairs without extent. O(rounds
/// #V).
MirrorPlane find_mirror_plane(const PointsRef& points, const MirrorMap& map, const Vector& weights,
                              const MirrorPlaneSettings& settings);

}  // namespace mien
