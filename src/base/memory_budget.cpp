#include "base/memory_budget.hpp"

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

bool exceeds_budget(std::size_t bytes) noexcept {
    const MemoryBudget* const budget = budget_of_thread;
    if (budget == nullptr || budget->max_bytes == 0) return false;
    if (bytes > budget->max_bytes) return true;
    return budget->live.load(std::memory_order_relaxed) >
           static_cast<std::int64_t>(budget->max_bytes - bytes);
}

void check_budget(std::size_t bytes) {
    if (exceeds_budget(bytes))
        throw BudgetExceeded(bytes, budget_of_thread->live.load(std::memory_order_relaxed),
                             budget_of_thread->max_bytes);
}

void count_taken(std::size_t bytes) noexcept {
    if (budget_of_thread != nullptr)
        budget_of_thread->live.fetch_add(static_cast<std::int64_t>(bytes),
                                         std::memory_order_relaxed);
}

void count_given(std::size_t bytes) noexcept {
    if (budget_of_thread != nullptr)
        budget_of_thread->live.fetch_sub(static_cast<std::int64_t>(bytes),
                                         std::memory_order_relaxed);
}

std::shared_ptr<char> counted_block(std::size_t bytes) {
    // With its size on the way back, which is what the shared library's operators count.
    return {static_cast<char*>(::operator new(bytes)),
            [bytes](char* block) { ::operator delete(block, bytes); }};
}

void count_taken_block(void* block) noexcept {
    if (budget_of_thread != nullptr) count_taken(size_of_block(block));
}

void count_given_block(void* block) noexcept {
    if (budget_of_thread != nullptr) count_given(size_of_block(block));
}

}  // namespace mien
