#include "session.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>

#include "arrays.hpp"
#include "base/dense.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"
#include "guard.hpp"
#include "options.hpp"

using namespace mien;
using namespace mien::abi;

namespace mien::abi {

SessionUse::SessionUse(mien_session& session) : session_(session) {
    if (session.pool == nullptr) return;
    const std::lock_guard<std::mutex> lock(session.use);
    if (session.depth != 0 && session.user != std::this_thread::get_id())
        fail(Status::busy,
             "the session is in a call on another thread; give each thread a session of its own");
    session.user = std::this_thread::get_id();
    ++session.depth;
}

SessionUse::~SessionUse() {
    if (session_.pool == nullptr) return;
    const std::lock_guard<std::mutex> lock(session_.use);
    --session_.depth;
}

Call::Call(mien_session* session, mien_progress_fn progress, void* progress_user,
           mien_cancel* cancel)
    : session_(checked(session, "session")),
      use_(session_),
      scope_(&budget_),
      progress_(progress),
      progress_user_(progress_user),
      cancel_(cancel == nullptr ? nullptr : &checked(cancel, "cancel")) {
    retain(cancel_);
    budget_.context = &context_;
    context_.pool = session_.pool.get();
    context_.max_bytes = budget_.max_bytes = session_.max_bytes;
    context_.copy_files = session_.copy_files;
    if (session_.max_seconds > 0)
        context_.deadline =
            Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(
                                        std::chrono::duration<double>(session_.max_seconds));
    if (cancel_ != nullptr) context_.cancel = &cancel_->token;
    if (progress_ != nullptr) {
        context_.progress_function = &Call::forward_progress;
        context_.progress_user = this;
    }
    if (session_.log != nullptr) {
        context_.log_function = &Call::forward_log;
        context_.log_user = this;
    }
}

Call::~Call() {
    release(cancel_);
}

std::int32_t Call::forward_progress(void* call, std::int32_t stage, double fraction) {
    const auto* self = static_cast<const Call*>(call);
    fraction = std::min(1.0, std::max(0.0, fraction));
    if (stage == self->stage_) fraction = std::max(fraction, self->fraction_);
    self->stage_ = stage;
    self->fraction_ = fraction;
    try {
        return self->progress_(self->progress_user_, stage, fraction);
    } catch (...) {
        fail(Status::callback,
             "the progress callback threw an exception; callbacks must not unwind");
    }
}

void Call::forward_log(void* call, std::int32_t level, const char* message) {
    const auto* self = static_cast<const Call*>(call);
    try {
        self->session_.log(self->session_.log_user, level, message);
    } catch (...) {
        fail(Status::callback, "the log callback threw an exception; callbacks must not unwind");
    }
}

namespace {

constexpr std::int32_t kMaxThreads = 256;
constexpr double kMaxSeconds = 1e8;  // three years: longer is no limit, and would not fit a clock

mien_session_options default_session_options() {
    mien_session_options options{};
    options.struct_size = sizeof options;
    options.num_threads = 1;
    return options;
}

mien_session* create_session(std::uint32_t abi_version, const mien_session_options* options) {
    if (abi_version != MIEN_ABI_VERSION)
        fail(Status::unsupported_version,
             "the program was built for Mien's ABI %u, this library (%s) offers %u", abi_version,
             MIEN_VERSION_STRING, MIEN_ABI_VERSION);
    const mien_session_options given =
        read_options(options, default_session_options(),
                     MIEN_FIRST_SIZE(mien_session_options, log_user), "options");
    if (given.num_threads < 1 || given.num_threads > kMaxThreads)
        fail(Status::invalid_argument, "options.num_threads is %d, allowed are 1 to %d",
             given.num_threads, kMaxThreads);
    if (!(given.max_seconds >= 0) || given.max_seconds > kMaxSeconds)
        fail(Status::invalid_argument, "options.max_seconds is %g, allowed are 0 (no limit) to %g",
             given.max_seconds, kMaxSeconds);
    if (given.copy_files != 0 && given.copy_files != 1)
        fail(Status::unsupported_option, "options.copy_files is %d, allowed are 0 and 1",
             given.copy_files);
    if (given.reserved != 0) fail(Status::unsupported_option, "options.reserved is not zero");
    auto session = std::make_unique<mien_session>();
    session->max_seconds = given.max_seconds;
    session->copy_files = given.copy_files == 1;
    session->max_bytes = static_cast<std::size_t>(given.max_bytes);
    session->log = given.log;
    session->log_user = given.log_user;
    if (given.num_threads > 1) {
        try {
            session->pool = std::make_unique<ThreadPool>(given.num_threads);
        } catch (const std::system_error&) {
            fail(Status::no_memory, "cannot start %d threads; ask for fewer",
                 given.num_threads - 1);
        }
    }
    return session.release();
}

}  // namespace
}  // namespace mien::abi

extern "C" {

void MIEN_CALL mien_session_options_init(mien_session_options* options, size_t struct_size) {
    write_defaults(options, struct_size, default_session_options());
}

mien_status MIEN_CALL mien_session_create(uint32_t abi_version, mien_session** out,
                                          mien_error* error) {
    return guarded_create(out, error, [&] { return create_session(abi_version, nullptr); });
}

mien_status MIEN_CALL mien_session_create_with_options(uint32_t abi_version,
                                                       const mien_session_options* options,
                                                       mien_session** out, mien_error* error) {
    return guarded_create(out, error, [&] { return create_session(abi_version, options); });
}

void MIEN_CALL mien_session_release(mien_session* session) {
    release(session);
}

mien_status MIEN_CALL mien_cancel_create(mien_cancel** out, mien_error* error) {
    return guarded_create(out, error, [] { return new mien_cancel; });
}

void MIEN_CALL mien_cancel_request(mien_cancel* cancel) {
    if (is_live(cancel)) cancel->token.request();
}

void MIEN_CALL mien_cancel_release(mien_cancel* cancel) {
    release(cancel);
}

mien_status MIEN_CALL mien_session_hash_file(mien_session* session, const char* path, char* dst,
                                             uint64_t capacity, uint64_t* count,
                                             mien_error* error) {
    return guarded(error, [&] {
        const Call call(session);
        const std::string name = checked_text(path, "path");
        std::string digest(Sha256::kDigits, '0');
        if (dst != nullptr && capacity > Sha256::kDigits) {
            constexpr std::size_t kPart = std::size_t{1} << 24;  // a large file stays out of memory
            const FileBytes file = map_file(name);
            Sha256 hash;
            for (std::size_t at = 0; at < file.size; at += kPart) {
                const std::size_t part = std::min(kPart, file.size - at);
                hash.update(file.data + at, part);
                release_pages(file.data + at, part);
                call.context().check_cancelled();
            }
            digest = hash.hex_digest();
        }
        copy_text(digest.data(), digest.size(), dst, capacity, count);
    });
}

uint32_t MIEN_CALL mien_version_number(void) {
    return MIEN_VERSION_MAJOR * 1000000u + MIEN_VERSION_MINOR * 1000u + MIEN_VERSION_PATCH;
}

const char* MIEN_CALL mien_version_string(void) {
    return MIEN_VERSION_STRING;
}

const char* MIEN_CALL mien_build_id(void) {
#if defined(__clang__)
#define MIEN_COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define MIEN_COMPILER "gcc " __VERSION__
#else
#define MIEN_COMPILER "unknown compiler"
#endif
    return dense::uses_avx2() ? "mien " MIEN_VERSION_STRING " " MIEN_COMPILER " avx2"
                              : "mien " MIEN_VERSION_STRING " " MIEN_COMPILER " portable";
}

}  // extern "C"
