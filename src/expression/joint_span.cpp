#include "expression/joint_span.hpp"

#include <cmath>
#include <cstdint>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

constexpr Index kBlockColumns = 192;

/// splitmix64 of the row and column, as a number in [-1, 1).
double start_value(std::uint64_t row, std::uint64_t column) {
    std::uint64_t z = (row << 20) + column + 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
    return static_cast<double>(static_cast<std::int64_t>(z >> 11)) * 0x1p-52 - 1.0;
}

/// Calls visit(first, block) over all columns of X - mean or of Y.
template <typename Visit>
void for_each_block(const ColumnSource& source, bool identity, const Vector& mean, Matrix& buffer,
                    Visit&& visit) {
    const Index count = identity ? source.num_neutrals() : source.num_displacements();
    for (Index first = 0; first < count; first += kBlockColumns) {
        const Index size = std::min(kBlockColumns, count - first);
        auto block = buffer.leftCols(size);
        if (identity) {
            source.neutrals(first, block);
            block.colwise() -= mean;
        } else {
            source.displacements(first, block);
        }
        visit(first, block);
    }
}

class PassCounter {
  public:
    PassCounter(const Context& context, int total) : context_(context), total_(total) {}
    void step() { context_.progress(Stage::training, 0.9 * ++done_ / total_); }

  private:
    const Context& context_;
    int total_, done_ = 0;
};

/// Leading `rank` directions of the columns by block power iteration; where that is all of them,
/// the columns' own span, which keeps the weakest ones too.
Matrix leading_directions(const Context& context, const ColumnSource& source, bool identity,
                          const Vector& mean, Index rank, int passes, Matrix& buffer,
                          PassCounter& counter) {
    const Index rows = source.num_rows();
    const Index count = identity ? source.num_neutrals() : source.num_displacements();
    if (rank >= (identity ? count - 1 : count)) {
        Matrix columns(rows, count);
        for_each_block(source, identity, mean, buffer, [&](Index first, auto block) {
            context.check_cancelled();
            columns.middleCols(first, block.cols()) = block;
        });
        orthonormalize(context, columns);
        for (int pass = 0; pass < passes; ++pass) counter.step();
        return columns;
    }
    Matrix basis(rows, rank), next(rows, rank);
    for (Index column = 0; column < rank; ++column)
        for (Index row = 0; row < rows; ++row)
            basis(row, column) =
                start_value(static_cast<std::uint64_t>(row),
                            static_cast<std::uint64_t>(column) + (identity ? 0u : 4096u));
    Matrix coordinates;
    for (int pass = 0; pass < passes; ++pass) {
        next.setZero(rows, basis.cols());
        for_each_block(source, identity, mean, buffer, [&](Index, auto block) {
            context.check_cancelled();
            coordinates.resize(block.cols(), basis.cols());
            dense::multiply(context, 1.0, block, dense::Op::transpose, basis, dense::Op::none, 0.0,
                            coordinates);
            dense::multiply(context, 1.0, block, dense::Op::none, coordinates, dense::Op::none, 1.0,
                            next);
        });
        basis.swap(next);
        orthonormalize(context, basis);
        counter.step();
    }
    return basis;
}

}  // namespace

void orthonormalize(const Context& context, Matrix& block) {
    // Twice: the first round leaves an error of the order of the squared condition, the second
    // none.
    for (int round = 0; round < 2; ++round) {
        Matrix gram(block.cols(), block.cols());
        dense::weighted_gram(context, block, Vector(), gram);
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram);
        if (eigen.info() != Eigen::Success)
            fail(Status::no_solution,
                 "the orthonormalisation of the training data did not converge");
        const Vector values = eigen.eigenvalues().reverse();
        Index rank = 0;
        while (rank < values.size() && values[rank] > 1e-14 * values[0]) ++rank;
        if (rank == 0)
            fail(Status::invalid_argument,
                 "the training faces do not differ: nothing can be learned from them");
        const Matrix mix = eigen.eigenvectors().rowwise().reverse().leftCols(rank) *
                           values.head(rank).cwiseSqrt().cwiseInverse().asDiagonal();
        Matrix rotated(block.rows(), rank);
        dense::multiply(context, 1.0, block, dense::Op::none, mix, dense::Op::none, 0.0, rotated);
        block.swap(rotated);
    }
}

JointSpan find_joint_span(const Context& context, const ColumnSource& source,
                          const JointSpanOptions& options) {
    if (options.identity_rank < 1 || options.expression_rank < 1 || options.passes < 1 ||
        options.passes > 50)
        fail(Status::invalid_argument,
             "the joint span needs ranks of at least 1 and 1 to 50 passes");
    const Index rows = source.num_rows();
    const Index identity_rank =
        std::min(options.identity_rank, std::max<Index>(1, source.num_neutrals() - 1));
    const Index expression_rank = std::min(options.expression_rank, source.num_displacements());
    const Index columns = kBlockColumns + 2 * (identity_rank + expression_rank);
    context.require_memory(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) * 8,
                           "training an expression model");
    Matrix buffer(rows, kBlockColumns);
    PassCounter counter(context, 2 * options.passes + 3);

    JointSpan span;
    Vector sum = Vector::Zero(rows);
    for_each_block(source, true, Vector::Zero(rows), buffer,
                   [&](Index, auto block) { sum += block.rowwise().sum(); });
    span.mean = sum / static_cast<double>(source.num_neutrals());
    counter.step();

    {
        const Matrix identity = leading_directions(context, source, true, span.mean, identity_rank,
                                                   options.passes, buffer, counter);
        const Matrix expression = leading_directions(
            context, source, false, span.mean, expression_rank, options.passes, buffer, counter);
        span.basis.resize(rows, identity.cols() + expression.cols());
        span.basis << identity, expression;
    }
    orthonormalize(context, span.basis);
    counter.step();

    const Index rank = span.basis.cols();
    auto coordinates = [&](bool identity, Matrix& out, double& energy, double& cut) {
        out.resize(rank, identity ? source.num_neutrals() : source.num_displacements());
        for_each_block(source, identity, span.mean, buffer, [&](Index first, auto block) {
            context.check_cancelled();
            dense::multiply(context, 1.0, span.basis, dense::Op::transpose, block, dense::Op::none,
                            0.0, out.middleCols(first, block.cols()));
            energy += block.squaredNorm();
        });
        cut = std::max(0.0, energy - out.squaredNorm());
    };
    coordinates(true, span.neutrals, span.neutral_energy, span.neutral_energy_cut);
    coordinates(false, span.displacements, span.displacement_energy, span.displacement_energy_cut);
    counter.step();
    return span;
}

}  // namespace mien
