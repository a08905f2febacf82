// Intraclass correlation, all six forms of Shrout & Fleiss 1979 with the F tests and intervals of
// McGraw & Wong 1996, from one two-way analysis of variance.
#pragma once

#include "base/types.hpp"

namespace mien {

struct IntraclassCorrelation {
    double icc = 0.0;
    double f = 0.0;  ///< test of icc = 0
    double degrees1 = 0.0, degrees2 = 0.0;
    double p_value = 1.0;
    double low = 0.0, high = 0.0;  ///< confidence interval
};

struct IccReport {
    IntraclassCorrelation icc1, icc2, icc3;     ///< single rating: one-way, two-way random, mixed
    IntraclassCorrelation icc1k, icc2k, icc3k;  ///< mean of the k ratings
    double mean_square_subjects = 0.0, mean_square_raters = 0.0, mean_square_within = 0.0,
           mean_square_error = 0.0;
};

/// scores: subjects x raters (or captures), complete and finite, at least 2 x 2. confidence in
/// (0, 1). Throws Status::invalid_argument otherwise, Status::no_solution when every score is
/// equal.
IccReport intraclass_correlation(const Eigen::Ref<const Matrix>& scores, double confidence = 0.95);

}  // namespace mien
