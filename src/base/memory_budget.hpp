// What one call has allocated, counted while it runs, so that a session's max_bytes holds for
// everything that the call does and not only for what somebody thought of estimating.
//
// The count is of this library's own allocations: Eigen's (cmake/MienEigen.cmake leads them here)
// and, in the shared library on systems whose linker can wrap a symbol, those of operator new with
// a known size (abi/memory_count.cpp). Blocks that an earlier call made and this one gives back
// count against it, which is what the process sees.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace mien {

class Context;

/// Of one call, shared by the threads that work on it.
struct MemoryBudget {
    /// The call's own, or null: what code without a context, such as Eigen's decompositions, asks
    /// whether the call is cancelled or late.
    const Context* context = nullptr;
    std::size_t max_bytes = 0;          ///< 0: no limit
    std::atomic<std::int64_t> live{0};  ///< taken and not given back since the call began
};

/// An allocation that the budget refuses: wherever memory can run out, this can happen too.
class BudgetExceeded : public std::bad_alloc {
  public:
    BudgetExceeded(std::size_t asked, std::int64_t live, std::size_t max) noexcept
        : asked_bytes(asked), live_bytes(live), max_bytes(max) {}
    const char* what() const noexcept override {
        return "the call needs more memory than the session's budget";
    }
    const std::size_t asked_bytes;
    const std::int64_t live_bytes;
    const std::size_t max_bytes;
};

/// The budget that this thread's allocations count towards, or null.
MemoryBudget* current_budget() noexcept;

/// Makes a budget the current one of this thread for as long as it lives.
class BudgetScope {
  public:
    explicit BudgetScope(MemoryBudget* budget) noexcept;
    ~BudgetScope();
    BudgetScope(const BudgetScope&) = delete;
    BudgetScope& operator=(const BudgetScope&) = delete;

  private:
    MemoryBudget* before_;
};

/// Throws as Context::check_cancelled() of the current budget's context does; nothing without one.
void check_interrupt();

/// Counts `bytes` towards the current budget, before they are allocated: throws BudgetExceeded, and
/// counts nothing, when they would exceed it. Exact however many threads ask at once.
void reserve_budget(std::size_t bytes);
/// The same without throwing; false when they would.
bool reserves_budget(std::size_t bytes) noexcept;
void return_budget(std::size_t bytes) noexcept;
/// A block of bytes, not initialised, that counts while it lives; arrays of new[] do not.
std::shared_ptr<char> counted_block(std::size_t bytes);
/// malloc(), realloc() and free() that count blocks by the size that the system gave them (a system
/// that does not tell it has them uncounted). Null when the system has no memory; throws
/// BudgetExceeded. Eigen's blocks come from here.
void* counted_malloc(std::size_t bytes);
void* counted_realloc(void* block, std::size_t bytes);
void counted_free(void* block) noexcept;

}  // namespace mien
