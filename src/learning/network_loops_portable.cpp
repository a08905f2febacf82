// The loops for the build's own instruction set (SSE2 on x86-64, NEON on aarch64).
#include <cstdint>
#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__ARM_NEON) && defined(__aarch64__)
#include <arm_neon.h>
#endif
#include <cstring>

#include "learning/network_loops.hpp"

#define MIEN_LOOPS portable_loops
#include "learning/network_loops.inc"
