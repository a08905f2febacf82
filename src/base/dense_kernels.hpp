// The seam between dense.cpp and its two builds: plain pointers only, so that nothing of the
// standard library or Eigen is shared between object files of different instruction sets.
#pragma once

#include <cstddef>

namespace mien::dense {

template <typename Scalar>
struct Kernels {
    /// C (m x n) = alpha op(A) op(B) + beta C, inner size k.
    void (*gemm)(bool transpose_a, bool transpose_b, std::ptrdiff_t m, std::ptrdiff_t n,
                 std::ptrdiff_t k, Scalar alpha, const Scalar* a, std::ptrdiff_t lda,
                 const Scalar* b, std::ptrdiff_t ldb, Scalar beta, Scalar* c, std::ptrdiff_t ldc);
    /// Lower triangle of C (n x n) += A' A for A (k x n).
    void (*gram)(std::ptrdiff_t n, std::ptrdiff_t k, const Scalar* a, std::ptrdiff_t lda, Scalar* c,
                 std::ptrdiff_t ldc);
    /// Cholesky of the lower triangle in place. False: not positive definite.
    bool (*factor_spd)(std::ptrdiff_t n, Scalar* a, std::ptrdiff_t lda);
    /// n x m right-hand sides by that factor, in place.
    void (*solve_factored)(std::ptrdiff_t n, std::ptrdiff_t m, const Scalar* factor,
                           std::ptrdiff_t ldf, Scalar* b, std::ptrdiff_t ldb);
    using Thin = void (*)(std::ptrdiff_t m, std::ptrdiff_t k, const Scalar* a, std::ptrdiff_t lda,
                          const Scalar* in, std::ptrdiff_t ld_in, Scalar* out,
                          std::ptrdiff_t ld_out);
    Thin expand_thin;     ///< Y (m x 3) += A X for A (m x k), X (k x 3)
    Thin project_thin;    ///< X (k x 3) = A' Y
    Thin expand_four;     ///< the same for four columns
    Thin project_four;    ///< the same for four columns
    Thin expand_column;   ///< the same for one column
    Thin project_column;  ///< the same for one column
    /// below (m) += A right and right_sum (k) += A' left for A (m x k): both halves of a symmetric
    /// product while A is read once.
    void (*two_sided)(std::ptrdiff_t m, std::ptrdiff_t k, const Scalar* a, std::ptrdiff_t lda,
                      const Scalar* right, const Scalar* left, Scalar* below, Scalar* right_sum);
};

const Kernels<double>& portable_kernels_f64();
const Kernels<float>& portable_kernels_f32();
#if defined(MIEN_AVX2)
const Kernels<double>& avx2_kernels_f64();
const Kernels<float>& avx2_kernels_f32();
#endif

}  // namespace mien::dense
