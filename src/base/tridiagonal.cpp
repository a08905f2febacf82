#include "base/tridiagonal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/dense.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"

namespace mien {
namespace {

constexpr Index kPanel = 48;  // reflections that are applied together

}  // namespace

Tridiagonalization::Tridiagonalization(Matrix& a, const Context& context) : a_(a) {
    const Index n = a.rows();
    result_.diagonal.resize(n);
    result_.beside.resize(std::max<Index>(0, n - 1));
    tau_ = Vector::Zero(std::max<Index>(0, n - 1));
    Matrix both;  // [V W] of a panel: A - V W' - W V' is what its reflections leave
    for (Index first = 0; first < n - 1;) {
        context.check_cancelled();
        const Index size = reduce_panel(first, both, context);
        update_rest(first, size, both, context);
        first += size;
    }
    if (n > 0) result_.diagonal[n - 1] = a(n - 1, n - 1);
}

/// Columns first .. first + size become reflections; A below and right of them stays as it was.
Index Tridiagonalization::reduce_panel(Index first, Matrix& both, const Context& context) {
    const Index n = a_.rows(), size = std::min(kPanel, n - 1 - first), rows = n - first;
    both.setZero(rows, 2 * size);
    Vector product, share;
    for (Index i = 0; i < size; ++i) {
        const Index column = first + i, below = n - column - 1;
        // What the panel's reflections so far do to this column.
        auto entries = a_.col(column).tail(below + 1);
        const auto v_rows = both.block(i, 0, below + 1, i),
                   w_rows = both.block(i, size, below + 1, i);
        entries.noalias() -= v_rows * both.row(i).segment(size, i).transpose();
        entries.noalias() -= w_rows * both.row(i).head(i).transpose();
        result_.diagonal[column] = entries[0];

        auto v = a_.col(column).tail(below);
        double tau = 0, beta = 0;
        v.makeHouseholderInPlace(tau, beta);
        result_.beside[column] = beta;
        tau_[column] = tau;
        v[0] = 1;

        auto v_out = both.col(i).tail(below);
        auto w = both.col(size + i).tail(below);
        v_out = v;
        product.resize(below);
        dense::symmetric_product(context, a_.bottomRightCorner(below, below), v_out, product);
        const auto v_before = both.block(i + 1, 0, below, i),
                   w_before = both.block(i + 1, size, below, i);
        share.noalias() = w_before.transpose() * v_out;
        product.noalias() -= v_before * share;
        share.noalias() = v_before.transpose() * v_out;
        product.noalias() -= w_before * share;
        product *= tau;
        product -= (0.5 * tau * product.dot(v_out)) * v_out;
        w = product;
    }
    return size;
}

void Tridiagonalization::update_rest(Index first, Index size, const Matrix& both,
                                     const Context& context) {
    const Index n = a_.rows(), start = first + size, rest = n - start;
    constexpr Index kColumns = 192;
    Matrix exchanged(rest, 2 * size);  // [W V]
    exchanged << both.bottomRows(rest).rightCols(size), both.bottomRows(rest).leftCols(size);
    for (Index j = 0; j < rest; j += kColumns) {
        const Index columns = std::min(kColumns, rest - j);
        dense::multiply(context, -1.0, both.bottomRows(rest - j), dense::Op::none,
                        exchanged.middleRows(j, columns), dense::Op::transpose, 1.0,
                        a_.block(start + j, start + j, rest - j, columns));
    }
}

void Tridiagonalization::turn_back(Matrix& z, const Context& context) const {
    const Index n = a_.rows(), k = z.cols();
    const Index last = n < 2 ? 0 : (n - 2) / kPanel * kPanel;
    for (Index first = last; first >= 0 && n > 1; first -= kPanel) {
        context.check_cancelled();
        const Index size = std::min(kPanel, n - 1 - first), rows = n - first - 1;
        Matrix v = Matrix::Zero(rows, size), factor = Matrix::Zero(size, size);
        for (Index i = 0; i < size; ++i) v.col(i).tail(rows - i) = a_.col(first + i).tail(rows - i);
        // H1 .. Hs = I - V F V' with F upper triangular (Schreiber and Van Loan 1989).
        for (Index i = 0; i < size; ++i) {
            const double tau = tau_[first + i];
            const Vector overlap = v.leftCols(i).transpose() * v.col(i);
            factor.col(i).head(i) =
                factor.topLeftCorner(i, i).triangularView<Eigen::Upper>() * Vector(-tau * overlap);
            factor(i, i) = tau;
        }
        Matrix shares(size, k), turned(size, k);
        dense::multiply(context, 1.0, v, dense::Op::transpose, z.bottomRows(rows), dense::Op::none,
                        0.0, shares);
        turned.noalias() = factor.triangularView<Eigen::Upper>() * shares;
        dense::multiply(context, -1.0, v, dense::Op::none, turned, dense::Op::none, 1.0,
                        z.bottomRows(rows));
    }
}

namespace {

/// T - shift I as a product of elimination steps with exchange of rows.
class ShiftedElimination {
  public:
    explicit ShiftedElimination(const Tridiagonal& matrix)
        : matrix_(matrix),
          main_(matrix.diagonal.size()),
          first_(matrix.diagonal.size()),
          second_(matrix.diagonal.size()),
          factor_(matrix.diagonal.size()),
          exchanged_(static_cast<std::size_t>(matrix.diagonal.size())) {}

    void factor(double shift, double least_pivot) {
        const Index n = main_.size();
        double pivot = matrix_.diagonal[0] - shift, right = n > 1 ? matrix_.beside[0] : 0;
        for (Index i = 0; i + 1 < n; ++i) {
            const double below = matrix_.beside[i], next = matrix_.diagonal[i + 1] - shift,
                         after = i + 2 < n ? matrix_.beside[i + 1] : 0;
            const bool exchange = std::abs(below) > std::abs(pivot);
            exchanged_[static_cast<std::size_t>(i)] = exchange;
            if (exchange) {
                factor_[i] = pivot / below;
                main_[i] = below;
                first_[i] = next;
                second_[i] = after;
                pivot = right - factor_[i] * next;
                right = -factor_[i] * after;
            } else {
                if (std::abs(pivot) < least_pivot) pivot = std::copysign(least_pivot, pivot);
                factor_[i] = below / pivot;
                main_[i] = pivot;
                first_[i] = right;
                second_[i] = 0;
                pivot = next - factor_[i] * right;
                right = after;
            }
        }
        if (std::abs(pivot) < least_pivot) pivot = std::copysign(least_pivot, pivot);
        main_[n - 1] = pivot;
        first_[n - 1] = second_[n - 1] = 0;
    }

    void solve(Eigen::Ref<Vector> x) const {
        const Index n = main_.size();
        for (Index i = 0; i + 1 < n; ++i) {
            if (exchanged_[static_cast<std::size_t>(i)]) std::swap(x[i], x[i + 1]);
            x[i + 1] -= factor_[i] * x[i];
        }
        for (Index i = n - 1; i >= 0; --i) {
            double value = x[i];
            if (i + 1 < n) value -= first_[i] * x[i + 1];
            if (i + 2 < n) value -= second_[i] * x[i + 2];
            x[i] = value / main_[i];
        }
    }

  private:
    const Tridiagonal& matrix_;
    Vector main_, first_, second_, factor_;
    std::vector<bool> exchanged_;
};

double norm_of(const Tridiagonal& matrix) {
    const Index n = matrix.diagonal.size();
    double norm = 0;
    for (Index i = 0; i < n; ++i)
        norm = std::max(norm, std::abs(matrix.diagonal[i]) +
                                  (i > 0 ? std::abs(matrix.beside[i - 1]) : 0) +
                                  (i + 1 < n ? std::abs(matrix.beside[i]) : 0));
    return norm;
}

double residual_of(const Tridiagonal& matrix, double value, const Eigen::Ref<const Vector>& z) {
    const Index n = z.size();
    Vector rest = (matrix.diagonal.array() - value) * z.array();
    rest.head(n - 1).array() += matrix.beside.array() * z.tail(n - 1).array();
    rest.tail(n - 1).array() += matrix.beside.array() * z.head(n - 1).array();
    return rest.norm();
}

}  // namespace

bool tridiagonal_eigenvectors(const Tridiagonal& matrix, const Vector& values, Matrix& vectors,
                              const Context& context) {
    const Index n = matrix.diagonal.size(), k = values.size();
    // Relative to the norm: values nearer than kCluster share their vectors' plane, which inverse
    // iteration alone would not span; kApart parts equal values.
    constexpr double kCluster = 1e-10, kWrong = 1e-10;
    constexpr int kSteps = 3;
    const double norm = std::max(norm_of(matrix), std::numeric_limits<double>::min());
    const double apart = 4 * std::numeric_limits<double>::epsilon() * norm;
    std::vector<Index> starts{0};
    for (Index j = 1; j < k; ++j)
        if (values[j] - values[j - 1] > kCluster * norm) starts.push_back(j);
    starts.push_back(k);
    vectors.resize(n, k);
    const std::size_t num_clusters = starts.size() - 1;
    std::vector<char> found(num_clusters, 1);
    parallel_for(context, num_clusters, 16, [&](std::size_t begin, std::size_t end) {
        ShiftedElimination elimination(matrix);
        for (std::size_t c = begin; c < end; ++c) {
            double shift = -std::numeric_limits<double>::infinity();
            for (Index j = starts[c]; j < starts[c + 1]; ++j) {
                shift = std::max(values[j], shift + apart);
                elimination.factor(shift, apart);
                const CounterRandom chance(1, static_cast<std::uint64_t>(j));
                Vector z(n);
                for (Index i = 0; i < n; ++i)
                    z[i] = chance.uniform(static_cast<std::uint64_t>(i)) - 0.5;
                const auto before = vectors.middleCols(starts[c], j - starts[c]);
                for (int step = 0; step < kSteps; ++step) {
                    z /= z.norm();
                    elimination.solve(z);
                    z /= z.norm();
                    if (before.cols() > 0)
                        for (int again = 0; again < 2; ++again)
                            z -= before * Vector(before.transpose() * z);
                }
                z /= z.norm();
                if (!(residual_of(matrix, values[j], z) <= kWrong * norm)) found[c] = 0;
                vectors.col(j) = z;
            }
        }
    });
    return std::all_of(found.begin(), found.end(), [](char one) { return one != 0; });
}

}  // namespace mien
