// The LDL' factorisation of A - s I for a sparse symmetric A: the inertia that counts eigenvalues
// below s, and solves for several right-hand sides at once without allocation.
#pragma once

#include <vector>

#include "geometry/laplacian.hpp"

namespace mien {

/// Right-hand sides of one solve. Eight doubles are a cache line: each entry of the factor is read
/// once for all of them.
constexpr int kSolveBlock = 8;

class ShiftedFactor {
  public:
    /// `a` holds at least the lower triangle of a symmetric matrix already in a fill-reducing
    /// order. ok() is false when a pivot vanishes or an entry is not finite.
    ShiftedFactor(const SparseMatrix& a, double shift);

    bool ok() const { return ok_; }
    double shift() const { return shift_; }
    /// Number of eigenvalues of A below the shift (Sylvester: the negative pivots).
    Index num_below() const { return num_below_; }
    /// Overwrites x (n x kSolveBlock, row-major) by (A - s I)^-1 x.
    void solve(double* x) const;

  private:
    double shift_ = 0;
    bool ok_ = false;
    Index num_below_ = 0;
    SparseMatrix lower_;  // strictly lower triangle of L
    Vector inverse_pivots_;
};

/// Approximate minimum degree order of a symmetric matrix: result[i] = new place of row i.
std::vector<int> fill_reducing_order(const SparseMatrix& a);

}  // namespace mien
