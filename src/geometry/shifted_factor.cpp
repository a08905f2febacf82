#include "geometry/shifted_factor.hpp"

#include <cmath>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

namespace mien {

ShiftedFactor::ShiftedFactor(const SparseMatrix& a, double shift) : shift_(shift) {
    SparseMatrix shifted = a.triangularView<Eigen::Lower>();
    for (Index j = 0; j < shifted.cols(); ++j) shifted.coeffRef(j, j) -= shift;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(shifted);
    if (factor.info() != Eigen::Success) return;
    const Vector pivots = factor.vectorD();
    if (!pivots.allFinite()) return;
    num_below_ = (pivots.array() < 0).count();
    inverse_pivots_ = pivots.cwiseInverse();
    if (!inverse_pivots_.allFinite()) return;
    lower_ = factor.matrixL().nestedExpression();
    ok_ = true;
}

void ShiftedFactor::solve(double* x) const {
    constexpr int b = kSolveBlock;
    const int* outer = lower_.outerIndexPtr();
    const int* inner = lower_.innerIndexPtr();
    const double* value = lower_.valuePtr();
    const Index n = lower_.cols();
    for (Index j = 0; j < n; ++j) {
        double pivot_row[b];
        for (int c = 0; c < b; ++c) pivot_row[c] = x[j * b + c];
        for (int p = outer[j]; p < outer[j + 1]; ++p) {
            double* row = x + static_cast<Index>(inner[p]) * b;
            const double v = value[p];
            for (int c = 0; c < b; ++c) row[c] -= v * pivot_row[c];
        }
    }
    for (Index j = n; j-- > 0;) {
        double sum[b];
        const double pivot = inverse_pivots_[j];
        for (int c = 0; c < b; ++c) sum[c] = x[j * b + c] * pivot;
        for (int p = outer[j]; p < outer[j + 1]; ++p) {
            const double* row = x + static_cast<Index>(inner[p]) * b;
            const double v = value[p];
            for (int c = 0; c < b; ++c) sum[c] -= v * row[c];
        }
        for (int c = 0; c < b; ++c) x[j * b + c] = sum[c];
    }
}

std::vector<int> fill_reducing_order(const SparseMatrix& a) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    SparseMatrix pattern = a;
    Eigen::AMDOrdering<int> order;
    order(pattern.selfadjointView<Eigen::Lower>(), inverse);
    // Eigen's order lists the old index of each new place.
    std::vector<int> place(static_cast<std::size_t>(a.cols()));
    for (Index i = 0; i < a.cols(); ++i)
        place[static_cast<std::size_t>(inverse.indices()[i])] = static_cast<int>(i);
    return place;
}

}  // namespace mien
