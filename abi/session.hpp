// Sessions, and the Context that a call hands to the core.
#pragma once

#include <memory>

#include "base/context.hpp"
#include "handle.hpp"

struct mien_session : mien::abi::Object {
    static constexpr mien::abi::Tag kTag = mien::abi::Tag::session;
    static constexpr const char* kName = "session";
    mien_session() : Object(kTag) {}
    std::unique_ptr<mien::ThreadPool> pool;  // null with one thread
    std::size_t max_bytes = 0;
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

/// What one call runs with. Keeps the cancel token alive; callbacks that throw end the call with
/// Status::callback.
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
    mien_progress_fn progress_;
    void* progress_user_;
    mien_cancel* cancel_;
};

}  // namespace mien::abi
