// The search loops for the build's own instruction set (SSE2 on x86-64, NEON on aarch64).
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "spatial/tree_search.hpp"

#define MIEN_LOOPS portable_loops
#include "spatial/tree_search.inc"
