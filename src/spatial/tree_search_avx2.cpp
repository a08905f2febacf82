// The same loops for AVX2 with FMA.
#if defined(MIEN_AVX2)

#include <immintrin.h>

#include "spatial/tree_search.hpp"

#define MIEN_LOOPS avx2_loops
#include "spatial/tree_search.inc"

#endif
