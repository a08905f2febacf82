// Reports as JSON text, written without a document tree.
#pragma once

#include <string>

#include "expression/neutralize.hpp"
#include "expression/training.hpp"

namespace mien {

std::string training_json(const ExpressionModel& model, const TrainReport& report);
/// Sizes, names, noise, and what the file says of its making.
std::string model_json(const ExpressionModel& model);
std::string neutralization_json(const ExpressionModel& model, const NeutralizationResult& result);

}  // namespace mien
