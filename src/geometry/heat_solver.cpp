#include "geometry/heat_solver.hpp"

#include <algorithm>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include "base/error.hpp"

// The loops below are plain C, compiled twice: once for the processor the library is built for
// and once for AVX2. Fused multiply-add stays off, so both give the same bits.
#if defined(__GNUC__) && defined(__x86_64__)
#define MIEN_HEAT_AVX2 1
#define MIEN_HEAT_INLINE static inline __attribute__((always_inline))
#else
#define MIEN_HEAT_INLINE static inline
#endif

namespace mien {
namespace {

constexpr int kWidth = BlockLdlt::kWidth;

struct Factor {
    const double* values;
    const std::int32_t* rows;
    const std::int64_t* begin;
    const std::int32_t* group;
    const double* inverse_diagonal;
    std::int64_t size;
};

/// Entry (first + row, first + column) of a group's triangle.
MIEN_HEAT_INLINE double inner_entry(const Factor& f, std::int64_t first, int row, int column) {
    return f.values[f.begin[first + column] + (row - column - 1)];
}

/// Forward substitution with columns first .. first + Q - 1, which share their rows below.
template <int Q>
MIEN_HEAT_INLINE void forward_group(const Factor& f, std::int64_t first, double* __restrict x) {
    double y[Q][kWidth];
    for (int a = 0; a < Q; ++a)
        for (int c = 0; c < kWidth; ++c) y[a][c] = x[(first + a) * kWidth + c];
    for (int a = 0; a < Q; ++a)
        for (int b = a + 1; b < Q; ++b) {
            const double l = inner_entry(f, first, b, a);
            for (int c = 0; c < kWidth; ++c) y[b][c] -= l * y[a][c];
        }
    for (int a = 1; a < Q; ++a)
        for (int c = 0; c < kWidth; ++c) x[(first + a) * kWidth + c] = y[a][c];
    const std::int64_t count = f.begin[first + Q] - f.begin[first + Q - 1];
    const std::int32_t* rows = f.rows + f.begin[first + Q - 1];
    const double* value[Q];
    for (int a = 0; a < Q; ++a) value[a] = f.values + f.begin[first + a] + (Q - 1 - a);
    for (std::int64_t p = 0; p < count; ++p) {
        double* __restrict xi = x + static_cast<std::int64_t>(rows[p]) * kWidth;
        double sum[kWidth];
        for (int c = 0; c < kWidth; ++c) sum[c] = xi[c];
        for (int a = 0; a < Q; ++a) {
            const double l = value[a][p];
            for (int c = 0; c < kWidth; ++c) sum[c] -= l * y[a][c];
        }
        for (int c = 0; c < kWidth; ++c) xi[c] = sum[c];
    }
}

/// Division by D and backward substitution with the same columns.
template <int Q>
MIEN_HEAT_INLINE void backward_group(const Factor& f, std::int64_t first, double* __restrict x) {
    double y[Q][kWidth];
    for (int a = 0; a < Q; ++a)
        for (int c = 0; c < kWidth; ++c)
            y[a][c] = x[(first + a) * kWidth + c] * f.inverse_diagonal[first + a];
    const std::int64_t count = f.begin[first + Q] - f.begin[first + Q - 1];
    const std::int32_t* rows = f.rows + f.begin[first + Q - 1];
    const double* value[Q];
    for (int a = 0; a < Q; ++a) value[a] = f.values + f.begin[first + a] + (Q - 1 - a);
    for (std::int64_t p = 0; p < count; ++p) {
        const double* __restrict xi = x + static_cast<std::int64_t>(rows[p]) * kWidth;
        for (int a = 0; a < Q; ++a) {
            const double l = value[a][p];
            for (int c = 0; c < kWidth; ++c) y[a][c] -= l * xi[c];
        }
    }
    for (int a = Q - 1; a >= 0; --a)
        for (int b = a + 1; b < Q; ++b) {
            const double l = inner_entry(f, first, b, a);
            for (int c = 0; c < kWidth; ++c) y[a][c] -= l * y[b][c];
        }
    for (int a = 0; a < Q; ++a)
        for (int c = 0; c < kWidth; ++c) x[(first + a) * kWidth + c] = y[a][c];
}

MIEN_HEAT_INLINE void solve_block(const Factor& f, double* __restrict x) {
    for (std::int64_t j = 0; j < f.size; j += f.group[j]) {
        switch (f.group[j]) {
            case 4:
                forward_group<4>(f, j, x);
                break;
            case 3:
                forward_group<3>(f, j, x);
                break;
            case 2:
                forward_group<2>(f, j, x);
                break;
            default:
                forward_group<1>(f, j, x);
                break;
        }
    }
    // A group's length also stands at its last column, where the way back meets it first.
    for (std::int64_t end = f.size; end > 0;) {
        const std::int64_t j = end - f.group[end - 1];
        switch (f.group[end - 1]) {
            case 4:
                backward_group<4>(f, j, x);
                break;
            case 3:
                backward_group<3>(f, j, x);
                break;
            case 2:
                backward_group<2>(f, j, x);
                break;
            default:
                backward_group<1>(f, j, x);
                break;
        }
        end = j;
    }
}

void solve_portable(const Factor& f, double* x) {
    solve_block(f, x);
}

#if defined(MIEN_HEAT_AVX2)
__attribute__((target("avx2"))) void solve_avx2(const Factor& f, double* x) {
    solve_block(f, x);
}

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
    // Column j belongs to column j - 1 when that one's rows are j and j's own.
    group_.assign(static_cast<std::size_t>(n), 1);
    const auto follows = [&](Index j) {
        const std::int64_t before = begin_[static_cast<std::size_t>(j) - 1];
        const std::int64_t here = begin_[static_cast<std::size_t>(j)];
        const std::int64_t after = begin_[static_cast<std::size_t>(j) + 1];
        return here - before == after - here + 1 && rows_[static_cast<std::size_t>(before)] == j &&
               std::equal(rows_.begin() + here, rows_.begin() + after, rows_.begin() + before + 1);
    };
    for (Index j = 0; j < n;) {
        Index size = 1;
        while (size < 4 && j + size < n && follows(j + size)) ++size;
        group_[static_cast<std::size_t>(j)] = group_[static_cast<std::size_t>(j + size) - 1] =
            static_cast<std::int32_t>(size);
        j += size;
    }
    const Vector diagonal = factor.vectorD();
    inverse_diagonal_.resize(static_cast<std::size_t>(n));
    for (Index j = 0; j < n; ++j) inverse_diagonal_[static_cast<std::size_t>(j)] = 1 / diagonal[j];
}

void BlockLdlt::solve(double* x) const {
    const Factor f{values_.data(),           rows_.data(), begin_.data(), group_.data(),
                   inverse_diagonal_.data(), size()};
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
