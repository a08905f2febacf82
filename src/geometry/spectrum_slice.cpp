// Block Lanczos with full orthogonalisation and without restart: a slice is narrow enough for its
// space to stay small, and blocks turn the orthogonalisation into matrix products and share each
// read of the factor among eight right-hand sides.
#include "geometry/spectrum_slice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/symmetric_eigen.hpp"

namespace mien {
namespace {

// Residual of a pair relative to its eigenvalue of the inverse. Vectors of neighbouring slices are
// orthogonal to about this; merging repairs the rest.
constexpr double kResidual = 1e-11;

class BlockLanczos {
  public:
    BlockLanczos(const ShiftedFactor& factor, const KernelProjector& kernel, Index n,
                 Index capacity, std::uint64_t seed, const Context& context)
        : factor_(factor),
          kernel_(kernel),
          n_(n),
          state_(seed),
          space_(n, capacity),
          rows_(n * kSolveBlock),
          block_(n, kSolveBlock),
          projected_(Matrix::Zero(capacity, capacity)) {
        serial_.cancel = context.cancel;
        serial_.deadline = context.deadline;
        for (int c = 0; c < kSolveBlock; ++c) fill_random(block_.col(c));
        kernel_.remove(block_);
        orthonormalise(coupling_);
        space_.leftCols(kSolveBlock) = block_;
        size_ = kSolveBlock;
    }

    Index size() const { return size_; }
    Index capacity() const { return space_.cols(); }

    /// Applies the operator to the newest block and appends the next one.
    void step() {
        serial_.check_cancelled();
        const Index newest = size_ - kSolveBlock;
        for (int c = 0; c < kSolveBlock; ++c)
            for (Index i = 0; i < n_; ++i) rows_[i * kSolveBlock + c] = space_(i, newest + c);
        factor_.solve(rows_.data());
        for (int c = 0; c < kSolveBlock; ++c)
            for (Index i = 0; i < n_; ++i) block_(i, c) = rows_[i * kSolveBlock + c];
        kernel_.remove(block_);

        // First the two blocks of the three-term recurrence, then everything: one full pass is then
        // as good as two.
        const Index recent = std::min<Index>(size_, 2 * kSolveBlock);
        Matrix local(recent, kSolveBlock);
        project_out(size_ - recent, recent, local);
        Matrix full(size_, kSolveBlock);
        project_out(0, size_, full);
        local += full.bottomRows(recent);
        const auto diagonal = local.bottomRows(kSolveBlock);
        projected_.block(newest, newest, kSolveBlock, kSolveBlock) =
            0.5 * (diagonal + diagonal.transpose());
        orthonormalise(coupling_);
        if (size_ + kSolveBlock <= capacity()) {
            space_.middleCols(size_, kSolveBlock) = block_;
            projected_.block(size_, newest, kSolveBlock, kSolveBlock) = coupling_;
        }
        size_ += kSolveBlock;
    }

    /// The Ritz values theta = 1 / (lambda - shift) of the `below` eigenvalues nearest below the
    /// shift and the `above` nearest above it, ascending in lambda, and their vectors in space().
    /// False: some are not converged yet.
    bool find_wanted(Index below, Index above, Vector& theta, Matrix& vectors) const {
        const Index m = size_ - kSolveBlock;  // all but the newest block
        if (below + above > m) return false;
        Matrix reduced = projected_.topLeftCorner(m, m);
        const SymmetricSpectrum spectrum(reduced, "a slice of the spectrum", serial_);
        const Vector& all = spectrum.values();
        if (below > 0 && !(all[below - 1] < 0)) return false;
        if (above > 0 && !(all[m - above] > 0)) return false;
        // The most negative is the nearest below, the largest the nearest above.
        theta.resize(below + above);
        theta << all.head(below).reverse(), all.tail(above).reverse();
        vectors.resize(m, below + above);
        vectors << spectrum.vectors(0, below, serial_).rowwise().reverse(),
            spectrum.vectors(m - above, above, serial_).rowwise().reverse();
        const Vector residuals =
            (coupling_ * vectors.bottomRows(kSolveBlock)).colwise().norm().transpose();
        return (residuals.array() <= kResidual * theta.array().abs()).all();
    }

    const Matrix& space() const { return space_; }

  private:
    // splitmix64: the same start vectors everywhere.
    double random() {
        state_ += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1.0p-52 - 1.0;
    }
    void fill_random(Eigen::Ref<Vector> v) {
        for (Index i = 0; i < v.size(); ++i) v[i] = random();
    }

    void project_out(Index first, Index count, Matrix& coefficients) {
        dense::multiply(serial_, 1.0, space_.middleCols(first, count), dense::Op::transpose, block_,
                        dense::Op::none, 0.0, coefficients);
        dense::multiply(serial_, -1.0, space_.middleCols(first, count), dense::Op::none,
                        coefficients, dense::Op::none, 1.0, block_);
    }

    /// block_ = Q R by twice-iterated Gram-Schmidt; a direction that vanishes (an invariant space
    /// was found) is replaced by a random one with a zero in R.
    void orthonormalise(Matrix& r) {
        r = Matrix::Zero(kSolveBlock, kSolveBlock);
        const double scale = block_.colwise().norm().maxCoeff();
        bool weak = false;
        for (int c = 0; c < kSolveBlock; ++c) {
            for (int attempt = 0; attempt < 8; ++attempt) {
                const double before = block_.col(c).norm();
                for (int pass = 0; pass < 2; ++pass)
                    for (int d = 0; d < c; ++d) {
                        const double h = block_.col(d).dot(block_.col(c));
                        block_.col(c) -= h * block_.col(d);
                        if (attempt == 0) r(d, c) += h;
                    }
                const double after = block_.col(c).norm();
                if (after > 1e-13 * scale && after > 1e-14 * before && after > 0) {
                    block_.col(c) /= after;
                    if (attempt == 0) r(c, c) = after;
                    weak = weak || after < 1e-3 * scale;
                    break;
                }
                weak = true;
                Vector fresh(n_);
                fill_random(fresh);
                block_.col(c) = fresh * (scale > 0 ? scale / fresh.norm() : 1.0 / fresh.norm());
                kernel_.remove(block_.col(c));
                clean_against_space(c);
            }
        }
        if (weak && size_ > 0) {
            // Dividing by a small norm magnified what was left of the older vectors.
            Matrix unused(size_, kSolveBlock);
            project_out(0, size_, unused);
            for (int c = 0; c < kSolveBlock; ++c) {
                for (int d = 0; d < c; ++d)
                    block_.col(c) -= block_.col(d).dot(block_.col(c)) * block_.col(d);
                block_.col(c).normalize();
            }
        }
    }

    void clean_against_space(int c) {
        if (size_ == 0) return;
        const auto basis = space_.leftCols(size_);
        const Vector h = basis.transpose() * block_.col(c);
        block_.col(c) -= basis * h;
    }

    const ShiftedFactor& factor_;
    const KernelProjector& kernel_;
    Index n_;
    std::uint64_t state_;
    Context serial_;  // products inside a slice stay on the slice's thread
    Matrix space_;
    std::vector<double> rows_;
    Matrix block_;
    Matrix coupling_;
    Matrix projected_;
    Index size_ = 0;
};

}  // namespace

void KernelProjector::remove(Eigen::Ref<Matrix> block) const {
    Vector sums(num_components);
    for (Index c = 0; c < block.cols(); ++c) {
        sums.setZero();
        for (Index i = 0; i < block.rows(); ++i)
            sums[component[static_cast<std::size_t>(i)]] += direction[i] * block(i, c);
        for (Index i = 0; i < block.rows(); ++i)
            block(i, c) -= sums[component[static_cast<std::size_t>(i)]] * direction[i];
    }
}

SlicePairs slice_eigenpairs(const ShiftedFactor& factor, const KernelProjector& kernel, Index below,
                            Index above, std::uint64_t seed, const Context& context) {
    const Index n = kernel.direction.size(), wanted = below + above;
    // Measured: about 2.2 vectors a pair plus a few blocks; then a look every three blocks.
    const Index first_look = std::min(n, kSolveBlock * (6 + (22 * wanted) / (10 * kSolveBlock)));
    const Index largest =
        std::min(n, 4 * first_look + 20 * kSolveBlock) / kSolveBlock * kSolveBlock;
    context.require_memory(static_cast<std::size_t>(n) * (largest + wanted) * sizeof(double),
                           "a slice of the spectrum");
    BlockLanczos lanczos(factor, kernel, n, largest, seed, context);
    Vector theta;
    Matrix weights;
    Index next_look = first_look;
    while (true) {
        if (lanczos.size() > largest)
            fail(Status::no_solution,
                 "Lanczos near the shift %.9g did not find %lld eigenpairs in %lld vectors",
                 factor.shift(), static_cast<long long>(wanted), static_cast<long long>(largest));
        lanczos.step();
        if (lanczos.size() - kSolveBlock < std::min(next_look, largest)) continue;
        if (lanczos.find_wanted(below, above, theta, weights)) break;
        next_look = lanczos.size() + 2 * kSolveBlock;
    }

    SlicePairs pairs;
    pairs.vectors.resize(n, wanted);
    pairs.num_below = below;
    Context serial;
    serial.cancel = context.cancel;
    serial.deadline = context.deadline;
    dense::multiply(serial, 1.0, lanczos.space().leftCols(weights.rows()), dense::Op::none, weights,
                    dense::Op::none, 0.0, pairs.vectors);
    pairs.values = factor.shift() + theta.array().inverse();
    return pairs;
}

}  // namespace mien
