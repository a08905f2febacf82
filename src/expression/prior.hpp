// The prior of expression coordinates, learned from coordinates.
//
// Every expression e gets the mean and covariance of its training displacements, and a mean that
// moves with the person: displacements are regressed on the first identity coordinates, in closed
// form with a ridge that keeps what few people show small,
//     M = Y Z' (Z Z' + rho I)^-1,   Z whitened and centred,
// and the covariance is that of the residuals, each as if its own face had been left out (divided
// by sqrt(1 - its leverage)). Few samples do not determine a covariance: it is drawn towards the
// pooled within-expression covariance by a count of pseudo-samples, and a floor of a small share of
// the total variance keeps it definite and tolerant. "neutral" is a narrow Gaussian at zero, "any"
// the broad Gaussian of all displacements.
#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"
#include "expression/expression_model.hpp"

namespace mien {

/// Shares, pseudo-samples and ridge by hold-out over the training people of seed 1 (two folds of
/// five; 10 to 80 people for the first two), directions by one fold (tests/bench/README.md,
/// "What an expression may differ by").
struct PriorOptions {
    double floor_share = 1e-4;       ///< of the modes' variance, added to every covariance
    double pooled_samples = 0.5;     ///< pseudo-samples of the pooled covariance
    double neutral_share = 5e-4;     ///< variance of the neutral component, same unit
    Index min_samples = 3;           ///< expressions with fewer faces get no component of their own
    Index identity_directions = 40;  ///< of the person that an expression's mean follows, at most;
                                     ///< 0: none
    /// Faces of an expression from which on its mean follows the person. Set between 20 training
    /// people, who lose 2 % in hold-out and 5 % on test people, and 75, who gain 9 % in hold-out.
    /// 30 people gain 3 % in hold-out without the smooth prior, and lose 7 % on test people with
    /// it.
    Index min_followers = 50;
    /// Of the error of people left out that following must bring, 0 to 1. 100 ICT people gain 9 %;
    /// 60 of MakeHuman, whose expressions are alike for all, lose 1.3 %, and test people 19 %.
    double least_follow_gain = 0.01;
    double identity_ridge = 30.0;  ///< rho, > 0, in people of one deviation
    /// Shares of an expression that are tried (fit.hpp), above 0; where some expression has
    /// min_followers faces. {1}: at full strength only.
    std::vector<double> intensities = {1.0};
    double largest_leverage = 0.95;  ///< of a face on its own prediction, below 1
};

/// The intensities for a training set with these expressions: full strength only for small sets.
std::vector<double> intensities_for(const std::vector<int>& expression,
                                    const PriorOptions& options);

/// Components from displacements in mode coordinates (q x s) with their expressions, and the
/// identity coordinates (p x s, of deviations `identity_deviations`) of each one's person.
std::vector<ExpressionComponent> expression_components(
    const Matrix& coordinates, const std::vector<int>& expression,
    const std::vector<std::string>& names, const Vector& deviations, const Matrix& identities,
    const Vector& identity_deviations, const PriorOptions& options);

}  // namespace mien
