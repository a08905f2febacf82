#include "tensor_file.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "commands.hpp"

namespace mien::cli {
namespace {

// safetensors: u64 little-endian length of a JSON header, the header, the data it points into.
constexpr std::size_t kLengthBytes = 8, kMostHeader = std::size_t{1} << 20;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw std::runtime_error(path + ": is no safetensors file of numbers (" + why + ")");
}

std::uint64_t product_of(const std::vector<std::uint64_t>& shape, const std::string& path) {
    std::uint64_t count = 1;
    for (const std::uint64_t extent : shape) {
        if (extent != 0 && count > (std::uint64_t{1} << 40) / extent) refuse(path, "too large");
        count *= extent;
    }
    return count;
}

template <typename T>
void copy_numbers(const char* from, std::vector<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
        T value;
        std::memcpy(&value, from + i * sizeof value, sizeof value);
        to[i] = static_cast<double>(value);
    }
}

Tensor read_tensor(const std::string& path, const std::string& name, const nlohmann::json& entry,
                   const char* data, std::uint64_t size) {
    Tensor tensor;
    tensor.shape = entry.at("shape").get<std::vector<std::uint64_t>>();
    const auto type = entry.at("dtype").get<std::string>();
    const auto offsets = entry.at("data_offsets").get<std::vector<std::uint64_t>>();
    if (type != "F64" && type != "F32")
        throw std::runtime_error(path + ": tensor '" + name + "' is " + type +
                                 "; F64 or F32 are needed");
    const std::uint64_t count = product_of(tensor.shape, path);
    const std::uint64_t bytes = count * (type == "F64" ? 8 : 4);
    if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] > size ||
        offsets[1] - offsets[0] != bytes)
        refuse(path, "tensor '" + name + "' does not lie in the file");
    tensor.values.resize(static_cast<std::size_t>(count));
    if (type == "F64")
        copy_numbers<double>(data + offsets[0], tensor.values);
    else
        copy_numbers<float>(data + offsets[0], tensor.values);
    return tensor;
}

}  // namespace

void write_tensors(const std::string& path, const std::map<std::string, Tensor>& tensors,
                   const std::map<std::string, std::string>& metadata) {
    nlohmann::json header;
    header["__metadata__"] = metadata;
    std::string data;
    for (const auto& [name, tensor] : tensors) {
        const std::size_t begin = data.size(), bytes = tensor.values.size() * sizeof(double);
        data.append(reinterpret_cast<const char*>(tensor.values.data()), bytes);
        header[name] = {
            {"dtype", "F64"}, {"shape", tensor.shape}, {"data_offsets", {begin, begin + bytes}}};
    }
    std::string text = header.dump();
    text.append((8 - text.size() % 8) % 8, ' ');  // tensors begin at whole doubles
    std::string file(kLengthBytes, '\0');
    for (std::size_t i = 0; i < kLengthBytes; ++i)
        file[i] = static_cast<char>(std::uint64_t{text.size()} >> (8 * i) & 0xFF);
    write_file(path, file + text + data);
}

std::map<std::string, Tensor> read_tensors(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path + ": cannot be opened for reading");
    const std::string file((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (file.size() < kLengthBytes) refuse(path, "too short");
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < kLengthBytes; ++i)
        length |= std::uint64_t{static_cast<unsigned char>(file[i])} << (8 * i);
    if (length > kMostHeader || length > file.size() - kLengthBytes)
        refuse(path, "its header does not lie in the file");
    const char* data = file.data() + kLengthBytes + length;
    const std::uint64_t size = file.size() - kLengthBytes - length;
    std::map<std::string, Tensor> tensors;
    try {
        const nlohmann::json header = nlohmann::json::parse(file.substr(kLengthBytes, length));
        if (!header.is_object()) refuse(path, "its header is no object");
        for (const auto& [name, entry] : header.items())
            if (name != "__metadata__") tensors[name] = read_tensor(path, name, entry, data, size);
    } catch (const nlohmann::json::exception& failure) {
        refuse(path, failure.what());
    }
    return tensors;
}

Tensor take_matrix(const std::map<std::string, Tensor>& tensors, const std::string& path,
                   const std::string& name, std::uint64_t columns) {
    const auto found = tensors.find(name);
    if (found == tensors.end()) throw std::runtime_error(path + ": has no tensor '" + name + "'");
    const std::vector<std::uint64_t>& shape = found->second.shape;
    if (shape.size() != 2 || shape[1] != columns)
        throw std::runtime_error(path + ": tensor '" + name + "' is not [rows, " +
                                 std::to_string(columns) + "]");
    return found->second;
}

}  // namespace mien::cli
