// Solves A X = B for one sparse symmetric positive definite A and many right-hand sides, eight at a
// time: a triangular solve is bound by the traffic of its factor and of x, and eight right-hand
// sides share one pass. Neighbouring columns of the factor with the same rows (they are most of it)
// are taken up to four at a time, so that a row of x is fetched once for all of them.
#pragma once

#include <cstdint>
#include <Eigen/SparseCore>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// The factor L D L' of a matrix whose rows already stand in elimination order. Immutable; solve()
/// may run on several threads at once. The same bits on every instruction set (no fused
/// multiply-add), and per column the same bits as alone.
class BlockLdlt {
  public:
    static constexpr int kWidth = 8;

    BlockLdlt() = default;
    /// `what` names the matrix in the error: Status::no_solution when it is not positive definite.
    BlockLdlt(const Eigen::SparseMatrix<double>& matrix, const char* what);

    Index size() const { return static_cast<Index>(inverse_diagonal_.size()); }
    std::size_t num_entries() const { return values_.size(); }
    /// In place; `x` is size() rows of kWidth consecutive doubles.
    void solve(double* x) const;

  private:
    std::vector<double> values_;  ///< strictly lower L, column by column
    std::vector<std::int32_t> rows_;
    std::vector<std::int64_t> begin_;  ///< size() + 1
    std::vector<std::int32_t> group_;  ///< columns taken together, at the first of them
    std::vector<double> inverse_diagonal_;
};

/// new_of_old: a fill-reducing elimination order (approximate minimum degree) of a symmetric
/// pattern.
std::vector<std::int32_t> elimination_order(const Eigen::SparseMatrix<double>& pattern);

}  // namespace mien
