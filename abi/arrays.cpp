#include "arrays.hpp"

#include <cstdio>
#include <limits>

namespace mien::abi {
namespace {

template <typename Scalar>
void read_rows(const mien_array_view& view, int columns, double* out) {
    const std::size_t stride = view.stride_bytes != 0
                                   ? static_cast<std::size_t>(view.stride_bytes)
                                   : sizeof(Scalar) * static_cast<std::size_t>(columns);
    const auto* row = static_cast<const unsigned char*>(view.data);
    for (std::uint64_t i = 0; i < view.count; ++i, row += stride)
        for (int k = 0; k < columns; ++k)
            *out++ = static_cast<double>(reinterpret_cast<const Scalar*>(row)[k]);
}

void read_any(const mien_array_view& view, int columns, const char* name, double* out) {
    if (view.dtype == MIEN_DTYPE_F32)
        read_rows<float>(view, columns, out);
    else if (view.dtype == MIEN_DTYPE_F64)
        read_rows<double>(view, columns, out);
    else
        fail(Status::invalid_argument, "%s.dtype is %d, must be MIEN_DTYPE_F32 or MIEN_DTYPE_F64",
             name, view.dtype);
}

}  // namespace

const char* checked_text(const char* text, const char* parameter) {
    if (text == nullptr) fail(Status::invalid_argument, "%s is null", parameter);
    return text;
}

const mien_array_view& checked_view(const mien_array_view* view, const char* name) {
    if (view == nullptr) fail(Status::invalid_argument, "%s is null", name);
    if (reinterpret_cast<std::uintptr_t>(view) % alignof(mien_array_view) != 0)
        fail(Status::invalid_argument, "%s, the view itself, is misaligned", name);
    return *view;
}

void check_view(const mien_array_view& view, int columns, const char* name) {
    const std::size_t size = view.dtype == MIEN_DTYPE_F64 ? 8 : view.dtype == MIEN_DTYPE_U8 ? 1 : 4;
    if (view.dtype < MIEN_DTYPE_F32 || view.dtype > MIEN_DTYPE_U8)
        fail(Status::invalid_argument, "%s.dtype is %d, which is unknown", name, view.dtype);
    if (view.reserved != 0) fail(Status::unsupported_option, "%s.reserved is not zero", name);
    if (view.count == 0) return;
    if (view.data == nullptr) fail(Status::invalid_argument, "%s.data is null", name);
    const std::uint64_t row = size * static_cast<std::uint64_t>(columns);
    const std::uint64_t stride = view.stride_bytes != 0 ? view.stride_bytes : row;
    if (reinterpret_cast<std::uintptr_t>(view.data) % size != 0 || stride % size != 0)
        fail(Status::invalid_argument, "%s is not aligned to its %zu-byte values", name, size);
    if (stride < row)
        fail(Status::invalid_argument, "%s.stride_bytes is %llu, a row has %llu", name,
             static_cast<unsigned long long>(stride), static_cast<unsigned long long>(row));
    if (view.count >
            static_cast<std::uint64_t>(std::numeric_limits<std::ptrdiff_t>::max()) / stride ||
        view.count > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
        fail(Status::invalid_argument, "%s.count is %llu, more than can be addressed", name,
             static_cast<unsigned long long>(view.count));
}

Points read_points(const mien_array_view& view, const char* name) {
    check_view(view, 3, name);
    Points points(static_cast<Index>(view.count), 3);
    read_any(view, 3, name, points.data());
    return points;
}

Vector read_values(const mien_array_view& view, const char* name) {
    check_view(view, 1, name);
    Vector values(static_cast<Index>(view.count));
    read_any(view, 1, name, values.data());
    return values;
}

void check_array(const void* data, std::uint64_t count, std::size_t alignment, std::uint64_t most,
                 const char* name) {
    if (count == 0) return;
    if (count > most)
        fail(Status::invalid_argument, "%s has %llu entries, at most %llu are allowed", name,
             static_cast<unsigned long long>(count), static_cast<unsigned long long>(most));
    if (data == nullptr) fail(Status::invalid_argument, "%s is null, its count is not 0", name);
    if (reinterpret_cast<std::uintptr_t>(data) % alignment != 0)
        fail(Status::invalid_argument, "%s is not aligned to its values", name);
}

std::vector<std::uint32_t> read_vertices(const std::uint32_t* vertices, std::uint64_t count,
                                         Index num_vertices, const char* name) {
    return read_array(vertices, count, static_cast<std::uint64_t>(num_vertices), name);
}

Zone read_zone(const mien_zone& zone, Index num_vertices) {
    Zone result;
    result.name = checked_text(zone.name, "a zone's name");
    char name[96];
    std::snprintf(name, sizeof name, "zone \"%.60s\": vertices", zone.name);
    result.vertices = read_vertices(zone.vertices, zone.vertex_count, num_vertices, name);
    return result;
}

std::vector<Zone> read_zones(const mien_zone* zones, std::uint64_t count, Index num_vertices,
                             const char* name) {
    check_array(zones, count, alignof(mien_zone), kMostNames, name);
    std::vector<Zone> result;
    for (std::uint64_t i = 0; i < count; ++i) result.push_back(read_zone(zones[i], num_vertices));
    return result;
}

bool wants_copy(std::uint64_t rows, const void* dst, std::uint64_t capacity, std::uint64_t* count) {
    store(count, rows);
    if (dst == nullptr && capacity == 0) return false;
    if (dst == nullptr) fail(Status::invalid_argument, "dst is null, capacity is not 0");
    if (capacity < rows)
        fail(Status::buffer_too_small, "capacity is %llu, %llu are needed",
             static_cast<unsigned long long>(capacity), static_cast<unsigned long long>(rows));
    return true;
}

void copy_rows(const void* source, std::uint64_t rows, std::size_t row_bytes, void* dst,
               std::uint64_t capacity, std::uint64_t* count) {
    if (!wants_copy(rows, dst, capacity, count) || rows == 0) return;
    std::memcpy(dst, source, static_cast<std::size_t>(rows) * row_bytes);
}

void copy_doubles(const double* source, std::uint64_t rows, std::uint64_t columns, mien_dtype dtype,
                  void* dst, std::uint64_t capacity, std::uint64_t* count) {
    if (dtype != MIEN_DTYPE_F32 && dtype != MIEN_DTYPE_F64)
        fail(Status::invalid_argument, "dtype is %d, must be MIEN_DTYPE_F32 or MIEN_DTYPE_F64",
             dtype);
    if (!wants_copy(rows, dst, capacity, count)) return;
    const std::uint64_t values = rows * columns;
    if (dtype == MIEN_DTYPE_F64) {
        if (values != 0)
            std::memcpy(dst, source, static_cast<std::size_t>(values) * sizeof(double));
        return;
    }
    auto* out = static_cast<float*>(dst);
    check_output(out, "dst");
    for (std::uint64_t i = 0; i < values; ++i) out[i] = static_cast<float>(source[i]);
}

void copy_text(const char* source, std::size_t length, char* dst, std::uint64_t capacity,
               std::uint64_t* count) {
    if (!wants_copy(length + 1, dst, capacity, count)) return;
    std::memcpy(dst, source, length);
    dst[length] = '\0';
}

}  // namespace mien::abi
