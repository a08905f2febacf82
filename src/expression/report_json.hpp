// Reports as JSON text, written without a document tree.
#pragma once

#include <string>

#include "expression/evaluation.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "expression/visits.hpp"

namespace mien {

std::string training_json(const ExpressionModel& model, const TrainReport& report);
/// Sizes, names, noise, and what the file says of its making.
std::string model_json(const ExpressionModel& model);
/// Table 4.2: per expression and over all but the neutral faces the errors of the untouched faces,
/// of the method, and of `against` (null: none), with the effect of the method over the other.
std::string evaluation_json(const FaceDataset& dataset, const EvaluatedFaces& baseline,
                            const EvaluatedFaces& result, const EvaluatedFaces* against);
std::string neutralization_json(const ExpressionModel& model, const NeutralizationResult& result);
std::string visits_json(const ExpressionModel& model, const VisitsResult& result);

}  // namespace mien
