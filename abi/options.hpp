// The options-struct protocol: a field exists iff the caller's struct_size covers it whole; a
// struct that is longer than known is accepted only with a zero tail.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "base/error.hpp"
#include "mien/config.h"

/// The size of an options struct's first release, by the last field that it had: frozen, and right
/// for every pointer width.
#define MIEN_FIRST_SIZE(Struct, last_field) \
    (offsetof(Struct, last_field) + sizeof(Struct::last_field))

namespace mien::abi {

/// For the init functions: `defaults` within the caller's size, zeroes beyond what is known.
template <typename Options>
void write_defaults(Options* options, std::size_t struct_size, Options defaults) noexcept {
    if (options == nullptr || struct_size < sizeof(std::uint32_t)) return;
    defaults.struct_size = static_cast<std::uint32_t>(struct_size);
    std::memset(static_cast<void*>(options), 0, struct_size);
    std::memcpy(static_cast<void*>(options), &defaults, std::min(struct_size, sizeof defaults));
}

/// The caller's options over the defaults; null gives the defaults. minimum_size is
/// MIEN_FIRST_SIZE of the struct and never changes.
template <typename Options>
Options read_options(const Options* options, const Options& defaults, std::size_t minimum_size,
                     const char* name) {
    if (options == nullptr) return defaults;
    if (reinterpret_cast<std::uintptr_t>(options) % alignof(Options) != 0)
        fail(Status::invalid_argument, "%s is misaligned", name);
    const std::size_t size = options->struct_size;
    if (size < minimum_size)
        fail(Status::invalid_argument, "%s.struct_size is %zu, below %zu: call its _init function",
             name, size, minimum_size);
    if (size > 4096)
        fail(Status::unsupported_option, "%s.struct_size is %zu: call its _init function", name,
             size);
    const auto* bytes = reinterpret_cast<const unsigned char*>(options);
    for (std::size_t i = sizeof(Options); i < size; ++i)
        if (bytes[i] != 0)
            fail(Status::unsupported_option,
                 "%s sets an option at byte %zu that this library (%s) does not know", name, i,
                 MIEN_VERSION_STRING);
    Options merged = defaults;
    std::memcpy(static_cast<void*>(&merged), options, std::min(size, sizeof(Options)));
    return merged;
}

/// Copies a struct out within the caller's struct_size, which is kept; minimum_size as above.
template <typename Struct>
void write_struct(Struct* out, Struct value, std::size_t minimum_size, const char* name = "out") {
    if (out == nullptr) fail(Status::invalid_argument, "%s is null", name);
    if (reinterpret_cast<std::uintptr_t>(out) % alignof(Struct) != 0)
        fail(Status::invalid_argument, "%s is misaligned", name);
    const std::size_t size = out->struct_size;
    if (size < minimum_size || size > 4096)
        fail(Status::invalid_argument, "%s.struct_size is %zu; set it to the struct's size first",
             name, size);
    value.struct_size = static_cast<std::uint32_t>(size);
    if (size > sizeof value) std::memset(static_cast<void*>(out), 0, size);
    std::memcpy(static_cast<void*>(out), &value, std::min(size, sizeof value));
}

/// Refuses what is not a number, also where a call would not read it: such a value is a mistake of
/// the host's.
struct NamedNumber {
    const char* name;
    double value;
};
inline void check_numbers(std::initializer_list<NamedNumber> numbers,
                          const char* options = "options") {
    for (const NamedNumber& number : numbers)
        if (std::isnan(number.value))
            fail(Status::invalid_argument, "%s.%s is not a number", options, number.name);
}

/// One status for one kind of mistake: a switch or an enumerator that this library does not know is
/// unsupported_option, as an option or as an argument, since a later library may know it. Numbers
/// out of their range are invalid_argument.
inline bool read_switch(std::int32_t value, const char* name) {
    if (value != 0 && value != 1)
        fail(Status::unsupported_option, "%s is %d, allowed are 0 and 1", name, value);
    return value == 1;
}
inline void check_choice(std::int32_t value, std::int32_t first, std::int32_t last,
                         const char* name) {
    if (value < first || value > last)
        fail(Status::unsupported_option, "%s is %d, allowed are %d to %d", name, value, first,
             last);
}

}  // namespace mien::abi
