// A tie to another visit (texture_tie.hpp) as a fit's record keeps it: one tensor of numbers and
// one of each field. Records without a tie, and those of before ties were kept, hold none of them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/safetensors.hpp"
#include "registration/texture_tie.hpp"

namespace mien {

std::vector<double> tie_numbers(const TextureTie& tie);

/// Adds what a record keeps; `numbers`: tie_numbers(), borrowed as the tie's fields are.
void add_tie(const TextureTie& tie, const std::vector<double>& numbers,
             std::vector<TensorToWrite>& tensors, std::map<std::string, std::string>& metadata);

/// Null where the file holds no tie; without `places`, which are the record's mesh. Throws
/// Status::corrupt for values that no tie has, naming the tensor; errors of SafetensorsFile.
std::shared_ptr<const TextureTie> read_tie(const SafetensorsFile& file, Index num_vertices);

}  // namespace mien
