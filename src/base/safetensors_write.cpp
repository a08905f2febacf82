// Writing: one header, the tensors without holes, the digest of both in the header.
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "base/safetensors.hpp"
#include "base/sha256.hpp"

namespace mien {
namespace {

#if !defined(MIEN_VERSION)
#define MIEN_VERSION "0"
#endif

constexpr std::uint64_t kDataAlignment = 64;

const char* written_dtype(DType dtype) {
    switch (dtype) {
        case DType::f32:
            return "F32";
        case DType::f64:
            return "F64";
        case DType::i32:
            return "I32";
        case DType::u32:
            return "U32";
        case DType::u8:
            return "U8";
        case DType::i64:
            return "I64";
    }
    fail(Status::invalid_argument, "unknown dtype %d", static_cast<int>(dtype));
}

std::uint64_t tensor_bytes(const TensorToWrite& tensor) {
    std::uint64_t bytes = dtype_bytes(tensor.dtype);
    for (std::uint64_t extent : tensor.shape) {
        if (extent != 0 && bytes > std::numeric_limits<std::uint64_t>::max() / 2 / extent)
            fail(Status::invalid_argument, "tensor '%s' is too large",
                 shown_name(tensor.name).c_str());
        bytes *= extent;
    }
    if (bytes != 0 && tensor.data == nullptr)
        fail(Status::invalid_argument, "tensor '%s' has no data", shown_name(tensor.name).c_str());
    return bytes;
}

/// The order given, unless a tensor would then start out of line for its dtype: then wide dtypes
/// first, which lines up every one because each size is a multiple of its own width.
std::vector<std::size_t> choose_order(const std::vector<TensorToWrite>& tensors,
                                      const std::vector<std::uint64_t>& bytes) {
    std::vector<std::size_t> order(tensors.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::uint64_t offset = 0;
    bool aligned = true;
    for (std::size_t i : order) {
        aligned = aligned && offset % dtype_bytes(tensors[i].dtype) == 0;
        offset += bytes[i];
    }
    if (!aligned)
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return dtype_bytes(tensors[a].dtype) > dtype_bytes(tensors[b].dtype);
        });
    return order;
}

std::string make_header(const std::vector<TensorToWrite>& tensors,
                        const std::vector<std::uint64_t>& bytes,
                        const std::vector<std::size_t>& order,
                        const std::map<std::string, std::string>& metadata) {
    std::string json = "{\"__metadata__\":{";
    bool first = true;
    for (const auto& [key, value] : metadata) {
        if (!first) json += ',';
        first = false;
        append_json_string(json, key);
        json += ':';
        append_json_string(json, value);
    }
    json += '}';
    std::uint64_t offset = 0;
    for (std::size_t i : order) {
        json += ',';
        append_json_string(json, tensors[i].name);
        json += std::string(":{\"dtype\":\"") + written_dtype(tensors[i].dtype) + "\",\"shape\":[";
        for (std::size_t k = 0; k < tensors[i].shape.size(); ++k)
            json += (k == 0 ? "" : ",") + std::to_string(tensors[i].shape[k]);
        json += "],\"data_offsets\":[" + std::to_string(offset) + ',';
        offset += bytes[i];
        json += std::to_string(offset) + "]}";
    }
    json += '}';
    while ((8 + json.size()) % kDataAlignment != 0) json += ' ';
    return json;
}

}  // namespace

void write_safetensors(const std::string& path, const std::vector<TensorToWrite>& tensors,
                       std::map<std::string, std::string> metadata, const Context& context) {
    std::set<std::string> names;
    std::vector<std::uint64_t> bytes;
    std::uint64_t total = 0;
    for (const TensorToWrite& tensor : tensors) {
        if (tensor.name == "__metadata__" || !names.insert(tensor.name).second)
            fail(Status::invalid_argument, "the tensor name '%s' is taken",
                 shown_name(tensor.name).c_str());
        bytes.push_back(tensor_bytes(tensor));
        total += bytes.back();
    }
    const std::vector<std::size_t> order = choose_order(tensors, bytes);

    constexpr std::uint64_t kChunk = std::uint64_t(1) << 20;
    auto for_all_bytes = [&](double from, auto&& take) {
        std::uint64_t done = 0;
        for (std::size_t i : order)
            for (std::uint64_t begin = 0; begin < bytes[i]; begin += kChunk) {
                const std::uint64_t size = std::min(kChunk, bytes[i] - begin);
                context.progress(Stage::writing, from + 0.5 * static_cast<double>(done) /
                                                            static_cast<double>(total));
                take(static_cast<const char*>(tensors[i].data) + begin,
                     static_cast<std::size_t>(size));
                done += size;
            }
    };
    metadata["format"] = std::to_string(kFormatMajor) + ".0";
    metadata["creator"] = "mien " MIEN_VERSION;
    const std::string unknown(Sha256::kDigits, '0');
    metadata["digest"] = unknown;
    std::string header = make_header(tensors, bytes, order, metadata);
    const std::uint64_t header_size = header.size();
    Sha256 hash;
    hash.update(&header_size, 8);
    hash.update(header.data(), header.size());
    for_all_bytes(0.0, [&](const char* data, std::size_t size) { hash.update(data, size); });
    // Another value may read the same, so the digest's place is found by its key; no key or value
    // can look like this, because their quotation marks are escaped.
    const std::string key = "\"digest\":\"";
    header.replace(header.find(key + unknown) + key.size(), Sha256::kDigits, hash.hex_digest());
    AtomicFile file(path);
    file.write(&header_size, 8);
    file.write(header);
    for_all_bytes(0.5, [&](const char* data, std::size_t size) { file.write(data, size); });
    file.commit();
    context.progress(Stage::writing, 1.0);
}

}  // namespace mien
