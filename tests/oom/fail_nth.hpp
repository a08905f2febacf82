// Makes the nth allocation of the process fail, for every n in turn: each must end in a clean error
// and leak nothing. Include it in ONE source file of an executable: it takes the place of the
// malloc family for the whole process (operator new and the shared library's calls included).
//
//   oom::Sweep sweep("mesh load");
//   sweep.run([&] { return oom::clean(load() is fine or out of memory); });
//   return sweep.report();
//
// The body is called again and again. It must return true when the outcome was right (the result or
// a clean out-of-memory error) and release what it made; before the sweep it runs twice without
// failures, so that what is allocated once for good is there already. Each allocation is failed
// twice over: alone, and together with all that follow. glibc only; elsewhere and under
// sanitizers available() is false.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MIEN_OOM_AVAILABLE 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MIEN_OOM_AVAILABLE 0
#endif
#endif
#if !defined(MIEN_OOM_AVAILABLE)
#if defined(__GLIBC__)
#define MIEN_OOM_AVAILABLE 1
#else
#define MIEN_OOM_AVAILABLE 0
#endif
#endif

namespace oom {

/// What the allocator below looks at. Relaxed atomics: other threads may allocate too.
struct Control {
    std::atomic<bool> armed{false};
    std::atomic<bool> persistent{false};
    std::atomic<long> fail_at{0};         ///< 1 is the first allocation after arming
    std::atomic<long> seen{0};            ///< allocations since arming
    std::atomic<long> live{0};            ///< blocks taken and not given back, always counted
    std::atomic<long long> bytes{0};      ///< the same in bytes, as the system rounds them
    std::atomic<long long> peak{0};       ///< highest `bytes` since it was set
    std::atomic<std::size_t> largest{0};  ///< largest single request since it was set to 0
    std::atomic<std::size_t> refuse_above{~std::size_t(0)};  ///< larger requests fail, always
};
inline Control control;

inline bool available() {
    return MIEN_OOM_AVAILABLE != 0;
}

inline void count_bytes(long long change) {
    const long long now = control.bytes += change;
    long long peak = control.peak.load(std::memory_order_relaxed);
    while (now > peak && !control.peak.compare_exchange_weak(peak, now)) {
    }
}

/// True when this request is to fail.
inline bool refuses(std::size_t size) {
    std::size_t largest = control.largest.load(std::memory_order_relaxed);
    while (size > largest && !control.largest.compare_exchange_weak(largest, size)) {
    }
    if (size > control.refuse_above.load(std::memory_order_relaxed)) return true;
    if (!control.armed.load(std::memory_order_relaxed)) return false;
    const long number = ++control.seen;
    const long fail_at = control.fail_at.load(std::memory_order_relaxed);
    return number == fail_at ||
           (number > fail_at && control.persistent.load(std::memory_order_relaxed));
}

class Sweep {
  public:
    explicit Sweep(std::string name) : name_(std::move(name)) {}

    /// Every `stride`-th allocation is failed, the first one always.
    template <typename Body>
    void run(Body&& body, long stride = 1) {
        if (!available()) return;
        for (int round = 0; round < 2; ++round)
            if (!body()) fault("fails without a failing allocation", 0, false);
        for (bool persistent : {false, true})
            for (long n = 1;; n += stride) {
                const long live_before = control.live.load();
                control.persistent = persistent;
                control.fail_at = n;
                control.seen = 0;
                control.armed = true;
                const bool right = body();
                control.armed = false;
                if (control.seen.load() < n) {
                    allocations_ = control.seen.load();
                    break;
                }
                ++points_;
                if (!right) fault("ends wrongly", n, persistent);
                if (control.live.load() != live_before) fault("leaks", n, persistent);
            }
    }

    /// Prints one line; 0 when all is well.
    int report() const {
        if (!available())
            std::printf("%-24s not available in this build\n", name_.c_str());
        else
            std::printf("%-24s %6ld allocations, %6ld failures tried, %ld faults\n", name_.c_str(),
                        allocations_, points_, faults_);
        return faults_ == 0 ? 0 : 1;
    }

  private:
    void fault(const char* what, long n, bool persistent) {
        if (++faults_ <= 10)
            std::printf("%s: %s with allocation %ld failing%s\n", name_.c_str(), what, n,
                        persistent ? " and all after it" : "");
    }

    std::string name_;
    long points_ = 0, allocations_ = 0, faults_ = 0;
};

}  // namespace oom

#if MIEN_OOM_AVAILABLE

#include <malloc.h>

extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* block, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
void __libc_free(void* block) noexcept;
}

namespace oom {
/// Counts a block, or says that there is none.
inline void* taken(void* block) {
    if (block == nullptr) {
        errno = ENOMEM;
        return nullptr;
    }
    ++control.live;
    count_bytes(static_cast<long long>(malloc_usable_size(block)));
    return block;
}
}  // namespace oom

extern "C" {
__attribute__((visibility("default"))) void* malloc(std::size_t size) noexcept {
    return oom::taken(oom::refuses(size) ? nullptr : __libc_malloc(size));
}
__attribute__((visibility("default"))) void* calloc(std::size_t count, std::size_t size) noexcept {
    return oom::taken(oom::refuses(count * size) ? nullptr : __libc_calloc(count, size));
}
__attribute__((visibility("default"))) void* realloc(void* old, std::size_t size) noexcept {
    if (oom::refuses(size)) {
        errno = ENOMEM;
        return nullptr;
    }
    const long long before = old == nullptr ? 0 : static_cast<long long>(malloc_usable_size(old));
    void* block = __libc_realloc(old, size);
    if (block == nullptr && size != 0) return nullptr;
    oom::count_bytes((block == nullptr ? 0 : static_cast<long long>(malloc_usable_size(block))) -
                     before);
    if (old == nullptr && block != nullptr) ++oom::control.live;
    if (old != nullptr && block == nullptr) --oom::control.live;
    return block;
}
__attribute__((visibility("default"))) void* memalign(std::size_t alignment,
                                                      std::size_t size) noexcept {
    return oom::taken(oom::refuses(size) ? nullptr : __libc_memalign(alignment, size));
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment,
                                                           std::size_t size) noexcept {
    return memalign(alignment, size);
}
__attribute__((visibility("default"))) int posix_memalign(void** out, std::size_t alignment,
                                                          std::size_t size) noexcept {
    void* block = memalign(alignment, size);
    if (block == nullptr) return ENOMEM;
    *out = block;
    return 0;
}
__attribute__((visibility("default"))) void free(void* block) noexcept {
    if (block != nullptr) {
        --oom::control.live;
        oom::count_bytes(-static_cast<long long>(malloc_usable_size(block)));
    }
    __libc_free(block);
}
}

#endif
