// Model files that the host holds in memory.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "base/error.hpp"
#include "base/safetensors.hpp"
#include "base/types.hpp"

namespace mien::abi {

/// A checked copy of such a file; what is read from it borrows the bytes.
struct MemoryFile {
    std::shared_ptr<const void> bytes;
    SafetensorsFile file;
};

inline MemoryFile copy_memory_file(const void* data, std::uint64_t size, const Context& context) {
    if (data == nullptr) fail(Status::invalid_argument, "data is null");
    if (size > static_cast<std::uint64_t>(std::numeric_limits<std::ptrdiff_t>::max()))
        fail(Status::invalid_argument, "size is %llu, more than can be addressed",
             static_cast<unsigned long long>(size));
    const auto length = static_cast<std::size_t>(size);
    // Only the header is read at first: it tells how long the file is, so that a wrong size is
    // found before the rest is followed.
    SafetensorsReadOptions header;
    header.verify_hash = header.verify_finite = false;
    SafetensorsFile::from_memory(data, length, header, context);
    context.require_memory(length, "a model from memory");
    // Counted towards the budget while it lives, and aligned as a mapped file is.
    void* const block = Eigen::internal::handmade_aligned_malloc(length, 64);
    if (block == nullptr) throw std::bad_alloc();
    const std::shared_ptr<void> bytes(block, Eigen::internal::handmade_aligned_free);
    std::memcpy(bytes.get(), data, length);
    return {bytes, SafetensorsFile::from_memory(bytes.get(), length, {}, context)};
}

/// A model read from such a file, with the bytes among what keeps its modes alive.
template <typename Model>
std::shared_ptr<const Model> keep_memory_file(const MemoryFile& from, const Model& read) {
    auto model = std::make_shared<Model>(read);
    using Owners = std::pair<std::shared_ptr<const void>, std::shared_ptr<const void>>;
    model->storage = std::make_shared<Owners>(from.bytes, std::move(model->storage));
    return model;
}

}  // namespace mien::abi
