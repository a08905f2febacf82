/* The first versions of exp, exp2, log, log2 and pow, which the prebuilt archives take
 * (cmake/glibc_2_28.c), give the same bits as today's: glibc_math. Skipped (77) where the C library
 * has one version of them. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#if defined(__x86_64__)
#define FIRST_VERSION "GLIBC_2.2.5"
#else
#define FIRST_VERSION "GLIBC_2.17"
#endif

typedef union {
    void* address;
    double (*one)(double);
    double (*two)(double, double);
} function;

static uint64_t bits_of(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Numbers of any exponent, and among them those at which the functions overflow, vanish or know
 * nothing. */
static double next_argument(uint64_t* state) {
    static const double edges[] = {0,
                                   -0.0,
                                   1,
                                   -1,
                                   INFINITY,
                                   -INFINITY,
                                   NAN,
                                   1e300,
                                   709.78271289,
                                   -745.13321911,
                                   1024,
                                   -1075,
                                   4.9e-324,
                                   2.2250738585072014e-308};
    double value;
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    if (*state >> 60 == 0) return edges[(*state >> 32) % (sizeof edges / sizeof *edges)];
    if (*state >> 63) return (double)(int64_t)(*state << 1) * 1e-16; /* to 922 */
    memcpy(&value, state, sizeof value);
    return value;
}

int main(void) {
    static const char* const names[] = {"exp", "exp2", "log", "log2", "pow"};
    void* const libm = dlopen("libm.so.6", RTLD_NOW);
    unsigned k, n, differ = 0;
    if (!libm) return puts("skipped: no libm.so.6"), 77;
    for (k = 0; k < sizeof names / sizeof *names; ++k) {
        function first, now;
        uint64_t state = k + 1;
        first.address = dlvsym(libm, names[k], FIRST_VERSION);
        now.address = dlvsym(libm, names[k], "GLIBC_2.29");
        if (!first.address || !now.address)
            return puts("skipped: this C library has one version of them"), 77;
        if (first.address == now.address)
            return printf("FAILED: both versions of %s are one\n", names[k]), 1;
        for (n = 0; n < 400000; ++n) {
            const double x = next_argument(&state), y = next_argument(&state);
            const double a = k < 4 ? first.one(x) : first.two(x, y),
                         b = k < 4 ? now.one(x) : now.two(x, y);
            if (bits_of(a) != bits_of(b) && !(isnan(a) && isnan(b)) && ++differ < 5)
                printf("FAILED: %s(%a, %a): %a and %a\n", names[k], x, y, a, b);
        }
    }
    printf("%u of %u results differ\n", differ, 5 * 400000);
    return differ != 0;
}
