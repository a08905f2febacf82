// A vector whose elements begin with any bits: for large arrays that are filled at once, which
// would otherwise be written twice.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace mien {

template <typename T>
struct RawAllocator : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>, "nothing may depend on its first bits");
    template <typename U>
    struct rebind {  // NOLINT: the standard's name
        using other = RawAllocator<U>;
    };
    template <typename U>
    void construct(U* place) noexcept {
        ::new (static_cast<void*>(place)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
};

/// resize() and RawVector(n) leave new numbers unset; all else is std::vector's.
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace mien
