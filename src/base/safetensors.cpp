// Reading: the header is checked whole before a byte of data is looked at, then the digest, then
// the values. Tensors that the file placed out of line for their type are copied; others are
// borrowed.
#include "base/safetensors.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "base/memory_budget.hpp"
#include "base/parallel.hpp"
#include "base/safetensors_header.hpp"
#include "base/sha256.hpp"

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "tensors are borrowed from the file, which is little-endian"
#endif

namespace mien {
namespace {

struct KnownType {
    const char* name;
    std::size_t bytes;
    std::int32_t dtype;  ///< 0: of known size, but not read here
};

constexpr KnownType kTypes[] = {
    {"F32", 4, 1}, {"F64", 8, 2},  {"I32", 4, 3},  {"U32", 4, 4},     {"U8", 1, 5},
    {"I64", 8, 6}, {"U64", 8, 0},  {"I16", 2, 0},  {"U16", 2, 0},     {"F16", 2, 0},
    {"I8", 1, 0},  {"BOOL", 1, 0}, {"BF16", 2, 0}, {"F8_E4M3", 1, 0}, {"F8_E5M2", 1, 0},
};

const char* dtype_name(DType dtype) {
    for (const KnownType& type : kTypes)
        if (type.dtype == static_cast<std::int32_t>(dtype)) return type.name;
    return "?";
}

/// False when the product does not fit.
bool multiply_checked(std::uint64_t a, std::uint64_t b, std::uint64_t& product) {
    if (b != 0 && a > std::numeric_limits<std::uint64_t>::max() / b) return false;
    product = a * b;
    return true;
}

/// First value that is not finite, or `count`. A float is not finite when its exponent is all ones.
template <typename Bits>
std::size_t first_not_finite(const Bits* values, std::size_t count, Bits exponent) {
    constexpr std::size_t kBlock = 4096;
    for (std::size_t begin = 0; begin < count; begin += kBlock) {
        const std::size_t end = std::min(count, begin + kBlock);
        Bits found = 0;
        for (std::size_t i = begin; i < end; ++i)
            found |= static_cast<Bits>((values[i] & exponent) == exponent);
        if (found == 0) continue;
        for (std::size_t i = begin; i < end; ++i)
            if ((values[i] & exponent) == exponent) return i;
    }
    return count;
}

void check_finite(const std::string& name, const TensorView& view, const Context& context) {
    if (view.dtype != DType::f32 && view.dtype != DType::f64) return;
    const std::size_t count = static_cast<std::size_t>(view.count);
    constexpr std::size_t kChunk = std::size_t(1) << 19;
    std::vector<std::size_t> first((count + kChunk - 1) / kChunk);
    parallel_for(context, count, kChunk, [&](std::size_t begin, std::size_t end) {
        std::size_t found;
        if (view.dtype == DType::f32)
            found = first_not_finite(static_cast<const std::uint32_t*>(view.data) + begin,
                                     end - begin, std::uint32_t(0x7f800000));
        else
            found = first_not_finite(static_cast<const std::uint64_t*>(view.data) + begin,
                                     end - begin, std::uint64_t(0x7ff0000000000000));
        first[begin / kChunk] = found == end - begin ? count : begin + found;
    });
    for (std::size_t index : first)
        if (index != count)
            fail_at(Status::corrupt, static_cast<std::int64_t>(index),
                    "tensor '%s' holds a value that is not finite at %zu; write the file anew",
                    shown_name(name).c_str(), index);
}

void update_hash(Sha256& hash, const char* data, std::size_t size, bool give_pages_back,
                 const Context& context) {
    constexpr std::size_t kChunk = std::size_t(1) << 20;
    for (std::size_t begin = 0; begin < size; begin += kChunk) {
        context.check_cancelled();
        const std::size_t length = std::min(kChunk, size - begin);
        hash.update(data + begin, length);
        if (give_pages_back) release_pages(data + begin, length);
    }
}

/// Format 2: the whole file, the digest's own characters as zeros.
void check_digest(const std::string& expected, const char* bytes, std::size_t size,
                  std::size_t header_size, bool give_pages_back, const Context& context) {
    const std::string header(bytes + 8, header_size);
    // The writer's text first: another value might hold the same characters.
    std::size_t place = header.find("\"digest\":\"" + expected + '"');
    place = place == std::string::npos ? header.find(expected) : place + 10;
    if (expected.size() != Sha256::kDigits || place == std::string::npos)
        fail(Status::corrupt, "the file's digest is not %zu plain characters; get or write it anew",
             Sha256::kDigits);
    const std::string zeros(Sha256::kDigits, '0');
    const char* const digest = bytes + 8 + place;
    Sha256 hash;
    update_hash(hash, bytes, static_cast<std::size_t>(digest - bytes), false, context);
    update_hash(hash, zeros.data(), zeros.size(), false, context);
    update_hash(hash, digest + Sha256::kDigits,
                static_cast<std::size_t>(bytes + size - digest) - Sha256::kDigits, give_pages_back,
                context);
    if (hash.hex_digest() != expected)
        fail(Status::corrupt,
             "the file does not match its digest: it was damaged or edited; get or write it anew");
}

/// Format 1: the tensors' bytes.
void check_tensor_hash(const std::string& expected, const char* data, std::size_t size,
                       bool give_pages_back, const Context& context) {
    Sha256 hash;
    update_hash(hash, data, size, give_pages_back, context);
    if (hash.hex_digest() != expected)
        fail(Status::corrupt,
             "the tensors do not match the file's SHA-256: the file was damaged or edited; get or "
             "write it anew");
}

/// The major version that the metadata tell; 0 where they tell none.
int format_major(const std::map<std::string, std::string>& metadata) {
    const auto format = metadata.find("format");
    if (format == metadata.end()) return 0;
    int major = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(format->second.size(), 6); ++k) {
        if (format->second[k] < '0' || format->second[k] > '9') break;
        major = major * 10 + (format->second[k] - '0');
    }
    return major;
}

/// Checks one entry against the type table, its shape and the data's size.
const KnownType& check_entry(const SafetensorsEntry& entry, std::uint64_t data_size,
                             std::uint64_t& count) {
    const std::string name = shown_name(entry.name);
    const KnownType* known = nullptr;
    for (const KnownType& type : kTypes)
        if (entry.dtype == type.name) known = &type;
    if (known == nullptr)
        fail(Status::bad_format, "tensor '%s' has the unknown dtype '%s'", name.c_str(),
             shown_name(entry.dtype).c_str());
    count = 1;
    std::uint64_t bytes = 0;
    bool fits = true;
    // Zeros first would hide an overflow of the other extents, so a plain left-to-right product.
    for (std::uint64_t extent : entry.shape) fits = fits && multiply_checked(count, extent, count);
    fits = fits && multiply_checked(count, known->bytes, bytes);
    if (!fits)
        fail(Status::bad_format, "tensor '%s': the product of its shape is too large",
             name.c_str());
    if (entry.begin > entry.end || entry.end > data_size)
        fail(Status::bad_format, "tensor '%s' lies at bytes %llu to %llu of %llu", name.c_str(),
             static_cast<unsigned long long>(entry.begin),
             static_cast<unsigned long long>(entry.end),
             static_cast<unsigned long long>(data_size));
    if (entry.end - entry.begin != bytes)
        fail(Status::bad_format, "tensor '%s': its shape needs %llu bytes, its offsets span %llu",
             name.c_str(), static_cast<unsigned long long>(bytes),
             static_cast<unsigned long long>(entry.end - entry.begin));
    return *known;
}

/// Sorted by place, the tensors must cover the data without overlap or hole.
void check_cover(std::vector<SafetensorsEntry>& entries, std::uint64_t data_size) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const SafetensorsEntry& a, const SafetensorsEntry& b) {
                         return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
                     });
    std::uint64_t reached = 0;
    for (const SafetensorsEntry& entry : entries) {
        if (entry.begin != reached)
            fail(Status::bad_format, "tensor '%s' %s at byte %llu", shown_name(entry.name).c_str(),
                 entry.begin < reached ? "overlaps another" : "leaves a hole before it",
                 static_cast<unsigned long long>(entry.begin));
        reached = entry.end;
    }
    if (reached != data_size)
        fail(Status::bad_format, "the tensors end at byte %llu of %llu",
             static_cast<unsigned long long>(reached), static_cast<unsigned long long>(data_size));
}

struct Parsed {
    std::map<std::string, std::string> metadata;
    std::map<std::string, TensorView> tensors;
    std::vector<std::shared_ptr<const void>> copies;
    std::string warning;
};

/// Compares the file with its digest, where it has one and as far as the options say.
void verify(const char* bytes, std::size_t size, std::size_t header_size,
            const SafetensorsReadOptions& options, const Context& context, Parsed& parsed) {
    const auto digest = parsed.metadata.find("digest");
    if (digest != parsed.metadata.end()) {
        if (options.verify_hash)
            check_digest(digest->second, bytes, size, header_size, options.give_pages_back,
                         context);
        return;
    }
    if (format_major(parsed.metadata) >= 2)
        fail(Status::corrupt,
             "the file lacks the digest that its format has: it was damaged or edited; get or "
             "write it anew");
    parsed.warning =
        "its names and settings are not covered by a digest (format 1): damage to them goes "
        "unseen; save it anew";
    const auto hash = parsed.metadata.find("sha256");
    if (options.verify_hash && hash != parsed.metadata.end())
        check_tensor_hash(hash->second, bytes + 8 + header_size, size - 8 - header_size,
                          options.give_pages_back, context);
}

Parsed parse(const char* bytes, std::size_t size, const SafetensorsReadOptions& options,
             const Context& context) {
    if (size < 8)
        fail(Status::bad_format, "not a safetensors file: %zu bytes, at least 8 are needed", size);
    std::uint64_t header_size = 0;
    std::memcpy(&header_size, bytes, 8);
    if (header_size < 2 || header_size > size - 8)
        fail(Status::bad_format,
             "not a safetensors file: its header would take %llu of the %zu bytes there are",
             static_cast<unsigned long long>(header_size), size - 8);
    if (bytes[8] != '{')
        fail(Status::bad_format, "not a safetensors file: its header does not begin with '{'");
    SafetensorsHeader header =
        parse_safetensors_header(bytes + 8, static_cast<std::size_t>(header_size));

    const char* data = bytes + 8 + header_size;
    const std::size_t data_size = size - 8 - static_cast<std::size_t>(header_size);
    check_cover(header.entries, data_size);
    Parsed parsed;
    parsed.metadata = std::move(header.metadata);
    for (const SafetensorsEntry& entry : header.entries) {
        TensorView view;
        const KnownType& type = check_entry(entry, data_size, view.count);
        if (type.dtype == 0) continue;
        view.dtype = static_cast<DType>(type.dtype);
        view.shape = entry.shape;
        view.data = data + entry.begin;
        parsed.tensors.emplace(entry.name, std::move(view));
    }

    verify(bytes, size, static_cast<std::size_t>(header_size), options, context, parsed);
    for (auto& [name, view] : parsed.tensors) {
        const std::size_t width = dtype_bytes(view.dtype);
        if (reinterpret_cast<std::uintptr_t>(view.data) % width != 0) {
            const std::size_t bytes_needed = static_cast<std::size_t>(view.count) * width;
            context.require_memory(bytes_needed, "copying a tensor that its file misaligns");
            const std::shared_ptr<char> copy = counted_block(bytes_needed);
            std::memcpy(copy.get(), view.data, bytes_needed);
            view.data = copy.get();
            parsed.copies.push_back(copy);
        }
        if (options.verify_finite) check_finite(name, view, context);
    }
    return parsed;
}

}  // namespace

std::size_t dtype_bytes(DType dtype) {
    for (const KnownType& type : kTypes)
        if (type.dtype == static_cast<std::int32_t>(dtype)) return type.bytes;
    fail(Status::invalid_argument, "unknown dtype %d", static_cast<int>(dtype));
}

SafetensorsFile SafetensorsFile::open(const std::string& path,
                                      const SafetensorsReadOptions& options,
                                      const Context& context) {
    const FileBytes bytes = context.copy_files ? read_whole_file(path, context) : map_file(path);
    try {
        SafetensorsFile file = from_memory(bytes.data, bytes.size, options, context);
        file.source_ = "'" + shown_path(path) + "'";
        if (!file.warning_.empty() && file.metadata_.count("kind") != 0)
            context.log(LogLevel::warning, "%s: %s", file.source_.c_str(), file.warning_.c_str());
        struct Owners {
            std::shared_ptr<const void> mapping, copies;
        };
        file.storage_ = std::make_shared<Owners>(Owners{bytes.storage, file.storage_});
        return file;
    } catch (const Error& error) {
        if (error.status() == Status::cancelled || error.status() == Status::memory_budget) throw;
        fail_at(error.status(), error.detail_index(), "'%s': %s", shown_path(path).c_str(),
                error.what());
    }
}

SafetensorsFile SafetensorsFile::from_memory(const void* data, std::size_t size,
                                             const SafetensorsReadOptions& options,
                                             const Context& context) {
    if (data == nullptr) size = 0;
    Parsed parsed = parse(static_cast<const char*>(data), size, options, context);
    SafetensorsFile file;
    file.metadata_ = std::move(parsed.metadata);
    file.warning_ = std::move(parsed.warning);
    file.tensors_ = std::move(parsed.tensors);
    file.storage_ =
        std::make_shared<std::vector<std::shared_ptr<const void>>>(std::move(parsed.copies));
    return file;
}

const std::string& SafetensorsFile::metadata(const std::string& key) const {
    const auto entry = metadata_.find(key);
    if (entry == metadata_.end())
        fail(Status::bad_format, "%s: the metadata lack '%s'", source_.c_str(),
             shown_name(key).c_str());
    return entry->second;
}

const TensorView& SafetensorsFile::tensor(const std::string& name, DType dtype,
                                          const std::vector<std::int64_t>& shape) const {
    const auto entry = tensors_.find(name);
    if (entry == tensors_.end())
        fail(Status::bad_format, "%s lacks the tensor '%s'", source_.c_str(),
             shown_name(name).c_str());
    const TensorView& view = entry->second;
    if (view.dtype != dtype)
        fail(Status::bad_format, "%s: tensor '%s' is %s, %s is needed", source_.c_str(),
             shown_name(name).c_str(), dtype_name(view.dtype), dtype_name(dtype));
    if (view.shape.size() != shape.size())
        fail(Status::bad_format, "%s: tensor '%s' has %zu dimensions, %zu are needed",
             source_.c_str(), shown_name(name).c_str(), view.shape.size(), shape.size());
    for (std::size_t k = 0; k < shape.size(); ++k)
        if (shape[k] >= 0 && view.shape[k] != static_cast<std::uint64_t>(shape[k]))
            fail(Status::bad_format, "%s: tensor '%s': extent %zu is %llu, %lld is needed",
                 source_.c_str(), shown_name(name).c_str(), k,
                 static_cast<unsigned long long>(view.shape[k]), static_cast<long long>(shape[k]));
    return view;
}

void SafetensorsFile::require_kind(const char* kind, int known_major) const {
    const auto found = metadata_.find("kind");
    if (found == metadata_.end())
        fail(Status::wrong_kind, "%s does not say what it is ('kind'); a %s is needed",
             source_.c_str(), kind);
    if (found->second != kind)
        fail(Status::wrong_kind, "%s is a '%s'; a %s is needed", source_.c_str(),
             shown_name(found->second).c_str(), kind);
    const std::string& format = metadata("format");
    // "major.minor": digits alone, so that no other reading of the text is possible.
    std::size_t digits = 0;
    while (digits < format.size() && digits < 6 && format[digits] >= '0' && format[digits] <= '9')
        ++digits;
    if (digits == 0 || (digits < format.size() && format[digits] != '.'))
        fail(Status::bad_format, "the format version '%s' is not 'major.minor'",
             shown_name(format).c_str());
    const int major = format_major(metadata_);
    if (major < 1 || major > known_major)
        fail(Status::unsupported_version,
             "the %s has format %s; this version reads 1 to %d: use a newer library", kind,
             shown_name(format).c_str(), known_major);
}

}  // namespace mien
