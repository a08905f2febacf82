// Symmetric tridiagonal matrices: the form that a symmetric matrix is turned into, and eigenvectors
// there.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien {

struct Tridiagonal {
    Vector diagonal;  ///< n
    Vector beside;    ///< n - 1
};

/// Q' A Q = T with Q a product of n - 1 reflections, a panel of which is applied as one product.
class Tridiagonalization {
  public:
    /// A's lower triangle is read and overwritten by the reflections, so it must live on. 4/3 n^3.
    Tridiagonalization(Matrix& a, const Context& context);

    const Tridiagonal& result() const { return result_; }
    /// z = Q z for n x k columns; 2 n^2 k.
    void turn_back(Matrix& z, const Context& context) const;

  private:
    Index reduce_panel(Index first, Matrix& both, const Context& context);
    void update_rest(Index first, Index size, const Matrix& both, const Context& context);

    Matrix& a_;
    Tridiagonal result_;
    Vector tau_;
};

/// Orthonormal eigenvectors (n x k) of eigenvalues (k, ascending, as exact as they come) by inverse
/// iteration; neighbours that rounding cannot tell apart are made orthogonal to each other. False
/// when one of them is no eigenvector to 1e-10 of the matrix's norm.
bool tridiagonal_eigenvectors(const Tridiagonal& matrix, const Vector& values, Matrix& vectors,
                              const Context& context);

}  // namespace mien
