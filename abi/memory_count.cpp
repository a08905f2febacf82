// Counts what operator new gives to the library's own code towards the memory budget of the running
// call. The linker leads the library's calls here (--wrap, CMakeLists.txt) and these lead them on
// to the process's operators, so a host that has replaced those keeps them. Only deallocations of
// known size are counted, because the size of a foreign block is nobody's to ask: they are those of
// the standard containers, where the memory is.
#include <cstddef>
#include <new>

#include "base/memory_budget.hpp"

// Names of operator new(size_t), its nothrow form and operator delete(void*, size_t) in the Itanium
// ABI, and of the first and the last for types of a larger alignment.
#if defined(_WIN64)
#define MIEN_NEW _Znwy
#define MIEN_NEW_NOTHROW _ZnwyRKSt9nothrow_t
#define MIEN_DELETE_SIZED _ZdlPvy
#define MIEN_NEW_ALIGNED _ZnwySt11align_val_t
#define MIEN_DELETE_ALIGNED _ZdlPvySt11align_val_t
#elif defined(__LP64__)
#define MIEN_NEW _Znwm
#define MIEN_NEW_NOTHROW _ZnwmRKSt9nothrow_t
#define MIEN_DELETE_SIZED _ZdlPvm
#define MIEN_NEW_ALIGNED _ZnwmSt11align_val_t
#define MIEN_DELETE_ALIGNED _ZdlPvmSt11align_val_t
#else
#define MIEN_NEW _Znwj
#define MIEN_NEW_NOTHROW _ZnwjRKSt9nothrow_t
#define MIEN_DELETE_SIZED _ZdlPvj
#define MIEN_NEW_ALIGNED _ZnwjSt11align_val_t
#define MIEN_DELETE_ALIGNED _ZdlPvjSt11align_val_t
#endif
#define MIEN_JOIN_NOW(a, b) a##b
#define MIEN_JOIN(a, b) MIEN_JOIN_NOW(a, b)
#define MIEN_WRAPPED(name) MIEN_JOIN(__wrap_, name)
#define MIEN_REAL(name) MIEN_JOIN(__real_, name)

extern "C" {

void* MIEN_REAL(MIEN_NEW)(std::size_t size);
void* MIEN_REAL(MIEN_NEW_NOTHROW)(std::size_t size, const std::nothrow_t& tag) noexcept;
void MIEN_REAL(MIEN_DELETE_SIZED)(void* block, std::size_t size) noexcept;
void* MIEN_REAL(MIEN_NEW_ALIGNED)(std::size_t size, std::align_val_t alignment);
void MIEN_REAL(MIEN_DELETE_ALIGNED)(void* block, std::size_t size,
                                    std::align_val_t alignment) noexcept;

void* MIEN_WRAPPED(MIEN_NEW)(std::size_t size) {
    mien::reserve_budget(size);
    try {
        return MIEN_REAL(MIEN_NEW)(size);
    } catch (...) {
        mien::return_budget(size);
        throw;
    }
}

void* MIEN_WRAPPED(MIEN_NEW_NOTHROW)(std::size_t size, const std::nothrow_t& tag) noexcept {
    if (!mien::reserves_budget(size)) return nullptr;
    void* const block = MIEN_REAL(MIEN_NEW_NOTHROW)(size, tag);
    if (block == nullptr) mien::return_budget(size);
    return block;
}

void MIEN_WRAPPED(MIEN_DELETE_SIZED)(void* block, std::size_t size) noexcept {
    if (block != nullptr) mien::return_budget(size);
    MIEN_REAL(MIEN_DELETE_SIZED)(block, size);
}

void* MIEN_WRAPPED(MIEN_NEW_ALIGNED)(std::size_t size, std::align_val_t alignment) {
    mien::reserve_budget(size);
    try {
        return MIEN_REAL(MIEN_NEW_ALIGNED)(size, alignment);
    } catch (...) {
        mien::return_budget(size);
        throw;
    }
}

void MIEN_WRAPPED(MIEN_DELETE_ALIGNED)(void* block, std::size_t size,
                                       std::align_val_t alignment) noexcept {
    if (block != nullptr) mien::return_budget(size);
    MIEN_REAL(MIEN_DELETE_ALIGNED)(block, size, alignment);
}

}  // extern "C"
