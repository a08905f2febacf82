// The boundary: no exception, signal or changed floating-point mode crosses it.
#pragma once

#include <cfenv>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#if defined(__GLIBC__)
#include <pthread.h>
#endif

#include "base/error.hpp"
#include "base/memory_budget.hpp"
#include "mien/mien.h"

namespace mien::abi {

/// Writes a record within the caller's struct_size; `error` may be null.
void write_error(mien_error* error, mien_status status, std::int64_t detail_index,
                 const char* message) noexcept;
/// The record of an allocation that the budget refused.
void write_budget_error(mien_error* error, const BudgetExceeded& refused) noexcept;

/// Normalises rounding, exceptions and flush-to-zero for the call and puts the host's mode back;
/// holds off thread cancellation, whose forced unwinding would abort in a noexcept frame.
class HostState {
  public:
    HostState() noexcept {
        std::fegetenv(&environment_);
        std::fesetenv(FE_DFL_ENV);
#if defined(__GLIBC__)
        pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &cancel_state_);
#endif
    }
    ~HostState() {
#if defined(__GLIBC__)
        pthread_setcancelstate(cancel_state_, nullptr);
#endif
        std::fesetenv(&environment_);
    }
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

  private:
    std::fenv_t environment_;
#if defined(__GLIBC__)
    int cancel_state_ = 0;
#endif
};

/// Runs a body and turns whatever it throws into a status. Handlers never allocate.
template <typename Body>
mien_status guarded(mien_error* error, Body&& body) noexcept {
    const HostState host_state;
    try {
        body();
        write_error(error, MIEN_OK, -1, "");
        return MIEN_OK;
    } catch (const BudgetExceeded& refused) {
        write_budget_error(error, refused);
        return MIEN_E_MEMORY_BUDGET;
    } catch (const std::bad_alloc&) {
        write_error(error, MIEN_E_NO_MEMORY, -1,
                    "out of memory; release something or give a smaller input");
        return MIEN_E_NO_MEMORY;
    } catch (const Error& failure) {
        const auto status = static_cast<mien_status>(failure.status());
        write_error(error, status, failure.detail_index(), failure.what());
        return status;
    } catch (const std::length_error&) {
        write_error(error, MIEN_E_INVALID_ARGUMENT, -1, "a size is larger than memory can address");
        return MIEN_E_INVALID_ARGUMENT;
    } catch (const std::exception& failure) {
        write_error(error, MIEN_E_INTERNAL, -1, failure.what());
        return MIEN_E_INTERNAL;
    } catch (...) {
        write_error(error, MIEN_E_INTERNAL, -1, "an unknown exception inside the library");
        return MIEN_E_INTERNAL;
    }
}

/// The same for functions that make a handle: *out is null unless the body returns one.
template <typename Handle, typename Body>
mien_status guarded_create(Handle** out, mien_error* error, Body&& body) noexcept {
    // Byte by byte: a misaligned `out` gets its handle too.
    const auto set = [out](Handle* made) {
        std::memcpy(static_cast<void*>(out), &made, sizeof made);
    };
    if (out != nullptr) set(nullptr);
    return guarded(error, [&] {
        if (out == nullptr) fail(Status::invalid_argument, "out is null");
        set(body());
    });
}

}  // namespace mien::abi
