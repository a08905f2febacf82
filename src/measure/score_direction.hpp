// How faces change with a score: the displacement that goes with one grade.
//
// Regressing each coordinate on the grades gives y = d + R c + Z g: people differ by more than a
// score moves them, and by chance some of that goes with the grades of any hundred faces. What is
// known of this error is used. It lies in the span of the residuals of that regression, c ~ N(0, I)
// with R R' their covariance over (n - 2) times the grades' sum of squares. The faces' alignment
// shares what a score does in one place with all others, by one of the six motions Z. And what a
// score does, it does in some places more than in others. c and g minimise
//     |c|^2 / 2 + 2 m sum_v a_v sqrt(|(y - R c - Z g)_v| / b),   sum_v a_v = 1 by area, b the mean
//     length,
// by reweighted least squares (a hyper-Laplacian prior). m says how many independent places a face
// counts for; it has the least of Stein's unbiased risk in the metric of c, |c|^2 - K + 2 tr dc,
// over a ladder of values. Where that is not below 0.7 K, K being the risk of the regression as it
// is, the score changes all of the face, or there are too few faces to tell: the regression stands,
// and each vertex' slope is shrunk, d max(0, 1 - var(d) / |d|^2) (positive-part James-Stein).
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

struct ScoreDirection {
    Vector displacement;  ///< 3#V, mm per grade
    double places = 0;    ///< m; 0: the regression stands
};

/// mean_face #V x 3, displacements 3#V x n from it, areas #V >= 0, grades n, not all equal. O(#V
/// n^2) once, and O(n^2) per step for each of at most 1,500 vertices. Throws Status::no_solution
/// when the algebra fails.
ScoreDirection score_direction(const PointsRef& mean_face,
                               const Eigen::Ref<const Matrix>& displacements, const Vector& areas,
                               const Vector& grades, const Context& context);

/// How much each vertex counts for a score: the length of its displacement over the longest, and
/// not less than a hundredth; ones where the regression stands.
Vector focus_of(const ScoreDirection& direction);

}  // namespace mien
