#include "base/memory_budget.hpp"

#include <cstdlib>

#include "base/context.hpp"

#if defined(__GLIBC__) || defined(__linux__)
#include <malloc.h>
#elif defined(__APPLE__)
#include <malloc/malloc.h>
#elif defined(_WIN32)
#include <malloc.h>
#endif

namespace mien {
namespace {

thread_local MemoryBudget* budget_of_thread = nullptr;  // trivial: does not pin the library

std::size_t size_of_block(void* block) noexcept {
#if defined(__linux__)
    return malloc_usable_size(block);
#elif defined(__APPLE__)
    return malloc_size(block);
#elif defined(_WIN32)
    return block == nullptr ? 0 : _msize(block);
#else
    (void)block;
    return 0;
#endif
}

}  // namespace

MemoryBudget* current_budget() noexcept {
    return budget_of_thread;
}

BudgetScope::BudgetScope(MemoryBudget* budget) noexcept : before_(budget_of_thread) {
    budget_of_thread = budget;
}

BudgetScope::~BudgetScope() {
    budget_of_thread = before_;
}

void check_interrupt() {
    if (budget_of_thread != nullptr && budget_of_thread->context != nullptr)
        budget_of_thread->context->check_cancelled();
}

namespace {

/// Adds `bytes` to what is live unless that would exceed the limit; the sum as it was found.
bool try_reserve(MemoryBudget& budget, std::size_t bytes, std::int64_t& found) noexcept {
    if (budget.max_bytes == 0) {
        budget.live.fetch_add(static_cast<std::int64_t>(bytes), std::memory_order_relaxed);
        return true;
    }
    found = budget.live.load(std::memory_order_relaxed);
    do {
        if (bytes > budget.max_bytes || found > static_cast<std::int64_t>(budget.max_bytes - bytes))
            return false;
    } while (!budget.live.compare_exchange_weak(found, found + static_cast<std::int64_t>(bytes),
                                                std::memory_order_relaxed));
    return true;
}

/// The block is larger or smaller than what was reserved for it.
void settle(std::size_t block_bytes, std::size_t reserved) noexcept {
    if (budget_of_thread != nullptr)
        budget_of_thread->live.fetch_add(
            static_cast<std::int64_t>(block_bytes) - static_cast<std::int64_t>(reserved),
            std::memory_order_relaxed);
}

}  // namespace

void reserve_budget(std::size_t bytes) {
    std::int64_t found = 0;
    if (budget_of_thread != nullptr && !try_reserve(*budget_of_thread, bytes, found))
        throw BudgetExceeded(bytes, found, budget_of_thread->max_bytes);
}

bool reserves_budget(std::size_t bytes) noexcept {
    std::int64_t found = 0;
    return budget_of_thread == nullptr || try_reserve(*budget_of_thread, bytes, found);
}

void return_budget(std::size_t bytes) noexcept {
    settle(0, bytes);
}

std::shared_ptr<char> counted_block(std::size_t bytes) {
    // With its size on the way back, which is what the shared library's operators count.
    return {static_cast<char*>(::operator new(bytes)),
            [bytes](char* block) { ::operator delete(block, bytes); }};
}

void* counted_malloc(std::size_t bytes) {
    reserve_budget(bytes);
    void* const block = std::malloc(bytes);
    settle(budget_of_thread == nullptr || block == nullptr ? 0 : size_of_block(block), bytes);
    return block;
}

void* counted_realloc(void* block, std::size_t bytes) {
    if (budget_of_thread == nullptr) return std::realloc(block, bytes);
    const std::size_t before = block == nullptr ? 0 : size_of_block(block);
    const std::size_t growth = bytes > before ? bytes - before : 0;
    reserve_budget(growth);
    void* const grown = std::realloc(block, bytes);
    // One that failed has left the block as it was.
    settle(grown == nullptr ? before : size_of_block(grown), before + growth);
    return grown;
}

void counted_free(void* block) noexcept {
    if (budget_of_thread != nullptr && block != nullptr) return_budget(size_of_block(block));
    std::free(block);
}

}  // namespace mien
