// The seam between the network evaluator and its inner loops, which are compiled once per
// instruction set (base/lanes.inc): plain data and plain functions only. All arrays are float,
// row-major. Every sum runs in one fixed order whatever the cut into panels, so that the results of
// one instruction set do not depend on the number of threads.
#pragma once

#include <cstddef>

namespace mien::network_loops {

constexpr int kWidth = 8;   // floats of one lane
constexpr int kBlock = 16;  // columns of a packed matrix's block

/// What becomes of a sum: out = scale * act(sum + bias), or out += that.
struct Epilogue {
    const float* bias = nullptr;  ///< one per column, or null
    float scale = 1;
    bool elu = false;
    bool accumulate = false;
};

struct Loops {
    /// out (rows x columns) = epilogue(P W). Row r of P is the `segments` pieces of `length` floats
    /// that source[r * segments + s] point to, one after the other. W (segments * length x columns)
    /// is packed: blocks of 16 columns, the last of 8 when no more are left, each row by row, with
    /// zeros behind the last column.
    void (*product)(const float* const* source, std::ptrdiff_t rows, std::ptrdiff_t segments,
                    std::ptrdiff_t length, const float* packed, std::ptrdiff_t columns,
                    const Epilogue& epilogue, float* out, std::ptrdiff_t ld_out);
    /// out (mixes x channels) = C' X: X's `count` rows are source[j], C is count x mixes.
    void (*mix)(const float* const* source, std::ptrdiff_t count, const float* coefficients,
                std::ptrdiff_t mixes, std::ptrdiff_t channels, float* out);
    /// out[o] += sum over j and b of C(j, b) * source[j][b * channels + o]; channels is a multiple
    /// of 8.
    void (*edge_sum)(const float* const* source, std::ptrdiff_t count, const float* coefficients,
                     std::ptrdiff_t bases, std::ptrdiff_t channels, float* out);
    /// x = max(x, 0) + expm1(min(x, 0)).
    void (*elu)(float* x, std::ptrdiff_t count);
    /// x = exp(x) for x <= 0.
    void (*exponentials)(float* x, std::ptrdiff_t count);
};

const Loops& portable_loops();
const Loops& avx2_loops();

}  // namespace mien::network_loops
