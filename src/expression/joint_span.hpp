// One orthonormal basis U that holds what matters of all training columns: the leading directions
// of X (identities) and of Y (expressions) by subspace iteration over blocks of columns. Everything
// after it works on coordinates U'X, U'Y of a few hundred numbers per face, so thousands of faces
// of any size train in bounded memory; no 3#V x 3#V matrix and no Gram matrix of the faces is
// formed.
//
// The start block is a fixed pseudo-random function of the row, so every iterate depends on XX' and
// YY' alone: a set of columns and any rotation of it (a merged shard) give the same basis to
// rounding.
#pragma once

#include "base/context.hpp"
#include "expression/column_source.hpp"

namespace mien {

struct JointSpanOptions {
    Index identity_rank = 150;    ///< directions kept of X, at most subjects - 1
    Index expression_rank = 150;  ///< directions kept of Y
    int passes = 4;               ///< of subspace iteration over the data, 1..50
};

struct JointSpan {
    Vector mean;                                                 ///< 3#V, mean of the neutral faces
    Matrix basis;                                                ///< U, 3#V x r, orthonormal
    Matrix neutrals;                                             ///< r x m, U'(x - mean)
    Matrix displacements;                                        ///< r x s, U'y
    double neutral_energy = 0, displacement_energy = 0;          ///< ||X||^2, ||Y||^2, mm^2
    double neutral_energy_cut = 0, displacement_energy_cut = 0;  ///< what U does not hold
};

/// O(passes #V s r). Throws Status::memory_budget, cancelled, corrupt.
JointSpan find_joint_span(const Context& context, const ColumnSource& source,
                          const JointSpanOptions& options);

/// Replaces the columns of `block` by an orthonormal basis of their span; directions below 1e-7 of
/// the strongest are dropped.
void orthonormalize(const Context& context, Matrix& block);

}  // namespace mien
