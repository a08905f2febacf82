// A small pool for loops over fixed chunks. The cut into chunks never depends on the number of
// threads, so a result that is reduced chunk by chunk in order has the same bits for any number.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace mien {

class ThreadPool {
  public:
    /// Starts num_threads - 1 workers; 1 starts none.
    explicit ThreadPool(int num_threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int num_threads() const noexcept;

    /// Calls body(chunk) for chunk = 0 .. num_chunks - 1, each once, in any order, on the workers
    /// and the calling thread; returns when all are done. The exception of the lowest chunk that
    /// threw is rethrown here; chunks not yet begun are then skipped. A call from inside a body
    /// runs on the calling thread.
    void run(std::size_t num_chunks, const std::function<void(std::size_t)>& body);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace mien
