// One slice of a spectrum: the eigenpairs of a sparse symmetric matrix nearest to a shift, by block
// Lanczos on (A - s I)^-1 (Grimes, Lewis & Simon 1994).
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "geometry/shifted_factor.hpp"

namespace mien {

/// The known null space of the matrix: one vector a connected component, each supported on its
/// component alone, so that removing all of them costs one pass.
struct KernelProjector {
    std::vector<std::int32_t> component;  ///< n
    Vector direction;                     ///< n, of norm 1 on each component
    Index num_components = 0;

    void remove(Eigen::Ref<Matrix> block) const;
};

/// Pairs around a shift. The first `num_below` columns are the eigenvalues below it, ascending, the
/// rest the ones above it, ascending.
struct SlicePairs {
    Vector values;
    Matrix vectors;  ///< n x m, orthonormal
    Index num_below = 0;
};

/// The `below` nearest eigenpairs below the factor's shift (the kernel's left out) and the `above`
/// nearest above it, each without a gap. Deterministic; runs on the calling thread and checks
/// cancellation. Throws Status::no_solution when the Lanczos space grows to n or `limit` vectors
/// without converging.
SlicePairs slice_eigenpairs(const ShiftedFactor& factor, const KernelProjector& kernel, Index below,
                            Index above, std::uint64_t seed, const Context& context);

}  // namespace mien
