// The loops for the build's own instruction set (SSE2 on x86-64, NEON on aarch64).
#include "base/dense_kernels.hpp"

#define MIEN_KERNELS portable
#include "base/dense_kernels.inc"
