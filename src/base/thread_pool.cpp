#include "base/thread_pool.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/memory_budget.hpp"

namespace mien {

struct ThreadPool::State {
    std::vector<std::thread> workers;
    std::mutex mutex;
    std::condition_variable wake, finished;
    // The loop: written under the mutex while no worker is at work.
    const std::function<void(std::size_t)>* body = nullptr;
    std::size_t num_chunks = 0;
    MemoryBudget* budget = nullptr;  // of the caller; the workers' allocations are its own
    std::atomic<std::size_t> next_chunk{0};
    std::atomic<bool> failed{false};
    std::exception_ptr error;
    std::size_t error_chunk = std::numeric_limits<std::size_t>::max();
    unsigned long generation = 0;
    std::size_t at_work = 0;  // workers
    bool open = false;        // a worker may still join: who wakes late holds nobody up
    bool stopping = false;

    void work() noexcept {
        const BudgetScope scope(budget);
        for (;;) {
            if (failed.load(std::memory_order_relaxed)) return;
            const std::size_t chunk = next_chunk.fetch_add(1, std::memory_order_relaxed);
            if (chunk >= num_chunks) return;
            try {
                (*body)(chunk);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                if (chunk < error_chunk) {
                    error_chunk = chunk;
                    error = std::current_exception();
                }
                failed.store(true, std::memory_order_relaxed);
            }
        }
    }

    void worker_loop() noexcept {
        unsigned long seen = 0;
        std::unique_lock<std::mutex> lock(mutex);
        for (;;) {
            wake.wait(lock, [&] { return stopping || generation != seen; });
            if (stopping) return;
            seen = generation;
            if (!open) continue;  // the others have done it
            ++at_work;
            lock.unlock();
            work();
            lock.lock();
            if (--at_work == 0) finished.notify_one();
        }
    }

    void stop() noexcept {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            stopping = true;
        }
        wake.notify_all();
        for (std::thread& worker : workers) worker.join();
    }
};

namespace {
thread_local bool inside_pool = false;  // trivially destructible: does not pin the library
}

ThreadPool::ThreadPool(int num_threads) : state_(std::make_unique<State>()) {
    try {
        for (int i = 1; i < num_threads; ++i)
            state_->workers.emplace_back([state = state_.get()] {
                inside_pool = true;
                state->worker_loop();
            });
    } catch (...) {
        state_->stop();
        throw;
    }
}

ThreadPool::~ThreadPool() {
    state_->stop();
}

int ThreadPool::num_threads() const noexcept {
    return static_cast<int>(state_->workers.size()) + 1;
}

void ThreadPool::run(std::size_t num_chunks, const std::function<void(std::size_t)>& body) {
    if (state_->workers.empty() || inside_pool || num_chunks <= 1) {
        for (std::size_t chunk = 0; chunk < num_chunks; ++chunk) body(chunk);
        return;
    }
    State& state = *state_;
    {
        const std::lock_guard<std::mutex> lock(state.mutex);
        state.body = &body;
        state.num_chunks = num_chunks;
        state.budget = current_budget();
        state.next_chunk.store(0, std::memory_order_relaxed);
        state.failed.store(false, std::memory_order_relaxed);
        state.error = nullptr;
        state.error_chunk = std::numeric_limits<std::size_t>::max();
        state.open = true;
        ++state.generation;
    }
    state.wake.notify_all();
    inside_pool = true;
    state.work();
    inside_pool = false;
    std::unique_lock<std::mutex> lock(state.mutex);
    state.open = false;
    state.finished.wait(lock, [&] { return state.at_work == 0; });
    if (state.error) std::rethrow_exception(std::exchange(state.error, nullptr));
}

}  // namespace mien
