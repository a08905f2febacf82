// The objects behind the C handles: a type tag first, then a reference count, then the payload.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "base/error.hpp"
#include "mien/mien.h"

namespace mien::abi {

enum class Tag : std::uint32_t {
    released = 0xDEADC0DE,
    session = 0x4D530001,
    cancel = 0x4D530002,
    mesh = 0x4D530003,
    dataset_writer = 0x4D530004,
    model = 0x4D530005,
    registration = 0x4D530006,
    expression_model = 0x4D530007,
    neutralization = 0x4D530008,
    measurement = 0x4D530009,
    score_model = 0x4D53000A,
    spectral_basis = 0x4D53000B,
    representation = 0x4D53000C,
    hierarchy = 0x4D53000D,
    series = 0x4D53000E,
    transfer = 0x4D53000F,
    tuning = 0x4D530020,
    evaluation = 0x4D530010,
    visits = 0x4D530012,
    landmarks = 0x4D530030,
    zones = 0x4D530031,
    study = 0x4D530013,
    network = 0x4D530014,
    anthropometry = 0x4D530016,
    norms = 0x4D530017,
    follower = 0x4D530018,
    ready_scan = 0x4D530019,
    batch = 0x4D53001A,
};

/// Base of every object behind a handle. Never moved; freed by release().
struct Object {
    explicit Object(Tag object_tag) : tag(object_tag) {}
    std::atomic<Tag> tag;  // first word: catches wrong types and most stale handles, best effort
    std::atomic<std::uint32_t> references{1};
};

/// The C struct T (derived from Object, with `static constexpr Tag kTag` and a name) behind a
/// pointer. Throws invalid_handle for null, misaligned, released or foreign pointers.
template <typename T>
T& checked(T* handle, const char* parameter) {
    if (handle == nullptr) fail(Status::invalid_handle, "%s is null", parameter);
    if (reinterpret_cast<std::uintptr_t>(handle) % alignof(T) != 0)
        fail(Status::invalid_handle, "%s is misaligned", parameter);
    const Tag tag = handle->tag.load(std::memory_order_relaxed);
    if (tag == Tag::released) fail(Status::invalid_handle, "%s was released before", parameter);
    if (tag != std::remove_const_t<T>::kTag)
        fail(Status::invalid_handle, "%s is not a %s", parameter, std::remove_const_t<T>::kName);
    return *handle;
}

template <typename T>
bool is_live(const T* handle) noexcept {
    return handle != nullptr && reinterpret_cast<std::uintptr_t>(handle) % alignof(T) == 0 &&
           handle->tag.load(std::memory_order_relaxed) == T::kTag;
}

template <typename T>
void retain(T* handle) noexcept {
    if (is_live(handle)) handle->references.fetch_add(1, std::memory_order_relaxed);
}

template <typename T>
void release(T* handle) noexcept {
    if (!is_live(handle)) return;
    if (handle->references.fetch_sub(1, std::memory_order_acq_rel) != 1) return;
    handle->tag.store(Tag::released, std::memory_order_relaxed);
    delete handle;
}

}  // namespace mien::abi
