// Large dense products. One library must run on any x86-64 and be fast on every one, so these few
// loops are compiled twice (portable and AVX2+FMA) and chosen at run time. All matrices are
// column-major with a leading dimension; work is cut into fixed panels, so any thread count gives
// the same bits. The two instruction sets agree to rounding, not to the bit.
#pragma once

#include "base/context.hpp"
#include "base/types.hpp"

namespace mien::dense {

using MatrixRefF = Eigen::Ref<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
using MatrixRefD = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstMatrixRefF = Eigen::Ref<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
using ConstMatrixRefD = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

enum class Op { none, transpose };

/// C = alpha op(A) op(B) + beta C. beta = 0 overwrites C, whatever it held.
void multiply(const Context& context, double alpha, const ConstMatrixRefD& a, Op op_a,
              const ConstMatrixRefD& b, Op op_b, double beta, MatrixRefD c);
void multiply(const Context& context, float alpha, const ConstMatrixRefF& a, Op op_a,
              const ConstMatrixRefF& b, Op op_b, float beta, MatrixRefF c);

/// C = A' diag(weights) A, both triangles; weights of length A.rows() or empty for ones. Rows with
/// weight zero cost nothing but their test.
void weighted_gram(const Context& context, const ConstMatrixRefD& a, const Vector& weights,
                   MatrixRefD c);
void weighted_gram(const Context& context, const ConstMatrixRefF& a, const Eigen::VectorXf& weights,
                   MatrixRefF c);

/// Solves A X = B for symmetric positive definite A by Cholesky; A is overwritten by its factor, B
/// by X. Returns false, with A and B undefined, when A is not positive definite.
bool solve_spd(MatrixRefD a, MatrixRefD b);
bool solve_spd(MatrixRefF a, MatrixRefF b);

/// True when the AVX2+FMA loops are in use on this processor.
bool uses_avx2();

}  // namespace mien::dense
