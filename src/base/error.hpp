// One small exception hierarchy for the whole core. Statuses map one to one onto the C ABI's codes.
#pragma once

#include <cstdint>
#include <exception>

namespace mien {

/// The numbers are frozen: they are the C ABI's numbers.
enum class Status : std::int32_t {
    ok = 0,
    invalid_argument = -1,  ///< a parameter is out of its range
    invalid_handle = -2,    ///< null, released or of another type
    invalid_mesh = -3,      ///< empty, not finite, index out of range, degenerate
    buffer_too_small = -4,
    unsupported_option = -5,   ///< an options struct asks for what this library does not know
    unsupported_version = -6,  ///< ABI or file format of another major version
    no_memory = -7,
    memory_budget = -8,  ///< the session's max_bytes would be exceeded
    io = -9,             ///< a file cannot be opened, read or written
    bad_format = -10,    ///< a file is not what its format says
    corrupt = -11,       ///< hash mismatch or values that are not finite
    wrong_kind = -12,    ///< a good file of another kind
    mismatch = -13,      ///< two inputs do not belong together (vertex counts, topology)
    no_solution = -14,   ///< a factorisation or iteration failed
    not_found = -15,     ///< a name (landmark, zone, expression) is unknown
    cancelled = -16,
    callback = -17,  ///< a host callback unwound
    internal = -18,
    busy = -19,        ///< another thread's call is using the session
    time_limit = -20,  ///< the session's max_seconds have passed
};

/// Carries its text in place, so that throwing and copying never allocates for the text.
class Error : public std::exception {
  public:
    Error(Status status, std::int64_t detail_index, const char* message) noexcept;
    const char* what() const noexcept override { return message_; }
    Status status() const noexcept { return status_; }
    /// First offending index (vertex, triangle, tensor entry), or -1.
    std::int64_t detail_index() const noexcept { return detail_index_; }

  private:
    Status status_;
    std::int64_t detail_index_;
    char message_[256];
};

/// Throws an Error with a printf-style text. Say what, where, and what to do.
[[noreturn]] void fail(Status status, const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// The same with the first offending index.
[[noreturn]] void fail_at(Status status, std::int64_t detail_index, const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

}  // namespace mien
