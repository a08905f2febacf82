// safetensors files: 8-byte little-endian header length, JSON header, raw little-endian tensors.
// Format 2: __metadata__.digest is the SHA-256 of the whole file in which the digest's own 64
// characters are zeros ('0'), so names, zones and settings are covered as well as the tensors. In
// format 1, __metadata__.sha256 (where present) covers the tensors' bytes alone.
// The reader treats a file as hostile: header length, depth, counts, offsets, overlaps, holes,
// shape products and dtypes are checked before a byte of data is touched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"

namespace mien {

/// What the library writes; it reads this and every earlier major version.
constexpr int kFormatMajor = 2;

/// The name under which a model's info carries SafetensorsFile::warning().
constexpr const char* kFileWarning = "file_warning";

enum class DType : std::int32_t { f32 = 1, f64 = 2, i32 = 3, u32 = 4, u8 = 5, i64 = 6 };
std::size_t dtype_bytes(DType dtype);

/// One tensor, borrowed: valid while the SafetensorsFile (or its storage()) lives.
struct TensorView {
    DType dtype = DType::f32;
    std::vector<std::uint64_t> shape;
    const void* data = nullptr;  ///< aligned for its dtype
    std::uint64_t count = 0;     ///< product of shape
};

struct SafetensorsReadOptions {
    bool verify_hash = true;  ///< compare the file with its digest; a missing one is an error from
                              ///< format 2 on, whether or not it is compared
    bool verify_finite = true;     ///< every float tensor holds finite values only
    bool give_pages_back = false;  ///< the bytes are of map_file(): those that are hashed need not
                                   ///< stay in the process's memory
};

/// A file mapped read-only, or a copy-free view of memory that the caller keeps alive.
class SafetensorsFile {
  public:
    static SafetensorsFile open(const std::string& path, const SafetensorsReadOptions& options,
                                const Context& context);
    static SafetensorsFile from_memory(const void* data, std::size_t size,
                                       const SafetensorsReadOptions& options,
                                       const Context& context);

    const std::map<std::string, std::string>& metadata() const { return metadata_; }
    /// Metadata entry, or throws Status::bad_format naming the key.
    const std::string& metadata(const std::string& key) const;
    const std::map<std::string, TensorView>& tensors() const { return tensors_; }
    bool has(const std::string& name) const { return tensors_.count(name) != 0; }
    /// Throws Status::bad_format, naming the tensor, when it is missing, of another dtype, or of
    /// another rank. A negative entry of `shape` matches any size.
    const TensorView& tensor(const std::string& name, DType dtype,
                             const std::vector<std::int64_t>& shape) const;
    /// What a reader ought to know about the file, or empty: that its names and settings are not
    /// covered by a digest (format 1).
    const std::string& warning() const { return warning_; }
    /// Keeps the mapping alive beyond this object.
    std::shared_ptr<const void> storage() const { return storage_; }

    /// Checks __metadata__.kind and format major: Status::wrong_kind says what the file is instead,
    /// Status::unsupported_version which versions are known.
    void require_kind(const char* kind, int known_major = kFormatMajor) const;

  private:
    std::map<std::string, std::string> metadata_;
    std::map<std::string, TensorView> tensors_;
    std::shared_ptr<const void> storage_;
    std::string source_ = "the file";  ///< its path, for messages
    std::string warning_;
};

/// A tensor to be written, borrowed until write() returns.
struct TensorToWrite {
    std::string name;
    DType dtype = DType::f32;
    std::vector<std::uint64_t> shape;
    const void* data = nullptr;
};

/// Writes atomically, data on a 64-byte boundary, tensors in the order given (each 8-byte aligned
/// by ordering wide dtypes first where needed), and adds "format", "digest" and "creator" (library
/// version) to the metadata. Callers give "kind" and "units".
void write_safetensors(const std::string& path, const std::vector<TensorToWrite>& tensors,
                       std::map<std::string, std::string> metadata, const Context& context);

}  // namespace mien
