// The same loops for AVX2 with FMA.
#if defined(MIEN_AVX2)

#include <immintrin.h>

#include "learning/network_loops.hpp"

#define MIEN_LOOPS avx2_loops
#include "learning/network_loops.inc"

#endif
