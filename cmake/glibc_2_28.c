/* Names of the C library that the prebuilt Linux archives take in their older form, so that they
 * run with glibc 2.28 (2018) and later; linked into the library and the programs where
 * MIEN_SELF_CONTAINED is on, hidden from everything else.
 *
 * exp, exp2, log, log2 and pow exist twice: the versions of glibc 2.29 leave out the wrapper that
 * serves the error handlers of System V and return the same bits for every argument
 * (tests/bindings/glibc_math.c). */
#define _DEFAULT_SOURCE
#if defined(__x86_64__)
#define FIRST_VERSION "GLIBC_2.2.5"
#elif defined(__aarch64__)
#define FIRST_VERSION "GLIBC_2.17"
#else
#error "no first version of the C library is known for this machine"
#endif
#include <stdlib.h>
#include <unistd.h>

#define HIDDEN __attribute__((visibility("hidden")))

#define OLDER(type, name, arguments, values)                     \
    extern type first_##name arguments;                          \
    __asm__(".symver first_" #name "," #name "@" FIRST_VERSION); \
    HIDDEN type name arguments;                                  \
    HIDDEN type name arguments {                                 \
        return first_##name values;                              \
    }

OLDER(double, exp, (double x), (x))
OLDER(double, exp2, (double x), (x))
OLDER(double, log, (double x), (x))
OLDER(double, log2, (double x), (x))
OLDER(double, pow, (double x, double y), (x, y))

/* The C++ library asks here whether it may count references without atomic instructions
 * (glibc 2.32): never. */
HIDDEN char __libc_single_threaded = 0;

/* Where std::random_device gets its bits (glibc 2.36, which ends a program too that gets none). */
unsigned arc4random(void);
HIDDEN unsigned arc4random(void) {
    unsigned bits;
    if (getentropy(&bits, sizeof bits)) abort();
    return bits;
}
