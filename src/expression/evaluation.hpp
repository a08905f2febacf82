// How well neutralization works (J 4.4): per expression the mean vertex distance between the
// neutralized face and the subject's neutral face, and the effect of one method over another.
//
// Departures from J: (4.32) divides a norm by 3n and its sigma lacks a square; here a face's error
// is the mean of its vertex distances. (4.33) is Cohen's d with the root of the mean of both
// variances, the textbook form. (4.34) adds deviations where variances belong; here P(first >
// second) = Phi((mu1 - mu2) / sqrt(var1 + var2)) = Phi(d / sqrt 2).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/neutralize.hpp"
#include "mesh/dataset.hpp"

namespace mien {

struct EvaluationOptions {
    NeutralizeOptions neutralize;
    std::vector<std::uint32_t> zone;    ///< measure on these vertices; empty: all
    std::vector<std::uint32_t> stable;  ///< align every face rigidly to its target on these first
    /// Volumes between a subject's neutral face and another of the faces, mL, one per entry of
    /// `volume_names`; empty: none are measured. A room above measures them: this one does not know
    /// how.
    std::vector<std::string> volume_names;
    std::function<std::vector<double>(const Points& neutral, const Points& face)> volumes_ml;
};

struct ErrorSummary {
    std::string name;  ///< expression
    Index count = 0;
    double mean_mm = 0, deviation_mm = 0, max_vertex_mm = 0;
};

struct Effect {
    double cohens_d = 0;       ///< positive: the second is better; NaN without spread
    double superiority = 0.5;  ///< P(error of the first > error of the second)
};

/// Errors of one way to neutralize, one entry per dataset face whose subject has a neutral face.
struct EvaluatedFaces {
    std::vector<Index> face;
    std::vector<int> expression;
    std::vector<double> mean_mm, max_mm;
    std::vector<std::vector<double>> volumes_ml;  ///< as EvaluationOptions::volumes_ml, or empty
};

/// A volume over the faces of one expression, mL.
struct VolumeSummary {
    double mean_ml = 0, deviation_ml = 0, median_ml = 0;
};
VolumeSummary summarize_volume(std::vector<double> volumes_ml);

/// Result of one face: neutralized vertices in `face`'s place.
using Neutralizer = std::function<void(Index face, Points& vertices)>;

/// Runs `neutralizer` (null: baseline) over every face of the set that has a target. Calling
/// thread.
EvaluatedFaces evaluate_faces(const Context& context, const FaceDataset& dataset,
                              const EvaluationOptions& options, const Neutralizer& neutralizer);
/// The same with a model: options.neutralize.
EvaluatedFaces evaluate_model(const Context& context, const FaceDataset& dataset,
                              const ExpressionModel& model, const EvaluationOptions& options);

/// One entry per expression in the order of the names, neutral included where there is one.
std::vector<ErrorSummary> summarize(const EvaluatedFaces& errors,
                                    const std::vector<std::string>& names);
/// All faces but the neutral ones; `neutral` is the index of that expression.
ErrorSummary summarize_moved(const EvaluatedFaces& errors, int neutral);

Effect effect_size(const std::vector<double>& first, const std::vector<double>& second);

}  // namespace mien
