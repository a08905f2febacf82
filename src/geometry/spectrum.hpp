// The first eigenpairs of a Laplacian by spectrum slicing: several shift-invert runs side by side,
// the inertia of each shifted LDL' factorisation as the count that proves none is missing or
// double.
#pragma once

#include <functional>

#include "base/context.hpp"
#include "geometry/laplacian.hpp"

namespace mien {

struct EigenPairs {
    Vector values;   ///< k, ascending, 1/mm^2
    Matrix vectors;  ///< #V x k, M-orthonormal: vectors' M vectors = I, signs fixed (see .cpp)
};

/// The k smallest eigenpairs of stiffness u = lambda mass u. Deterministic, same bits for any
/// thread count. Throws Status::invalid_argument for k < 1 or k >= #V, Status::no_solution when a
/// factorisation or an iteration fails (the message names the shift). `progress`, where given, is
/// called on the calling thread with the share that is done, 0 to 1.
EigenPairs smallest_eigenpairs(const LaplaceOperator& laplace, Index k, const Context& context,
                               const std::function<void(double)>& progress = {});

}  // namespace mien
