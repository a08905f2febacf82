// The data part of a PLY file, value by value or in spans; every read is held against the end of
// the file. BinaryValues and TextValues offer the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "mesh/ply_header.hpp"

namespace mien::formats {

/// Calls `use` with a value of the C++ type that `type` names.
template <typename Use>
auto with_ply_type(PlyType type, Use&& use) {
    switch (type) {
        case PlyType::i8:
            return use(std::int8_t());
        case PlyType::u8:
            return use(std::uint8_t());
        case PlyType::i16:
            return use(std::int16_t());
        case PlyType::u16:
            return use(std::uint16_t());
        case PlyType::i32:
            return use(std::int32_t());
        case PlyType::u32:
            return use(std::uint32_t());
        case PlyType::f32:
            return use(float());
        case PlyType::f64:
            break;
    }
    return use(double());
}

/// The value at `raw`, in this machine's byte order or, `swapped`, in the other one.
template <typename T>
inline T load_ply(const char* raw, bool swapped) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, raw, sizeof(T));
    if (swapped) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

[[noreturn]] inline void fail_ply_index(double value, std::uint64_t element) {
    fail_at(Status::bad_format, static_cast<std::int64_t>(element), "face %llu: %g is no index",
            static_cast<unsigned long long>(element), value);
}

/// A vertex number; -1, in strips the end of one, becomes kStripEnd where it may stand.
constexpr std::uint32_t kStripEnd = 0xffffffffu;
template <typename T>
inline std::uint32_t ply_index(T value, bool strips, std::uint64_t element) {
    if constexpr (std::is_floating_point_v<T>) {
        if (value >= 0 && static_cast<double>(value) < 4294967295.0 && value == std::floor(value))
            return static_cast<std::uint32_t>(value);
        if (strips && value == -1) return kStripEnd;
    } else if constexpr (std::is_signed_v<T>) {
        if (value >= 0) return static_cast<std::uint32_t>(value);
        if (strips && value == -1) return kStripEnd;
    } else {
        // 2^32 - 1 itself is the mark for "none".
        if (static_cast<std::uint32_t>(value) != kStripEnd) return value;
    }
    fail_ply_index(static_cast<double>(value), element);
}

[[noreturn]] inline void fail_ply_length(double length, const char* what, std::uint64_t element) {
    fail_at(Status::bad_format, static_cast<std::int64_t>(element),
            "%s %llu has a list of %g values, more than the file holds", what,
            static_cast<unsigned long long>(element), length);
}

class BinaryValues {
  public:
    static constexpr bool kBinary = true;
    BinaryValues(const char* begin, const char* end, bool swapped)
        : begin_(begin), at_(begin), end_(end), swapped_(swapped) {}

    double next(PlyType type) {
        const char* raw = take(ply_type_bytes(type));
        return with_ply_type(type, [&](auto kind) {
            return static_cast<double>(load_ply<decltype(kind)>(raw, swapped_));
        });
    }
    void skip(PlyType type, std::uint64_t count) {
        const std::size_t bytes = ply_type_bytes(type);
        if (count > static_cast<std::size_t>(end_ - at_) / bytes) fail_truncated();
        at_ += static_cast<std::size_t>(count) * bytes;
    }
    /// A list's length, held against what the file can still contain.
    std::size_t length(const PlyProperty& property, const char* what, std::uint64_t element) {
        const char* raw = take(ply_type_bytes(property.count_type));
        const std::int64_t count = with_ply_type(property.count_type, [&](auto kind) {
            return static_cast<std::int64_t>(load_ply<decltype(kind)>(raw, swapped_));
        });
        if (count < 0 || static_cast<std::uint64_t>(count) >
                             static_cast<std::uint64_t>(end_ - at_) / ply_type_bytes(property.type))
            fail_ply_length(static_cast<double>(count), what, element);
        return static_cast<std::size_t>(count);
    }
    /// `count` vertex numbers, which length() has allowed.
    void indices(PlyType type, std::size_t count, bool strips, std::uint64_t element,
                 std::vector<std::uint32_t>& out) {
        const char* raw = take(count * ply_type_bytes(type));
        out.resize(count);
        std::uint32_t* to = out.data();
        with_ply_type(type, [&](auto kind) {
            using T = decltype(kind);
            for (std::size_t k = 0; k < count; ++k)
                to[k] = ply_index(load_ply<T>(raw + k * sizeof(T), swapped_), strips, element);
        });
    }
    static std::uint64_t least_bytes(PlyType type) { return ply_type_bytes(type); }
    /// How many values of this type may still follow.
    std::uint64_t capacity(PlyType type) const {
        return static_cast<std::uint64_t>(end_ - at_) / ply_type_bytes(type);
    }
    /// The next bytes as they are.
    const char* take(std::size_t bytes) {
        if (bytes > static_cast<std::size_t>(end_ - at_)) fail_truncated();
        const char* raw = at_;
        at_ += bytes;
        return raw;
    }
    bool swapped() const { return swapped_; }
    /// Bytes after the last value that are no line end or padding.
    std::size_t left_over() const {
        const auto padding = [](char c) { return c == '\0' || c == '\n' || c == '\r' || c == ' '; };
        return std::all_of(at_, end_, padding) ? 0 : static_cast<std::size_t>(end_ - at_);
    }
    /// Faces that are a list of three 4-byte numbers and nothing else, as most files have them:
    /// copied to `out`, 3 x count. False, and nothing taken, when one of them is anything else.
    bool plain_triangles(const PlyProperty& list, std::size_t count, std::uint32_t* out) {
        constexpr std::size_t kFaceBytes = 13;
        const bool four_bytes = list.type == PlyType::i32 || list.type == PlyType::u32;
        if (swapped_ || !four_bytes || ply_type_bytes(list.count_type) != 1 ||
            count > static_cast<std::size_t>(end_ - at_) / kFaceBytes)
            return false;
        std::uint32_t sign = 0;
        for (std::size_t t = 0; t < count; ++t) {
            const char* face = at_ + kFaceBytes * t;
            if (*face != 3) return false;
            std::uint32_t* corners = out + 3 * t;
            std::memcpy(corners, face + 1, 12);
            sign |= corners[0] | corners[1] | corners[2];
        }
        // Numbers below zero are for the general path to name.
        if (sign >> 31 != 0) return false;
        at_ += kFaceBytes * count;
        return true;
    }

  private:
    [[noreturn]] void fail_truncated() const {
        fail_at(Status::bad_format, at_ - begin_, "the file ends within its data, after %lld bytes",
                static_cast<long long>(at_ - begin_));
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    bool swapped_;
};

class TextValues {
  public:
    static constexpr bool kBinary = false;
    explicit TextValues(const TextCursor& text) : text_(text) {}

    double next(PlyType) {
        double value = 0.0;
        text_.skip_space();
        if (!text_.number(value))
            fail_at(Status::bad_format, text_.line(),
                    text_.at_end() ? "the file ends within its data, at line %lld"
                                   : "line %lld: not a number",
                    static_cast<long long>(text_.line()));
        return value;
    }
    void skip(PlyType type, std::uint64_t count) {
        for (; count != 0; --count) next(type);
    }
    std::size_t length(const PlyProperty& property, const char* what, std::uint64_t element) {
        const double count = next(property.count_type);
        if (!(count >= 0.0) || count != std::floor(count))
            fail_at(Status::bad_format, text_.line(),
                    "line %lld: %s %llu begins with %g where the length of its list should stand; "
                    "do the lines before it hold more numbers than the header names?",
                    static_cast<long long>(text_.line()), what,
                    static_cast<unsigned long long>(element), count);
        if (count > static_cast<double>(capacity(property.type)))
            fail_ply_length(count, what, element);
        return static_cast<std::size_t>(count);
    }
    void indices(PlyType type, std::size_t count, bool strips, std::uint64_t element,
                 std::vector<std::uint32_t>& out) {
        out.clear();
        for (std::size_t k = 0; k < count; ++k) {
            std::int64_t value = 0;
            text_.skip_space();
            TextCursor here = text_;
            const bool whole =
                here.integer(value) && static_cast<unsigned char>(here.peek()) <= ' ';
            if (whole && value >= 0 && value < 4294967295LL) {
                text_ = here;
                out.push_back(static_cast<std::uint32_t>(value));
            } else {
                out.push_back(ply_index(next(type), strips, element));
            }
        }
    }
    bool plain_triangles(const PlyProperty&, std::size_t, std::uint32_t*) { return false; }
    static std::uint64_t least_bytes(PlyType) { return 1; }
    std::uint64_t capacity(PlyType) const { return text_.remaining() / 2 + 1; }
    /// Bytes after the last value that begin with one more.
    std::size_t left_over() const {
        TextCursor rest = text_;
        double value = 0.0;
        rest.skip_space();
        const std::size_t bytes = rest.remaining();
        return rest.number(value) ? bytes : 0;
    }

  private:
    TextCursor text_;
};

}  // namespace mien::formats
