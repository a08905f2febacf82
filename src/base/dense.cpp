#include "base/dense.hpp"

#include <algorithm>
#include <atomic>
#include <vector>

#include "base/dense_kernels.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien::dense {
namespace {

std::atomic<bool> portable_only{false};

bool detect_avx2() {
#if defined(MIEN_AVX2)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

template <typename Scalar>
const Kernels<Scalar>& kernels();

template <>
const Kernels<double>& kernels<double>() {
#if defined(MIEN_AVX2)
    if (uses_avx2()) return avx2_kernels_f64();
#endif
    return portable_kernels_f64();
}

template <>
const Kernels<float>& kernels<float>() {
#if defined(MIEN_AVX2)
    if (uses_avx2()) return avx2_kernels_f32();
#endif
    return portable_kernels_f32();
}

// Columns of a product with a block of vectors, four of which are worked on together.
constexpr Index kFew = 4, kBlockOfVectors = 8;
// Rows and columns of A that stay in a second cache of 512 kB while four and the other four are
// multiplied by them; long pieces of columns, as memory gives them best.
constexpr std::size_t kBlockRows = 1024;
constexpr Index kBlockColumns = 24;

// C = alpha A B + beta C or alpha A' B + beta C where B has four or eight columns: a general
// product packs A first, which costs as much as the work itself.
template <typename Scalar, typename ConstRef, typename MutableRef>
void multiply_block(const Context& context, Scalar alpha, const ConstRef& a, Op op_a,
                    const ConstRef& b, Scalar beta, MutableRef& c) {
    using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const auto& kernel = kernels<Scalar>();
    const Index n = b.cols(), k = a.cols();
    const std::size_t rows = static_cast<std::size_t>(a.rows());
    if (beta == Scalar(0))
        c.setZero();
    else if (beta != Scalar(1))
        c *= beta;
    const Dense scaled = alpha * b;
    std::vector<Dense> parts(op_a == Op::none ? 0 : (rows + kBlockRows - 1) / kBlockRows);
    parallel_for(context, rows, kBlockRows, [&](std::size_t begin, std::size_t end) {
        const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
        Dense* const part = parts.empty() ? nullptr : &parts[begin / kBlockRows];
        if (part != nullptr) part->resize(k, n);
        for (Index column = 0; column < k; column += kBlockColumns) {
            const Index width = std::min(kBlockColumns, k - column);
            const Scalar* piece = a.data() + column * a.outerStride() + first;
            for (Index j = 0; j < n; j += kFew)
                if (part != nullptr)
                    kernel.project_four(count, width, piece, a.outerStride(),
                                        scaled.data() + j * scaled.rows() + first, scaled.rows(),
                                        part->data() + j * k + column, k);
                else
                    kernel.expand_four(count, width, piece, a.outerStride(),
                                       scaled.data() + j * k + column, k,
                                       c.data() + j * c.outerStride() + first, c.outerStride());
        }
    });
    for (const Dense& part : parts) c += part;  // in their order, whoever computed them
}

template <typename Scalar, typename ConstRef, typename MutableRef>
void multiply_panels(const Context& context, Scalar alpha, const ConstRef& a, Op op_a,
                     const ConstRef& b, Op op_b, Scalar beta, MutableRef& c) {
    const bool ta = op_a == Op::transpose, tb = op_b == Op::transpose;
    const Index m = ta ? a.cols() : a.rows(), k = ta ? a.rows() : a.cols();
    const Index n = tb ? b.rows() : b.cols();
    if ((tb ? b.cols() : b.rows()) != k || c.rows() != m || c.cols() != n)
        fail(Status::internal, "matrix product of %lldx%lld by inner size %lld",
             static_cast<long long>(m), static_cast<long long>(n), static_cast<long long>(k));
    if (!tb && (n == kFew || n == kBlockOfVectors) && a.rows() >= a.cols() && a.size() > 0)
        return multiply_block<Scalar>(context, alpha, a, op_a, b, beta, c);
    const auto& kernel = kernels<Scalar>();
    // Cut the longer side of C: a panel wide enough to keep the packed operand busy.
    const bool cut_rows = m >= n;
    const std::size_t count = static_cast<std::size_t>(cut_rows ? m : n);
    const std::size_t panel = std::max<std::size_t>(64, std::min<std::size_t>(512, count / 4 + 1));
    parallel_for(context, count, panel, [&](std::size_t begin, std::size_t end) {
        const Index first = static_cast<Index>(begin), size = static_cast<Index>(end - begin);
        if (cut_rows) {
            const Scalar* a_panel = a.data() + (ta ? first * a.outerStride() : first);
            kernel.gemm(ta, tb, size, n, k, alpha, a_panel, a.outerStride(), b.data(),
                        b.outerStride(), beta, c.data() + first, c.outerStride());
        } else {
            const Scalar* b_panel = b.data() + (tb ? first : first * b.outerStride());
            kernel.gemm(ta, tb, m, size, k, alpha, a.data(), a.outerStride(), b_panel,
                        b.outerStride(), beta, c.data() + first * c.outerStride(), c.outerStride());
        }
    });
}

template <typename Scalar, typename ConstRef, typename WeightVector, typename MutableRef>
void gram_panels(const Context& context, const ConstRef& a, const WeightVector& weights,
                 MutableRef& c) {
    using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    const Index n = a.cols(), rows = a.rows();
    if (c.rows() != n || c.cols() != n || (weights.size() != 0 && weights.size() != rows))
        fail(Status::internal, "gram matrix of %lldx%lld into %lldx%lld",
             static_cast<long long>(rows), static_cast<long long>(n),
             static_cast<long long>(c.rows()), static_cast<long long>(c.cols()));
    // Without weights A is read where it lies, otherwise its used rows are gathered, each times the
    // root of its weight.
    const bool gather = weights.size() != 0;
    std::vector<Index> used;
    std::vector<Scalar> root;
    for (Index i = 0; gather && i < rows; ++i)
        if (weights[i] != Scalar(0)) used.push_back(i), root.push_back(std::sqrt(weights[i]));
    const std::size_t total = gather ? used.size() : static_cast<std::size_t>(rows);

    // A fixed number of slices, each with a result of its own, added in order.
    constexpr std::size_t kSlices = 4, kBlock = 256;
    const std::size_t slice = std::max<std::size_t>(kBlock, (total + kSlices - 1) / kSlices);
    const std::size_t num_slices = (total + slice - 1) / slice;
    std::vector<Dense> partial(num_slices);
    const auto& kernel = kernels<Scalar>();
    parallel_for(context, total, slice, [&](std::size_t begin, std::size_t end) {
        Dense& sum = partial[begin / slice];
        sum.setZero(n, n);
        Dense block(gather ? static_cast<Index>(kBlock) : 0, n);
        for (std::size_t start = begin; start < end; start += kBlock) {
            const Index first = static_cast<Index>(start),
                        size = static_cast<Index>(std::min(end, start + kBlock)) - first;
            for (Index j = 0; gather && j < n; ++j) {
                const Scalar* column = a.data() + j * a.outerStride();
                for (Index i = 0; i < size; ++i) {
                    const std::size_t k = start + static_cast<std::size_t>(i);
                    block(i, j) = root[k] * column[used[k]];
                }
            }
            if (gather)
                kernel.gram(n, size, block.data(), block.outerStride(), sum.data(),
                            sum.outerStride());
            else
                kernel.gram(n, size, a.data() + first, a.outerStride(), sum.data(),
                            sum.outerStride());
        }
    });
    c.setZero();
    for (const Dense& sum : partial) c += sum;
    for (Index j = 0; j < n; ++j)
        for (Index i = j + 1; i < n; ++i) c(j, i) = c(i, j);
}

// Rows at a time of a thin product of rows.
constexpr std::size_t kStrip = 256;
// Of one with a single column, which is read in the order of the memory: the column stays in the
// first cache.
constexpr std::size_t kLongStrip = 3072;

// Rows of a thin product at a time: about 900, whose pieces of a column are long enough for memory
// to give them at its best (256 rows of 11,000 x 500 take twice the time), and a multiple of four
// strips, so that threads have as much to do each.
Index thin_strip(Index rows) {
    constexpr Index kMost = 1024, kAtOnce = 4, kLanes = 16, kLeast = 64;
    const Index strips = kAtOnce * ((rows + kAtOnce * kMost - 1) / (kAtOnce * kMost));
    const Index even = (rows + strips - 1) / std::max<Index>(1, strips);
    return std::max(kLeast, (even + kLanes - 1) / kLanes * kLanes);
}

void check_thin(const ConstMatrixRefF& a, const Field& field) {
    if (field.rows() != a.rows())
        fail(Status::internal, "thin product of %lldx%lld with a field of %lld rows",
             static_cast<long long>(a.rows()), static_cast<long long>(a.cols()),
             static_cast<long long>(field.rows()));
}

/// A' field of each strip, three columns a strip, to be added in their order whoever computed them.
class StripSums {
  public:
    explicit StripSums(const ConstMatrixRefF& a)
        : strip_(thin_strip(a.rows())), parts_(a.cols(), 3 * ((a.rows() + strip_ - 1) / strip_)) {}
    void project(const ConstMatrixRefF& a, const Field& field, Index first, Index count) {
        const Index k = a.cols();
        kernels<float>().project_thin(count, k, a.data() + first, a.outerStride(),
                                      field.data() + first, field.rows(),
                                      parts_.data() + 3 * k * (first / strip_), k);
    }
    void add_up(Eigen::MatrixXf& out) const {
        out.setZero(parts_.rows(), 3);
        for (Index s = 0; s < parts_.cols(); s += 3) out += parts_.middleCols(s, 3);
    }

  private:
    Index strip_;
    Eigen::MatrixXf parts_;
};

template <typename Work>  // (first row, number of rows)
void for_each_strip(const Context& context, Index rows, const Work& work) {
    parallel_for(context, static_cast<std::size_t>(rows),
                 static_cast<std::size_t>(thin_strip(rows)),
                 [&](std::size_t begin, std::size_t end) {
                     work(static_cast<Index>(begin), static_cast<Index>(end - begin));
                 });
}

void expand(const ConstMatrixRefF& a, const ConstMatrixRefF& x, Field& field, Index first,
            Index count) {
    kernels<float>().expand_thin(count, a.cols(), a.data() + first, a.outerStride(), x.data(),
                                 x.outerStride(), field.data() + first, field.rows());
}

}  // namespace

void symmetric_product(const Context& context, const ConstMatrixRefD& a,
                       const Eigen::Ref<const Vector>& x, Eigen::Ref<Vector> out) {
    const Index n = a.rows();
    if (a.cols() != n || x.size() != n || out.size() != n)
        fail(Status::internal, "symmetric product of %lldx%lld with %lld values",
             static_cast<long long>(n), static_cast<long long>(a.cols()),
             static_cast<long long>(x.size()));
    // A panel's share of the result reaches from its first row down.
    constexpr Index kPanel = 128;
    const Index num_panels = (n + kPanel - 1) / kPanel;
    Matrix shares(n, num_panels);
    const auto& kernel = kernels<double>();
    parallel_for(context, static_cast<std::size_t>(num_panels), 1, [&](std::size_t p, std::size_t) {
        const Index first = static_cast<Index>(p) * kPanel, size = std::min(kPanel, n - first),
                    rest = n - first - size;
        Vector share = Vector::Zero(n - first);
        for (Index j = 0; j < size; ++j) {
            const auto column = a.col(first + j).segment(first + j, size - j);
            share[j] += column.dot(x.segment(first + j, size - j));
            share.segment(j + 1, size - j - 1) += x[first + j] * column.tail(size - j - 1);
        }
        if (rest > 0)
            kernel.two_sided(rest, size, a.data() + first * a.outerStride() + first + size,
                             a.outerStride(), x.data() + first, x.data() + first + size,
                             share.data() + size, share.data());
        shares.col(static_cast<Index>(p)).tail(n - first) = share;
    });
    out = shares.col(0);
    for (Index p = 1; p < num_panels; ++p)
        out.tail(n - p * kPanel) += shares.col(p).tail(n - p * kPanel);
}

bool uses_avx2() {
    static const bool supported = detect_avx2();
    return supported && !portable_only;
}

void use_portable_loops(bool portable) {
    portable_only = portable;
}

void multiply(const Context& context, double alpha, const ConstMatrixRefD& a, Op op_a,
              const ConstMatrixRefD& b, Op op_b, double beta, MatrixRefD c) {
    multiply_panels<double>(context, alpha, a, op_a, b, op_b, beta, c);
}

void multiply(const Context& context, float alpha, const ConstMatrixRefF& a, Op op_a,
              const ConstMatrixRefF& b, Op op_b, float beta, MatrixRefF c) {
    multiply_panels<float>(context, alpha, a, op_a, b, op_b, beta, c);
}

void weighted_gram(const Context& context, const ConstMatrixRefD& a, const Vector& weights,
                   MatrixRefD c) {
    gram_panels<double>(context, a, weights, c);
}

void weighted_gram(const Context& context, const ConstMatrixRefF& a, const Eigen::VectorXf& weights,
                   MatrixRefF c) {
    gram_panels<float>(context, a, weights, c);
}

bool factor_spd(MatrixRefD a) {
    return kernels<double>().factor_spd(a.rows(), a.data(), a.outerStride());
}

bool factor_spd(MatrixRefF a) {
    return kernels<float>().factor_spd(a.rows(), a.data(), a.outerStride());
}

void solve_factored(const ConstMatrixRefD& factor, MatrixRefD b) {
    kernels<double>().solve_factored(b.rows(), b.cols(), factor.data(), factor.outerStride(),
                                     b.data(), b.outerStride());
}

void solve_factored(const ConstMatrixRefF& factor, MatrixRefF b) {
    kernels<float>().solve_factored(b.rows(), b.cols(), factor.data(), factor.outerStride(),
                                    b.data(), b.outerStride());
}

void add_thin_product(const Context& context, const ConstMatrixRefF& a, const ConstMatrixRefF& x,
                      Field& field) {
    check_thin(a, field);
    for_each_strip(context, a.rows(),
                   [&](Index first, Index count) { expand(a, x, field, first, count); });
}

void project_thin(const Context& context, const ConstMatrixRefF& a, const Field& field,
                  Eigen::MatrixXf& out) {
    check_thin(a, field);
    StripSums sums(a);
    for_each_strip(context, a.rows(),
                   [&](Index first, Index count) { sums.project(a, field, first, count); });
    sums.add_up(out);
}

void expand_and_project(const Context& context, const ConstMatrixRefF& a, const ConstMatrixRefF& x,
                        Field& field, const std::function<void(Index first, Index count)>& between,
                        Eigen::MatrixXf& out) {
    check_thin(a, field);
    StripSums sums(a);
    for_each_strip(context, a.rows(), [&](Index first, Index count) {
        expand(a, x, field, first, count);
        between(first, count);
        sums.project(a, field, first, count);
    });
    sums.add_up(out);
}

void add_product(const Context& context, const ConstMatrixRefF& a, const Vector& x,
                 Eigen::Ref<Vector> out) {
    const Eigen::VectorXf factors = x.cast<float>();
    parallel_for(
        context, static_cast<std::size_t>(a.rows()), kLongStrip,
        [&](std::size_t begin, std::size_t end) {
            const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
            Eigen::VectorXf sum = Eigen::VectorXf::Zero(count);
            kernels<float>().expand_column(count, a.cols(), a.data() + first, a.outerStride(),
                                           factors.data(), x.size(), sum.data(), count);
            out.segment(first, count) += sum.cast<double>();
        });
}

Vector project(const Context& context, const ConstMatrixRefF& a,
               const Eigen::Ref<const Vector>& y) {
    return parallel_sum(
        context, static_cast<std::size_t>(a.rows()), kLongStrip, Vector(Vector::Zero(a.cols())),
        [&](std::size_t begin, std::size_t end) {
            const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
            const Eigen::VectorXf part = y.segment(first, count).cast<float>();
            Eigen::VectorXf sums(a.cols());
            kernels<float>().project_column(count, a.cols(), a.data() + first, a.outerStride(),
                                            part.data(), count, sums.data(), a.cols());
            return Vector(sums.cast<double>());
        });
}

void project_rows(const Context& context, const ConstMatrixRefD& a_transposed,
                  const PointsRef& field, Matrix& out) {
    const Index k = a_transposed.rows();
    const Matrix columns = field;
    out = parallel_sum(context, static_cast<std::size_t>(field.rows()), kStrip,
                       Matrix(Matrix::Zero(k, 3)), [&](std::size_t begin, std::size_t end) {
                           const auto first = static_cast<Index>(begin),
                                      count = static_cast<Index>(end - begin);
                           Matrix part = Matrix::Zero(k, 3);
                           kernels<double>().expand_thin(
                               k, count, a_transposed.col(first).data(), a_transposed.outerStride(),
                               columns.data() + first, columns.rows(), part.data(), k);
                           return part;
                       });
}

void expand_rows(const Context& context, const ConstMatrixRefD& a_transposed, const Matrix& x,
                 Points& field) {
    const Index k = a_transposed.rows(), n = a_transposed.cols();
    field.resize(n, 3);
    parallel_for(
        context, static_cast<std::size_t>(n), kStrip, [&](std::size_t begin, std::size_t end) {
            const auto count = static_cast<Index>(end - begin), first = n - static_cast<Index>(end);
            Matrix part(count, 3);
            kernels<double>().project_thin(k, count, a_transposed.col(first).data(),
                                           a_transposed.outerStride(), x.data(), x.rows(),
                                           part.data(), count);
            field.middleRows(first, count) = part;
        });
}

}  // namespace mien::dense
