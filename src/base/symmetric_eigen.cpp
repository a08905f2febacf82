#include "base/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"

namespace mien {
namespace {

// A small matrix is not worth the panels; judgement, not measured.
constexpr Index kSmall = 200;

using Solver = Eigen::SelfAdjointEigenSolver<Matrix>;

void check(const Solver& solver, const char* what, Index n) {
    if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite())
        fail(Status::no_solution, "the eigenvalues of %s (%lld x %lld) did not converge", what,
             static_cast<long long>(n), static_cast<long long>(n));
}

/// Vectors that are orthonormal to half the digits become so to all: one step of Newton and Schulz.
void orthonormalise(Matrix& z, const Context& context) {
    const Index k = z.cols();
    Matrix gram(k, k), fixed(z.rows(), k);
    dense::weighted_gram(context, z, Vector(), gram);
    gram *= -0.5;
    gram.diagonal().array() += 1.5;
    dense::multiply(context, 1.0, z, dense::Op::none, gram, dense::Op::none, 0.0, fixed);
    z.swap(fixed);
}

}  // namespace

SymmetricSpectrum::SymmetricSpectrum(Matrix& matrix, const char* what, const Context& context)
    : what_(what) {
    const Index n = matrix.rows();
    if (matrix.cols() != n)
        fail(Status::internal, "eigenvalues of a matrix of %lldx%lld", static_cast<long long>(n),
             static_cast<long long>(matrix.cols()));
    if (n < kSmall) {
        if (n == 0) return;
        const Solver solver(matrix);
        check(solver, what, n);
        values_ = solver.eigenvalues();
        all_ = solver.eigenvectors();
        return;
    }
    // Squares of huge and of tiny numbers leave the range of a double; a power of two costs no bit.
    double largest = 0;
    for (Index j = 0; j < n; ++j)
        largest = std::max(largest, matrix.col(j).tail(n - j).cwiseAbs().maxCoeff());
    if (largest > 0 && std::isfinite(largest)) {
        scale_ = std::exp2(std::ilogb(largest));
        matrix /= scale_;
    }
    reduced_ = std::make_unique<Tridiagonalization>(matrix, context);
    const Tridiagonal& t = reduced_->result();
    Solver solver;
    solver.computeFromTridiagonal(t.diagonal, t.beside, Eigen::EigenvaluesOnly);
    check(solver, what, n);
    values_ = solver.eigenvalues() * scale_;
}

Matrix SymmetricSpectrum::strongest(Index k, const Context& context) const {
    return vectors(values_.size() - k, k, context);
}

Matrix SymmetricSpectrum::vectors(Index first, Index k, const Context& context) const {
    if (k < 0 || first < 0 || first + k > values_.size())
        fail(Status::internal, "%lld eigenvectors from number %lld of %lld",
             static_cast<long long>(k), static_cast<long long>(first),
             static_cast<long long>(values_.size()));
    if (!reduced_) return all_.middleCols(first, k);
    Matrix found;
    const Tridiagonal& t = reduced_->result();
    if (tridiagonal_eigenvectors(t, values_.segment(first, k) / scale_, found, context)) {
        orthonormalise(found, context);
    } else {
        // Values so close that inverse iteration cannot part them: the QR iteration can.
        Solver solver;
        solver.computeFromTridiagonal(t.diagonal, t.beside);
        check(solver, what_, values_.size());
        found = solver.eigenvectors().middleCols(first, k);
    }
    reduced_->turn_back(found, context);
    return found;
}

}  // namespace mien
