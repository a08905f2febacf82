#include "base/dense.hpp"

#include <gtest/gtest.h>

#include "base/thread_pool.hpp"

namespace mien {
namespace {

// A fixed, chance-free test matrix.
template <typename Scalar>
Eigen::Matrix<Scalar, -1, -1> waves(Index rows, Index cols, double phase) {
    Eigen::Matrix<Scalar, -1, -1> m(rows, cols);
    for (Index j = 0; j < cols; ++j)
        for (Index i = 0; i < rows; ++i)
            m(i, j) = static_cast<Scalar>(std::sin(phase + 0.37 * i + 1.91 * j * j));
    return m;
}

TEST(Dense, ProductsAgreeWithPlainEigen) {
    const Matrix a = waves<double>(703, 41, 0.1), b = waves<double>(41, 29, 0.2);
    Matrix c = Matrix::Ones(703, 29);
    dense::multiply({}, 2.0, a, dense::Op::none, b, dense::Op::none, 3.0, c);
    EXPECT_LT((c - (2.0 * a * b + Matrix::Constant(703, 29, 3.0))).cwiseAbs().maxCoeff(), 1e-11);
    Matrix d(41, 41);
    dense::multiply({}, 1.0, a, dense::Op::transpose, a, dense::Op::none, 0.0, d);
    EXPECT_LT((d - a.transpose() * a).cwiseAbs().maxCoeff(), 1e-10);
    Matrix e(41, 703);
    dense::multiply({}, 1.0, a, dense::Op::transpose, Matrix::Identity(703, 703),
                    dense::Op::transpose, 0.0, e);
    EXPECT_LT((e - a.transpose()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Dense, WeightedGramSkipsZeroWeights) {
    Matrix a = waves<double>(1500, 23, 0.4);
    Vector w = Vector::LinSpaced(1500, 0.0, 2.0);
    w.segment(300, 100).setZero();
    Matrix c(23, 23);
    dense::weighted_gram({}, a, w, c);
    EXPECT_LT((c - a.transpose() * w.asDiagonal() * a).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ((c - c.transpose()).cwiseAbs().maxCoeff(), 0.0);
}

TEST(Dense, SameBitsForAnyThreadCount) {
    const Eigen::MatrixXf a = waves<float>(5000, 60, 0.3);
    const Eigen::VectorXf w = Eigen::VectorXf::LinSpaced(5000, 0.1f, 1.0f);
    Eigen::MatrixXf one(60, 60), many(60, 60);
    dense::weighted_gram({}, a, w, one);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    dense::weighted_gram(context, a, w, many);
    EXPECT_TRUE((one.array() == many.array()).all());
}

TEST(Dense, SolvesPositiveDefiniteAndRefusesIndefinite) {
    const Matrix a = waves<double>(90, 30, 0.9);
    Matrix spd = a.transpose() * a + Matrix::Identity(30, 30);
    const Matrix truth = waves<double>(30, 3, 0.0);
    Matrix x = spd * truth, first = x.leftCols(1);
    ASSERT_TRUE(dense::factor_spd(spd));
    dense::solve_factored(spd, x);
    EXPECT_LT((x - truth).cwiseAbs().maxCoeff(), 1e-10);
    dense::solve_factored(spd, first);
    EXPECT_LT((first - truth.leftCols(1)).cwiseAbs().maxCoeff(), 1e-10);
    Matrix indefinite = -Matrix::Identity(4, 4);
    EXPECT_FALSE(dense::factor_spd(indefinite));
}

// 1003 rows and 42 columns: neither a whole number of strips, of packets nor of column groups.
TEST(Dense, ProductsWithABlockOfVectorsAgreeWithPlainEigenOnBothInstructionSets) {
    ThreadPool pool(3);
    Context threads;
    threads.pool = &pool;
    const Matrix wide = waves<double>(4099, 50, 0.3);
    const auto a = wide.middleCols(3, 41);
    for (const bool portable : {true, false})
        for (const Index columns : {4, 8}) {
            dense::use_portable_loops(portable);
            const Matrix x = waves<double>(41, columns, 0.7), y = waves<double>(4099, columns, 0.2);
            Matrix expanded = y, projected = x, same = x;
            dense::multiply({}, -2.0, a, dense::Op::none, x, dense::Op::none, 3.0, expanded);
            EXPECT_LT((expanded - (3 * y - 2 * a * x)).cwiseAbs().maxCoeff(), 1e-11);
            dense::multiply({}, 0.5, a, dense::Op::transpose, y, dense::Op::none, -1.0, projected);
            EXPECT_LT((projected - (0.5 * a.transpose() * y - x)).cwiseAbs().maxCoeff(), 1e-10);
            dense::multiply(threads, 0.5, a, dense::Op::transpose, y, dense::Op::none, -1.0, same);
            EXPECT_TRUE((same.array() == projected.array()).all());
        }
    dense::use_portable_loops(false);
}

TEST(Dense, ThinProductsAgreeWithPlainEigenOnBothInstructionSets) {
    const Eigen::MatrixXf a = waves<float>(1003, 42, 0.3), x = waves<float>(42, 3, 0.7);
    const dense::Field given = waves<float>(1003, 3, 0.5);
    const dense::Field expanded = given + a * x;
    const dense::Field changed = 2 * expanded;
    // In double precision: Eigen's own order of summation differs between processors.
    const Eigen::MatrixXf projected =
        (a.cast<double>().transpose() * changed.cast<double>()).cast<float>();
    for (const bool portable : {true, false}) {
        dense::use_portable_loops(portable);
        dense::Field field = given;
        Eigen::MatrixXf out;
        dense::add_thin_product({}, a, x, field);
        EXPECT_LT((field - expanded).cwiseAbs().maxCoeff(), 1e-4);
        field = given;
        const auto twice = [&](Index first, Index count) { field.middleRows(first, count) *= 2; };
        dense::expand_and_project({}, a, x, field, twice, out);
        EXPECT_LT((field - changed).cwiseAbs().maxCoeff(), 1e-4);
        EXPECT_LT((out - projected).cwiseAbs().maxCoeff(), 1e-2);
        dense::project_thin({}, a, changed, out);
        EXPECT_LT((out - projected).cwiseAbs().maxCoeff(), 1e-2);
    }
}

TEST(Dense, ProductsWithOneColumnAgreeWithPlainEigenOnBothInstructionSets) {
    const Eigen::MatrixXf a = waves<float>(7001, 53, 0.3);
    const Vector x = waves<double>(53, 1, 0.7), y = waves<double>(7001, 1, 0.5);
    const Vector moved = y + a.cast<double>() * x, projected = a.cast<double>().transpose() * y;
    for (const bool portable : {true, false}) {
        dense::use_portable_loops(portable);
        Vector out = y;
        dense::add_product({}, a, x, out);
        EXPECT_LT((out - moved).cwiseAbs().maxCoeff(), 1e-4);
        EXPECT_LT((dense::project({}, a, y) - projected).cwiseAbs().maxCoeff(), 1e-2);
    }
}

TEST(Dense, ProductsOfRowsAgreeWithPlainEigenOnBothInstructionSets) {
    const Matrix rows = waves<double>(43, 1003, 0.3), x = waves<double>(43, 3, 0.7);
    const Points field = waves<double>(1003, 3, 0.5);
    for (const bool portable : {true, false}) {
        dense::use_portable_loops(portable);
        Matrix projected;
        Points expanded;
        dense::project_rows({}, rows, field, projected);
        dense::expand_rows({}, rows, x, expanded);
        EXPECT_LT((projected - rows * field).cwiseAbs().maxCoeff(), 1e-11);
        EXPECT_LT((expanded - rows.transpose() * x).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(Dense, ThinProductsHaveTheSameBitsForAnyThreadCount) {
    const Eigen::MatrixXf a = waves<float>(5000, 60, 0.3), x = waves<float>(60, 3, 0.1);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    dense::Field one = dense::Field::Zero(5000, 3), many = one;
    Eigen::MatrixXf projected_one, projected_many;
    dense::expand_and_project(
        {}, a, x, one, [](Index, Index) {}, projected_one);
    dense::expand_and_project(
        context, a, x, many, [](Index, Index) {}, projected_many);
    EXPECT_TRUE((one.array() == many.array()).all());
    EXPECT_TRUE((projected_one.array() == projected_many.array()).all());
}

}  // namespace
}  // namespace mien
