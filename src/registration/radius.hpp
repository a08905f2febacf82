// How far may the true place of a vertex lie from the fitted one? The posterior says how the
// uncertainty spreads over the face (confidence.hpp), the verdict how large it is in each zone
// (expected_error.hpp): a deviation knows nothing of a mask that was taken for skin, or of a person
// whom the modes do not span. The radius has the first's pattern and the second's size:
//
//   radius_i = q f_z deviation_i,   f_z = s e_z / (mean deviation of zone z)
//
// z the smallest zone that holds vertex i, e_z its expected error, q of equal errors on three axes.
#pragma once

#include <vector>

#include "mesh/tri_mesh.hpp"
#include "registration/verdict.hpp"

namespace mien {

/// Set on fits that are in no table (tests/bench/README.md, "within the radius"): people of the
/// seeds 8001 to 8006, all conditions, fits that did not fail.
struct RadiusSettings {
    double of_sigma = 2.7955;   ///< q: root of the 95 % quantile of chi-squared with 3 freedoms
    double of_expected = 1.0;   ///< s, > 0: what held 95 of 100 places
    double least_factor = 0.6;  ///< > 0, on f
    double most_factor = 30;    ///< > least_factor: a lost fit's
};

/// #V, mm: holds the true place in 95 of 100 cases. `deviation_mm`: #V, per axis; empty: so is the
/// result. `zones`: those that the verdict names; without a verdict's expectation f is 1. O(V).
Vector radius95_mm(const Vector& deviation_mm, const Verdict& verdict,
                   const std::vector<Zone>& zones, const RadiusSettings& settings = {});

}  // namespace mien
