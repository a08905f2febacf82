// Partial least squares regression, NIPALS and SIMPLS, and its cross-validation.
//
// Both look for directions of the predictors X (n x p) that covary most with the responses Y (n x
// m). NIPALS (Wold 1975; Martens & Naes 1989) deflates X itself; SIMPLS (de Jong 1993) deflates
// X'Y. With one response they are the same regression; with several they part from the second
// component on, because SIMPLS maximises the covariance of original X and Y under orthogonal
// scores.
//
// Departure: NIPALS' inner loop is a power iteration for the first singular vector of X'Y; its
// limit is taken from the m x m eigenproblem instead, so there is no tolerance to choose.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

using ConstMatrixRef = Eigen::Ref<const Matrix>;

enum class PlsMethod { nipals, simpls };

struct PlsOptions {
    PlsMethod method = PlsMethod::nipals;
    int num_components = 2;  ///< 1 .. min(n - 1, p)
    bool scale = false;      ///< divide predictors by their deviations (constant ones stay)
};

struct PlsModel {
    PlsMethod method = PlsMethod::nipals;
    Vector x_mean, x_scale;  ///< p
    Vector y_mean;           ///< m
    Matrix weights;          ///< p x A; NIPALS: orthonormal; SIMPLS: equal to rotations
    Matrix rotations;        ///< p x A: scores = centred X * rotations
    Matrix x_loadings;       ///< p x A
    Matrix y_loadings;       ///< m x A
    Matrix scores;           ///< n x A, orthogonal
    Vector x_explained;      ///< A, share of X's variance per component
    Vector y_explained;      ///< A, share of Y's variance per component
    Index num_samples = 0;

    /// May be fewer than asked for: the covariance with Y was used up before.
    Index num_components() const { return rotations.cols(); }
    /// p x m, for the first `components` (0: prediction is the mean).
    Matrix coefficients(Index components) const;
    Matrix predict(const ConstMatrixRef& x, Index components) const;
    /// Scores of new samples, n x A.
    Matrix project(const ConstMatrixRef& x) const;
};

/// Throws Status::invalid_argument for fewer than 2 samples, sizes that differ, values that are not
/// finite or too many components; Status::no_solution when X or Y does not vary or X'Y vanishes.
PlsModel fit_pls(const ConstMatrixRef& x, const ConstMatrixRef& y, const PlsOptions& options,
                 const Context& context);

struct CrossValidationOptions {
    PlsMethod method = PlsMethod::nipals;
    int max_components = 10;  ///< cut to what the smallest training fold allows
    int folds = 0;            ///< 0: leave one (group) out; otherwise 2 .. number of groups
    std::uint64_t seed = 1;   ///< of the shuffle into folds
    bool scale = false;       ///< per training fold
    /// One number per sample; samples of one group (a person's captures) never part. Empty: every
    /// sample is its own group.
    std::vector<int> groups;
    /// Optional: factors on the predictors' columns, learned from these samples alone. Runs on
    /// several threads.
    std::function<Vector(const std::vector<Index>& training)> column_factors;
};

struct CrossValidation {
    Matrix predictions;         ///< n x (A + 1), column a: a components; column 0: the mean
    Vector mean_squared_error;  ///< A + 1
    Vector standard_error;      ///< A + 1, of the mean over groups
    std::vector<int> fold;      ///< n
    int best_components = 0;    ///< least error
    /// Fewest components whose error lies within one standard error of the least (Breiman et al.
    /// 1984; Hastie et al. 2009, 7.10).
    int one_standard_error_components = 0;
    double r2(int components) const;  ///< 1 - error / error of the mean
};

/// One response. Exact for any p: unscaled predictors are turned into their n x n principal
/// coordinates first, which changes no prediction (PLS is invariant under rotation). Folds run in
/// parallel; same bits for any thread count.
CrossValidation cross_validate_pls(const ConstMatrixRef& x, const Vector& y,
                                   const CrossValidationOptions& options, const Context& context);

}  // namespace mien
