// Reports as JSON text, written without a document tree.
#pragma once

#include <string>

#include "expression/evaluation.hpp"
#include "expression/neutralize.hpp"
#include "expression/training.hpp"
#include "expression/treated_readings.hpp"
#include "expression/visits.hpp"

namespace mien {

std::string training_json(const ExpressionModel& model, const TrainReport& report);
/// Sizes, names, noise, and what the file says of its making.
std::string model_json(const ExpressionModel& model);
/// Table 4.2: per expression and over all but the neutral faces the errors of the untouched faces,
/// of the method, and of `against` (null: none), with the effect of the method over the other; and
/// tables 4.3 and A.1 to A.4 where volumes were measured, named by `volume_names`.
std::string evaluation_json(const FaceDataset& dataset, const EvaluatedFaces& baseline,
                            const EvaluatedFaces& result, const EvaluatedFaces* against,
                            const std::vector<std::string>& volume_names = {});
/// readings: of the treated zone; null for none.
std::string neutralization_json(const ExpressionModel& model, const NeutralizationResult& result,
                                const TreatedReadings* readings = nullptr);
std::string visits_json(const ExpressionModel& model, const VisitsResult& result);

}  // namespace mien
