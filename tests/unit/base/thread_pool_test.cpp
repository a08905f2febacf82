#include "base/thread_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

TEST(ThreadPool, RunsEveryChunkOnce) {
    for (int threads : {1, 2, 5}) {
        ThreadPool pool(threads);
        for (int round = 0; round < 50; ++round) {
            std::vector<std::atomic<int>> seen(97);
            pool.run(seen.size(), [&](std::size_t chunk) { ++seen[chunk]; });
            for (const std::atomic<int>& count : seen) EXPECT_EQ(1, count.load());
        }
    }
}

// A worker that wakes late finds the loop closed, or the next one open: it must take part in that
// one alone, and nothing of a body may run once run() has returned.
TEST(ThreadPool, ALateWorkerNeverTouchesALoopThatIsDone) {
    ThreadPool pool(8);
    for (int round = 0; round < 5000; ++round) {
        std::vector<int> seen(2 + round % 3, 0);
        std::atomic<bool> done{false}, late{false};
        pool.run(seen.size(), [&](std::size_t chunk) {
            if (done) late = true;
            ++seen[chunk];
        });
        done = true;
        ASSERT_FALSE(late);
        for (const int count : seen) ASSERT_EQ(1, count);
    }
}

TEST(ThreadPool, RethrowsAndStaysUsable) {
    ThreadPool pool(3);
    for (int round = 0; round < 20; ++round) {
        EXPECT_THROW(pool.run(64,
                              [](std::size_t chunk) {
                                  if (chunk == 5) throw std::runtime_error("five");
                              }),
                     std::runtime_error);
        std::atomic<int> count{0};
        pool.run(64, [&](std::size_t) { ++count; });
        EXPECT_EQ(64, count.load());
    }
}

TEST(ThreadPool, NestedRunsStayOnTheirThread) {
    ThreadPool pool(2);
    std::atomic<int> count{0};
    pool.run(8, [&](std::size_t) { pool.run(8, [&](std::size_t) { ++count; }); });
    EXPECT_EQ(64, count.load());
}

double slow_sum(const Context& context) {
    return parallel_sum(context, 100003, 1000, 0.0, [](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += std::sin(static_cast<double>(i)) * 1e-3;
        return sum;
    });
}

TEST(Parallel, SumsHaveTheSameBitsForAnyThreadCount) {
    const double alone = slow_sum({});
    for (int threads : {1, 2, 3, 7}) {
        ThreadPool pool(threads);
        Context context;
        context.pool = &pool;
        EXPECT_EQ(alone, slow_sum(context)) << threads << " threads";
    }
}

TEST(Parallel, AnEmptyRangeDoesNothing) {
    parallel_for({}, 0, 10, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(Context, CancelTokenStopsALoop) {
    CancelToken token;
    Context context;
    context.cancel = &token;
    std::size_t done = 0;
    try {
        parallel_for(context, 100, 1, [&](std::size_t, std::size_t) {
            if (++done == 10) token.request();
        });
        FAIL() << "expected a cancellation";
    } catch (const Error& failure) {
        EXPECT_EQ(Status::cancelled, failure.status());
    }
    EXPECT_EQ(10u, done);
}

TEST(Context, ProgressCallbackCancels) {
    Context context;
    context.progress_function = [](void*, std::int32_t stage, double fraction) -> std::int32_t {
        return stage == static_cast<std::int32_t>(Stage::fitting) && fraction > 0.5;
    };
    context.progress(Stage::fitting, 0.5);
    EXPECT_THROW(context.progress(Stage::fitting, 0.6), Error);
}

TEST(Context, BudgetNamesWhatIsTooLarge) {
    Context context;
    context.max_bytes = 1000;
    context.require_memory(1000, "a basis");
    try {
        context.require_memory(1001, "a basis");
        FAIL();
    } catch (const Error& failure) {
        EXPECT_EQ(Status::memory_budget, failure.status());
        EXPECT_NE(std::string::npos, std::string(failure.what()).find("a basis"));
    }
}

TEST(Error, CutsLongTextsInsteadOfOverflowing) {
    const std::string long_text(1000, 'x');
    try {
        fail_at(Status::io, 42, "%s", long_text.c_str());
    } catch (const Error& failure) {
        EXPECT_EQ(255u, std::string(failure.what()).size());
        EXPECT_EQ(42, failure.detail_index());
    }
}

}  // namespace
}  // namespace mien
