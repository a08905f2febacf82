// The Nystrom basis (2.5)-(2.12) of a scalar kernel: K ~ C W+ C' with C the kernel's columns at
// control points and W its block among them.
//
// Departures: (2.10) inverts W; here only its eigenvalues above a relative threshold are used,
// since the geodesic kernel has negative ones and every smooth kernel has vanishing ones. (2.11)
// keeps the leading vectors of W, which are neither orthogonal nor ordered on the whole surface;
// here the columns are turned into the principal directions of C W+ C' itself, so that a cut after
// any number of modes is the best one.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

struct RankOptions {
    Index num_modes = 333;    ///< scalar modes kept at most, >= 1
    double tolerance = 0;     ///< > 0: stop once this share of the variance is left, 0 .. 1
    double threshold = 1e-4;  ///< eigenvalues of W below this share of the largest are dropped
};

struct LowRankReport {
    Index rank = 0;  ///< scalar modes
    Index num_control_points = 0;
    double variance_explained = 0;   ///< sum of the modes' variance / sum of k(x, x)
    double max_variance_error = 0;   ///< max over x of |k(x, x) - modes' variance at x| / max k
    double negative_mass = 0;        ///< sum of |negative eigenvalues| / sum of |eigenvalues| of W
    Index num_negative = 0;          ///< negative eigenvalues of W beyond rounding
    double smallest_eigenvalue = 0;  ///< of W, relative to the largest
};

struct LowRankBasis {
    Eigen::MatrixXf basis;  ///< #V x r, orthogonal columns, strongest first, largest entry positive
    std::vector<std::int8_t> parity;  ///< r: +1 even, -1 odd about x = 0; empty without symmetry
    Vector eigenvalues;  ///< r: squared column norm / #V, the operator's with mass 1/#V a vertex
    LowRankReport report;
};

/// K ~ factor factor' from `columns` (#V x m, overwritten and freed): (2.11) with the eigenvalues
/// of W above the threshold. Fills what `report` says of W. O(#V m^2 + m^3), memory one more #V x m
/// matrix.
Matrix nystrom_factor(Matrix& columns, const std::vector<std::uint32_t>& control_points,
                      const RankOptions& options, LowRankReport& report, const Context& context);

/// Turns `factor` (#V x q) into the principal directions of K and cuts them; `diagonal` holds
/// k(x, x), against which the report measures.
LowRankBasis principal_basis(const Matrix& factor, const Vector& diagonal,
                             const RankOptions& options, const Context& context);

}  // namespace mien
