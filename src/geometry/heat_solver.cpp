#include "geometry/heat_solver.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include "base/error.hpp"

// The two loops below are plain C, compiled twice: once for the processor the library is built for
// and once for AVX2. Fused multiply-add stays off, so both give the same bits.
#if defined(__GNUC__) && defined(__x86_64__)
#define MIEN_HEAT_AVX2 1
#define MIEN_HEAT_INLINE static inline __attribute__((always_inline))
#else
#define MIEN_HEAT_INLINE static inline
#endif

namespace mien {
namespace {

constexpr int kW = BlockLdlt::kWidth;

struct Factor {
    const double* values;
    const std::int32_t* rows;
    const std::int64_t* begin;
    const double* inverse_diagonal;
    std::int64_t size;
};

MIEN_HEAT_INLINE void solve_block(const Factor& f, double* __restrict x) {
    for (std::int64_t j = 0; j < f.size; ++j) {
        double xj[kW];
        for (int c = 0; c < kW; ++c) xj[c] = x[j * kW + c];
        for (std::int64_t p = f.begin[j]; p < f.begin[j + 1]; ++p) {
            const double l = f.values[p];
            double* __restrict xi = x + static_cast<std::int64_t>(f.rows[p]) * kW;
            for (int c = 0; c < kW; ++c) xi[c] -= l * xj[c];
        }
    }
    for (std::int64_t j = f.size - 1; j >= 0; --j) {
        double xj[kW];
        const double d = f.inverse_diagonal[j];
        for (int c = 0; c < kW; ++c) xj[c] = x[j * kW + c] * d;
        for (std::int64_t p = f.begin[j]; p < f.begin[j + 1]; ++p) {
            const double l = f.values[p];
            const double* __restrict xi = x + static_cast<std::int64_t>(f.rows[p]) * kW;
            for (int c = 0; c < kW; ++c) xj[c] -= l * xi[c];
        }
        for (int c = 0; c < kW; ++c) x[j * kW + c] = xj[c];
    }
}

void solve_portable(const Factor& f, double* x) { solve_block(f, x); }

#if defined(MIEN_HEAT_AVX2)
__attribute__((target("avx2"))) void solve_avx2(const Factor& f, double* x) { solve_block(f, x); }

bool has_avx2() {
    static const bool supported = [] {
        __builtin_cpu_init();
        return __builtin_cpu_supports("avx2") != 0;
    }();
    return supported;
}
#endif

}  // namespace

BlockLdlt::BlockLdlt(const Eigen::SparseMatrix<double>& matrix, const char* what) {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
        factor(matrix);
    const bool solved = factor.info() == Eigen::Success;
    if (!solved || !(factor.vectorD().minCoeff() > 0))
        fail(Status::no_solution, "the %s matrix of the surface is not positive definite", what);
    const Eigen::SparseMatrix<double>& lower = factor.matrixL().nestedExpression();
    const Index n = lower.cols();
    begin_.reserve(static_cast<std::size_t>(n) + 1);
    begin_.push_back(0);
    values_.reserve(static_cast<std::size_t>(lower.nonZeros()));
    rows_.reserve(static_cast<std::size_t>(lower.nonZeros()));
    for (Index j = 0; j < n; ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, j); it; ++it)
            if (it.row() > j) {
                values_.push_back(it.value());
                rows_.push_back(static_cast<std::int32_t>(it.row()));
            }
        begin_.push_back(static_cast<std::int64_t>(values_.size()));
    }
    const Vector diagonal = factor.vectorD();
    inverse_diagonal_.resize(static_cast<std::size_t>(n));
    for (Index j = 0; j < n; ++j) inverse_diagonal_[static_cast<std::size_t>(j)] = 1 / diagonal[j];
}

void BlockLdlt::solve(double* x) const {
    const Factor f{values_.data(), rows_.data(), begin_.data(), inverse_diagonal_.data(), size()};
#if defined(MIEN_HEAT_AVX2)
    if (has_avx2()) return solve_avx2(f, x);
#endif
    solve_portable(f, x);
}

std::vector<std::int32_t> elimination_order(const Eigen::SparseMatrix<double>& pattern) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
    // AMD returns old = order(new).
    std::vector<std::int32_t> new_of_old(static_cast<std::size_t>(pattern.cols()));
    for (Index k = 0; k < pattern.cols(); ++k)
        new_of_old[static_cast<std::size_t>(order.indices()[k])] = static_cast<std::int32_t>(k);
    return new_of_old;
}

}  // namespace mien
