// The same loops for AVX2 with FMA. Eigen gets another name here, so that the linker can never take
// one of its functions from this file for a processor that cannot run it.
#if defined(MIEN_AVX2)

#define Eigen EigenAvx2
#include "base/dense_kernels.hpp"

#define MIEN_KERNELS avx2
#include "base/dense_kernels.inc"

#endif
