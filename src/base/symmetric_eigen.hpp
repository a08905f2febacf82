// All eigenvalues of a large symmetric matrix, and its strongest eigenvectors without the weak
// ones.
//
// A QR iteration with vectors (Eigen::SelfAdjointEigenSolver) turns every vector at every step and
// makes no use of the caches. Here the matrix becomes tridiagonal a panel at a time (Dongarra,
// Sorensen and Hammarling 1989), the QR iteration gives its eigenvalues alone, inverse iteration
// gives the vectors that are asked for, and products of matrices carry them back. Small
// matrices go to Eigen's solver.
#pragma once

#include <memory>

#include "base/context.hpp"
#include "base/tridiagonal.hpp"
#include "base/types.hpp"

namespace mien {

class SymmetricSpectrum {
  public:
    /// `matrix` (n x n) is read in its lower triangle, overwritten, and must live as long as this
    /// object. 4/3 n^3. Throws no_solution for a matrix that is not finite or does not converge;
    /// `what` names it there. The same bits for any number of threads.
    SymmetricSpectrum(Matrix& matrix, const char* what, const Context& context);

    const Vector& values() const { return values_; }  ///< n, ascending
    /// n x k, orthonormal: the vectors of the k largest values, ascending like these. 2 n^2 k.
    Matrix strongest(Index k, const Context& context) const;
    /// The same of the values `first` to before first + k.
    Matrix vectors(Index first, Index k, const Context& context) const;

  private:
    const char* what_;
    double scale_ = 1;  ///< of a large matrix, a power of two
    Vector values_;
    Matrix all_;                                   ///< every vector, of a small matrix
    std::unique_ptr<Tridiagonalization> reduced_;  ///< of a large one
};

}  // namespace mien
