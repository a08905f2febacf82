// Arrays across the boundary: reading the host's views, the two-call protocol for outputs.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "base/error.hpp"
#include "base/types.hpp"
#include "mesh/tri_mesh.hpp"
#include "mien/mien.h"

namespace mien::abi {

/// The most names that a list of the host's can have.
constexpr std::uint64_t kMostNames = 100000;

/// Text from the host: not null.
const char* checked_text(const char* text, const char* parameter);

/// The view behind the pointer: not null, aligned. Before any reference to it is made.
const mien_array_view& checked_view(const mien_array_view* view, const char* name);

/// Checks null, alignment, stride, dtype and count * stride overflow of a #rows x columns view.
void check_view(const mien_array_view& view, int columns, const char* name);

/// Reads a #rows x 3 F32 or F64 view as float64. Values are not checked to be finite.
Points read_points(const mien_array_view& view, const char* name);
/// Reads a #rows x 1 F32 or F64 view as float64.
Vector read_values(const mien_array_view& view, const char* name);

/// Throws for null (unless count is 0), for misalignment and for a count above `most`, before
/// anything is read: a count that nothing honest can have is a mistake of the host's, and following
/// it would run off the end of its array.
void check_array(const void* data, std::uint64_t count, std::size_t alignment, std::uint64_t most,
                 const char* name);
/// A copy of a checked array.
template <typename T>
std::vector<T> read_array(const T* data, std::uint64_t count, std::uint64_t most,
                          const char* name) {
    check_array(data, count, alignof(T), most, name);
    return count == 0 ? std::vector<T>() : std::vector<T>(data, data + count);
}
/// Writes a number that a host asked for; a null `out` asks for none. Byte by byte: a misaligned
/// `out` gets its number too.
template <typename T, typename Value>
void store(T* out, const Value& value) {
    if (out == nullptr) return;
    const T converted = static_cast<T>(value);
    std::memcpy(static_cast<void*>(out), &converted, sizeof converted);
}
/// Throws for an array to be written that is misaligned; null is allowed.
template <typename T>
void check_output(const T* out, const char* name) {
    if (reinterpret_cast<std::uintptr_t>(out) % alignof(T) != 0)
        fail(Status::invalid_argument, "%s is not aligned to its values", name);
}

/// A set of vertices of a surface with num_vertices: never more numbers than that. Whether each is
/// in range is for the core to say.
std::vector<std::uint32_t> read_vertices(const std::uint32_t* vertices, std::uint64_t count,
                                         Index num_vertices, const char* name);

/// A named set of vertices of a surface with num_vertices.
Zone read_zone(const mien_zone& zone, Index num_vertices);
/// `count` of them, at most 100000; `name` is the parameter's.
std::vector<Zone> read_zones(const mien_zone* zones, std::uint64_t count, Index num_vertices,
                             const char* name);

/// Writes the count, and says whether dst is to be filled; a short capacity throws as below.
bool wants_copy(std::uint64_t rows, const void* dst, std::uint64_t capacity, std::uint64_t* count);
/// The two-call protocol: with dst null and capacity 0 writes *count only; a short capacity throws
/// Status::buffer_too_small with *count written and dst untouched. `rows` of row_bytes each.
void copy_rows(const void* source, std::uint64_t rows, std::size_t row_bytes, void* dst,
               std::uint64_t capacity, std::uint64_t* count);
/// The same for a #rows x columns float64 row-major array, converted to dtype F32 or F64.
void copy_doubles(const double* source, std::uint64_t rows, std::uint64_t columns, mien_dtype dtype,
                  void* dst, std::uint64_t capacity, std::uint64_t* count);
/// The same for text: count includes the terminating zero, capacity is in bytes.
void copy_text(const char* source, std::size_t length, char* dst, std::uint64_t capacity,
               std::uint64_t* count);

}  // namespace mien::abi
