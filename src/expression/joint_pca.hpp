// The two subspaces of J 4.2-4.3 from coordinates in a joint span.
//
// Joint PCA (4.11, 4.12): P and Q are the leading eigenvectors of XX' and YY'.
// Quasi-orthogonal joint PCA (4.28-4.31): alternately the leading eigenvectors of
//     k XX' - lambda Q Q'   and   YY' - lambda P P',
// k the number of expression faces per neutral face, until neither subspace turns any more.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

enum class TrainMethod : std::int32_t { joint_pca = 0, quasi_orthogonal = 1 };

struct JointPcaOptions {
    TrainMethod method = TrainMethod::joint_pca;
    Index identity_modes = 50, expression_modes = 50;
    double lambda = 0.0;  ///< quasi-orthogonal; 0: lambda_factor x top eigenvalue of k XX'
    double lambda_factor = 10.0;
    int max_iterations = 1000;
    double angle_tolerance_rad = 1e-3;  ///< largest principal angle between consecutive subspaces
};

struct JointPca {
    Matrix identity, expression;  ///< r x p, r x q, orthonormal columns, strongest first
    double k = 1.0, lambda = 0.0;
    Vector
        start_orthogonality;  ///< scores of joint PCA, where the quasi-orthogonal iteration starts
    int iterations = 0;
    double last_angle_rad = 0.0;
    bool converged = true;
};

/// X and Y as coordinates in one orthonormal basis (r rows). Fewer modes come back than asked for
/// where the data have no more directions.
JointPca joint_pca(const Context& context, const Matrix& neutrals, const Matrix& displacements,
                   const JointPcaOptions& options);

/// ||P_c Q_c'|| (Frobenius) with the first c columns of both, c = 1 .. min(p, q): figure 4.6.
Vector orthogonality_scores(const Matrix& identity, const Matrix& expression);

/// Leading eigenvectors (up to `count`, eigenvalue above 1e-12 of the largest) of a symmetric
/// matrix, each with its largest component positive.
Matrix leading_eigenvectors(const Matrix& symmetric, Index count, Vector* values);

}  // namespace mien
