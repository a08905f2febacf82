// What evidence says of the vertices that a step of a fit looks at: for each of them a quadratic
//
//   (x + u - q)' H (x + u - q)
//
// in its displacement u, H symmetric and semidefinite, summed over all evidence.
#pragma once

#include "base/types.hpp"

namespace mien {

/// One row per vertex that the step looks at, model frame. A row of zeros says nothing about its
/// vertex.
struct FitTerms {
    Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor>
        precision;  ///< sum of H: xx yy zz xy xz yz, 1/mm^2
    Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> pull;  ///< sum of H (q - x - mean)

    void reset(Index num_rows);
    /// Any H with its H (q - x - mean).
    void add(Index row, const Matrix3& precision, const Vector3& pull);
    /// H = weight I: a point held to a point. `target_displacement`: q - x - mean.
    void add_isotropic(Index row, double weight, const Vector3& target_displacement);
    /// H = weight (n n' + tau (I - n n')): a point held to a plane, and by tau along it.
    void add_planar(Index row, double weight, double tau, const Vector3& normal,
                    const Vector3& target_displacement);
};

}  // namespace mien
