#include "base/memory_budget.hpp"

#include <gtest/gtest.h>

#include <atomic>
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

TEST(MemoryBudget, EigensMatricesCountWhileTheyLive) {
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

// Eigen's way where malloc() does not align enough: AVX2 copies of sources, AddressSanitizer.
TEST(MemoryBudget, BlocksAlignedByHandCountToo) {
    MemoryBudget budget;
    budget.max_bytes = 100000;
    const BudgetScope scope(&budget);
    void* block = Eigen::internal::handmade_aligned_malloc(50000, 64);
    EXPECT_GE(budget.live.load(), 50000);
    EXPECT_LT(budget.live.load(), 50200);
    EXPECT_THROW(Eigen::internal::handmade_aligned_malloc(60000, 64), BudgetExceeded);
    Eigen::internal::handmade_aligned_free(block);
    EXPECT_EQ(budget.live.load(), 0);
    block = Eigen::internal::handmade_aligned_malloc(20000);
    block = Eigen::internal::handmade_aligned_realloc(block, 70000);
    EXPECT_GE(budget.live.load(), 70000);
    EXPECT_THROW(Eigen::internal::handmade_aligned_realloc(block, 200000), BudgetExceeded);
    EXPECT_GE(budget.live.load(), 70000);
    Eigen::internal::handmade_aligned_free(block);
    EXPECT_EQ(budget.live.load(), 0);
}

// Each thread looked first and counted later, so that each of them got the last block.
TEST(MemoryBudget, ThreadsThatAskAtOnceGetNoMoreThanThereIs) {
    MemoryBudget budget;
    budget.max_bytes = 1000;
    for (int round = 0; round < 200; ++round) {
        std::atomic<int> ready{0}, granted{0};
        std::vector<std::thread> threads;
        for (int k = 0; k < 4; ++k)
            threads.emplace_back([&] {
                const BudgetScope scope(&budget);
                for (++ready; ready < 4;) std::this_thread::yield();
                for (int ask = 0; ask < 10; ++ask) granted += reserves_budget(100) ? 1 : 0;
            });
        for (std::thread& thread : threads) thread.join();
        ASSERT_EQ(granted.load(), 10) << "round " << round;
        ASSERT_EQ(budget.live.load(), 1000);
        const BudgetScope scope(&budget);
        EXPECT_THROW(reserve_budget(1), BudgetExceeded);
        return_budget(1000);
    }
}

TEST(MemoryBudget, HoldsForAllThreadsOfACallTogether) {
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
    // Threads that ask in the same moment: only one gets the last block.
    EXPECT_LE(budget.live.load(), 400000 + 16 * 40);
    EXPECT_GE(budget.live.load(), 320000);
    // Outside of the call nothing is refused.
    const BudgetScope none(nullptr);
    EXPECT_NO_THROW(Matrix(1000, 1000));
}

TEST(MemoryBudget, AnEstimateAddsToWhatIsInUse) {
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
