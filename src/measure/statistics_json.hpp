// Rater statistics, repeatability and score models as JSON text.
#pragma once

#include <string>

#include "measure/agreement.hpp"
#include "measure/repeatability.hpp"
#include "measure/score_model.hpp"

namespace mien {

/// Confusion matrices, percent agreement, Cohen's kappas of every pair, Fleiss' kappa, all six
/// intraclass correlations (on complete subjects; null where they are undefined), majority grades.
std::string agreement_json(const Ratings& ratings, int num_grades);

/// values[i] was measured on subjects[i]. With blanks (measured changes where nothing changed), the
/// limit of detection too.
std::string repeatability_json(const std::vector<double>& values, const std::vector<int>& subjects,
                               const std::vector<double>& blanks);

std::string bland_altman_json(const std::vector<double>& first, const std::vector<double>& second);

std::string score_model_json(const ScoreModel& model);

}  // namespace mien
