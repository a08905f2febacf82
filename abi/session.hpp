// Sessions, and the Context that a call hands to the core.
#pragma once

#include <memory>
#include <mutex>
#include <thread>

#include "base/context.hpp"
#include "base/memory_budget.hpp"
#include "handle.hpp"

struct mien_session : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::session;
    static constexpr const char* kName = "session";
    mien_session() : Object(kTag) {}
    std::unique_ptr<mien::ThreadPool> pool;  // null with one thread
    std::size_t max_bytes = 0;
    double max_seconds = 0;
    bool copy_files = false;
    std::mutex use;  // guards the two below: who is in a call, and how deep
    std::thread::id user;
    int depth = 0;
    mien_log_fn log = nullptr;
    void* log_user = nullptr;
};

struct mien_cancel : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::cancel;
    static constexpr const char* kName = "cancel token";
    mien_cancel() : Object(kTag) {}
    mien::CancelToken token;
};

namespace mien::abi {

/// The right to use a session with threads of its own: Status::busy while another thread's call has
/// it, because two at a time would wait for each other for ever. A callback may call again.
class SessionUse {
  public:
    explicit SessionUse(mien_session& session);
    ~SessionUse();
    SessionUse(const SessionUse&) = delete;
    SessionUse& operator=(const SessionUse&) = delete;

  private:
    mien_session& session_;
};

/// What one call runs with. Keeps the cancel token alive; callbacks that throw end the call with
/// Status::callback. Lives on the thread of the call, whose allocations it counts.
class Call {
  public:
    explicit Call(mien_session* session, mien_progress_fn progress = nullptr,
                  void* progress_user = nullptr, mien_cancel* cancel = nullptr);
    ~Call();
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    const Context& context() const { return context_; }

  private:
    static std::int32_t forward_progress(void* call, std::int32_t stage, double fraction);
    static void forward_log(void* call, std::int32_t level, const char* message);

    Context context_;
    mien_session& session_;
    const SessionUse use_;
    MemoryBudget budget_;
    const BudgetScope scope_;
    // Progress as the host has seen it: a fraction never falls within a stage.
    mutable std::int32_t stage_ = 0;
    mutable double fraction_ = 0;
    mien_progress_fn progress_;
    void* progress_user_;
    mien_cancel* cancel_;
};

}  // namespace mien::abi
