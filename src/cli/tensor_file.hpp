// Plain safetensors files of numbers, which NumPy and other programs read: features, coefficients.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mien::cli {

struct Tensor {
    std::vector<std::uint64_t> shape;  ///< row-major
    std::vector<double> values;
};

/// Float64 tensors by name, and what they are, as text. Throws std::runtime_error naming the file.
void write_tensors(const std::string& path, const std::map<std::string, Tensor>& tensors,
                   const std::map<std::string, std::string>& metadata);
/// Tensors of F64 or F32; others are an error that names the tensor, as is a file cut short.
std::map<std::string, Tensor> read_tensors(const std::string& path);
/// One of them, with so many columns; any number of rows.
Tensor take_matrix(const std::map<std::string, Tensor>& tensors, const std::string& path,
                   const std::string& name, std::uint64_t columns);

}  // namespace mien::cli
