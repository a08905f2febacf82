// Arrays across the boundary: reading the host's views, the two-call protocol for outputs.
#pragma once

#include <cstdint>
#include <cstring>

#include "base/error.hpp"
#include "base/types.hpp"
#include "mien/mien.h"

namespace mien::abi {

/// Checks null, alignment, stride, dtype and count * stride overflow of a #rows x columns view.
void check_view(const mien_array_view& view, int columns, const char* name);

/// Reads a #rows x 3 F32 or F64 view as float64. Values are not checked to be finite.
Points read_points(const mien_array_view& view, const char* name);
/// Reads a #rows x 1 F32 or F64 view as float64.
Vector read_values(const mien_array_view& view, const char* name);

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
