#include "base/memory_budget.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <thread>

#include "base/context.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/types.hpp"

namespace {

using namespace mien;

// Under AddressSanitizer Eigen aligns blocks by hand, which is not counted; every other build
// counts.
#if defined(__SANITIZE_ADDRESS__)
#define MIEN_NEEDS_COUNTED_BLOCKS() GTEST_SKIP() << "Eigen's blocks are not counted in this build"
#else
#define MIEN_NEEDS_COUNTED_BLOCKS() static_cast<void>(0)
#endif

TEST(MemoryBudget, EigensMatricesCountWhileTheyLive) {
    MIEN_NEEDS_COUNTED_BLOCKS();
    MemoryBudget budget;
    budget.max_bytes = 1 << 20;
    const BudgetScope scope(&budget);
    {
        const Matrix kept = Matrix::Zero(100, 100);
        EXPECT_GE(budget.live.load(), 80000);
        EXPECT_LT(budget.live.load(), 81000);
        EXPECT_THROW(Matrix::Zero(1000, 1000).eval(), BudgetExceeded);
        EXPECT_THROW(Matrix::Zero(1000, 1000).eval(), std::bad_alloc);
        Matrix grown = kept;
        EXPECT_THROW(grown.conservativeResize(1000, 1000), BudgetExceeded);
        EXPECT_EQ(grown, kept);
        EXPECT_THROW(grown.resize(1000, 1000), BudgetExceeded);
        EXPECT_EQ(grown.size(), 0);
    }
    EXPECT_EQ(budget.live.load(), 0);
}

TEST(MemoryBudget, SparseMatricesCountToo) {
    MemoryBudget budget;
    budget.max_bytes = 100000;
    const BudgetScope scope(&budget);
    {
        Eigen::SparseMatrix<double> sparse(100, 100);
        sparse.reserve(2000);
        EXPECT_GE(budget.live.load(), 24000);
        EXPECT_THROW(sparse.reserve(20000), BudgetExceeded);
        EXPECT_EQ(sparse.nonZeros(), 0);
    }
    EXPECT_EQ(budget.live.load(), 0);
}

TEST(MemoryBudget, HoldsForAllThreadsOfACallTogether) {
    MIEN_NEEDS_COUNTED_BLOCKS();
    ThreadPool pool(4);
    Context context;
    context.pool = &pool;
    MemoryBudget budget;
    budget.max_bytes = 400000;
    const BudgetScope scope(&budget);
    std::vector<Matrix> blocks(16);
    EXPECT_THROW(parallel_for(context, blocks.size(), 1,
                              [&](std::size_t k, std::size_t) { blocks[k].resize(100, 100); }),
                 BudgetExceeded);
    // Threads that ask in the same moment may each get the last block.
    EXPECT_LE(budget.live.load(), 400000 + 4 * 80100);
    EXPECT_GE(budget.live.load(), 320000);
    // Outside of the call nothing is refused.
    const BudgetScope none(nullptr);
    EXPECT_NO_THROW(Matrix(1000, 1000));
}

TEST(MemoryBudget, AnEstimateAddsToWhatIsInUse) {
    MIEN_NEEDS_COUNTED_BLOCKS();
    MemoryBudget budget;
    Context context;
    context.max_bytes = budget.max_bytes = 100000;
    const BudgetScope scope(&budget);
    EXPECT_NO_THROW(context.require_memory(60000, "a test"));
    const Vector held = Vector::Zero(10000);
    EXPECT_THROW(context.require_memory(60000, "a test"), Error);
}

TEST(TimeLimit, EndsALoopBetweenTwoChunks) {
    Context context;
    context.deadline = Context::Clock::now() + std::chrono::milliseconds(20);
    int chunks = 0;
    try {
        parallel_for(context, 1000, 1, [&](std::size_t, std::size_t) {
            ++chunks;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        });
        ADD_FAILURE() << "the limit was not kept";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::time_limit);
    }
    EXPECT_GE(chunks, 1);
    EXPECT_LT(chunks, 20);
}

// An eigenproblem of a kernel's control points took half a second in which nothing could stop it.
TEST(TimeLimit, EndsADecompositionBetweenItsSteps) {
    Context context;
    context.deadline = Context::Clock::now();
    MemoryBudget budget;
    budget.context = &context;
    const Matrix matrix = Matrix::Identity(200, 200) + Matrix::Constant(200, 200, 0.1);
    Eigen::SparseMatrix<double> sparse = matrix.sparseView();
    const BudgetScope scope(&budget);
    EXPECT_THROW(Eigen::SelfAdjointEigenSolver<Matrix>{matrix}, Error);
    EXPECT_THROW(Eigen::LLT<Matrix>{matrix}, Error);
    EXPECT_THROW(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>{sparse}, Error);
    const BudgetScope none(nullptr);
    EXPECT_NO_THROW(Eigen::SelfAdjointEigenSolver<Matrix>{matrix});
}

}  // namespace
