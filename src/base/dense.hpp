// Large dense products. One library must run on any x86-64 and be fast on every one, so these few
// loops are compiled twice (portable and AVX2+FMA) and chosen at run time. All matrices are
// column-major with a leading dimension; work is cut into fixed panels, so any thread count gives
// the same bits. The two instruction sets agree to rounding, not to the bit.
#pragma once

#include <functional>

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

/// Cholesky factor of a symmetric positive definite matrix, whose lower triangle is read and
/// overwritten. Returns false, with A undefined, when A is not positive definite.
bool factor_spd(MatrixRefD a);
bool factor_spd(MatrixRefF a);
/// Solves A X = B by the factor; B is overwritten by X.
void solve_factored(const ConstMatrixRefD& factor, MatrixRefD b);
void solve_factored(const ConstMatrixRefF& factor, MatrixRefF b);

// Products of a tall matrix with three columns, the coordinates of a field. A general product packs
// the tall side first, which costs as much as the work itself; these stream it.
using Field = Eigen::Matrix<float, Eigen::Dynamic, 3>;

/// field += A x for x (k x 3).
void add_thin_product(const Context& context, const ConstMatrixRefF& a, const ConstMatrixRefF& x,
                      Field& field);
/// out (k x 3) = A' field.
void project_thin(const Context& context, const ConstMatrixRefF& a, const Field& field,
                  Eigen::MatrixXf& out);
/// field += A x, then `between(first, count)` for each range of rows, then out = A' field: A is
/// read from memory once instead of twice. `between` may change its rows of the field and runs on
/// several threads.
void expand_and_project(const Context& context, const ConstMatrixRefF& a, const ConstMatrixRefF& x,
                        Field& field, const std::function<void(Index first, Index count)>& between,
                        Eigen::MatrixXf& out);

// The same for one column, which is kept in double.

/// out += A x.
void add_product(const Context& context, const ConstMatrixRefF& a, const Vector& x,
                 Eigen::Ref<Vector> out);
/// A' y; sums are floats within a strip of rows and doubles over the strips.
Vector project(const Context& context, const ConstMatrixRefF& a, const Eigen::Ref<const Vector>& y);

// The same for a matrix that is stored by rows, as a basis in a file is: A' (k x n) with A's rows
// as its columns.

/// out (k x 3) = A' field (n x 3).
void project_rows(const Context& context, const ConstMatrixRefD& a_transposed,
                  const PointsRef& field, Matrix& out);
/// field (n x 3) = A x for x (k x 3). Reads A from its end: what a projection just before left in
/// the cache comes first.
void expand_rows(const Context& context, const ConstMatrixRefD& a_transposed, const Matrix& x,
                 Points& field);

/// out = A x for a symmetric A, whose lower triangle is read, once.
void symmetric_product(const Context& context, const ConstMatrixRefD& a,
                       const Eigen::Ref<const Vector>& x, Eigen::Ref<Vector> out);

/// True when the AVX2+FMA loops are in use: the processor has them, and nobody asked for the
/// portable ones.
bool uses_avx2();
/// For comparisons in one run: the portable loops from now on, on any processor. Not while a call
/// is running.
void use_portable_loops(bool portable);

}  // namespace mien::dense
