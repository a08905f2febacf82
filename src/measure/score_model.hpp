// A biomarker score from a face's shape: features per vertex (displacement from the mean face,
// principal curvatures), partial least squares on raters' grades, prediction with an interval, and
// the face along the score (jousse-2022, chapter 3 as summarised in 1.4, 5.1 and C.3).
//
// Focus. Each feature counts by how far its vertex moves with the score (score_direction.hpp),
// found anew in every fold: where a score does nothing, people's differences are nothing but noise.
//
// Features. Faces are aligned rigidly on the stable zone (or all of the face, robustly). Vertex i
// gives sqrt(area_i w_i) times its displacement (3) and c sqrt(area_i w_i) times its two principal
// curvatures, so that sums over features are integrals over skin; c makes the curvatures' total
// variance a chosen multiple of the displacements'. w_i is 1 in the zones of interest, 0 elsewhere.
//
// Prediction interval. y -+ t(0.975, n - A - 1) s sqrt((1 + 1/n + h) / (1 + (A + 1)/n)), s being
// the cross-validated root mean square error and h = t' (T'T)^-1 t the leverage: as wide as
// held-out faces were wrong, wider for faces unlike the training (after Faber & Kowalski 1997).
//
// Simulation. The displacement that goes with one grade is the regression of each vertex'
// displacement on the grades, without what chance put into it (score_direction.hpp): how faces that
// score higher look, not the filter that computes the score (Haufe et al. 2014).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/safetensors.hpp"
#include "measure/pls.hpp"
#include "mesh/dataset.hpp"

namespace mien {

/// What a vertex gives. J (B.2) has 17 numbers a vertex and names two kinds of them, displacements
/// and principal curvatures (5.2): which the others are is not published. Ours are listed at
/// kShapeFeatures (score_features.hpp).
enum class ScoreFeatures : std::int32_t {
    displacement_and_curvature = 0,  ///< 5: displacement, k1, k2
    all = 1                          ///< 17
};

struct ScoreOptions {
    ScoreFeatures features = ScoreFeatures::displacement_and_curvature;
    PlsMethod method = PlsMethod::nipals;
    int num_components = 0;   ///< 0: by cross-validation and the one-standard-error rule
    int max_components = 10;  ///< 1 .. 50
    int folds = 10;           ///< 0: leave one person out
    std::uint64_t seed = 1;
    bool focus = true;             ///< false: every vertex counts by its area alone
    double curvature_share = 0.1;  ///< total variance of curvatures (of all shape features
                                   ///< together) over displacements; 0: none
    double curvature_radius_mm = 8.0;
    std::vector<std::uint32_t> zone;         ///< of interest; empty: the whole face
    std::vector<std::uint32_t> stable_zone;  ///< aligned on; empty: the whole face, robustly
    double lowest = 0.0, highest = 0.0;      ///< range of the score; equal: no limits
};

/// Immutable once trained or loaded.
struct ScoreModel {
    Points mean_face;  ///< #V x 3, mm
    Triangles triangles;
    Vector displacement_scale;  ///< #V, 0 outside the zone; with the focus
    Vector curvature_scale;     ///< #V, all 0 without curvatures
    Vector shape_scale;         ///< kShapeFeatures; empty: displacement and curvature alone
    std::vector<std::uint32_t> stable_zone;
    double curvature_radius_mm = 8.0;
    Vector feature_mean;              ///< p
    Matrix rotations;                 ///< p x A
    Vector y_loadings;                ///< A
    Vector score_squares;             ///< A, diagonal of T'T
    double y_mean = 0.0, rmse = 0.0;  ///< rmse: cross-validated
    double q2 = 0.0;                  ///< 1 - cross-validated error over the mean's
    Index num_samples = 0;
    Points unit_displacement;  ///< #V x 3, mm per unit of score
    Matrix latent_pictures;    ///< #V x A: |displacement| in mm at one deviation of the score
    Vector cv_error, cv_standard_error;  ///< mean square, by number of components from 0
    int best_components = 0, one_se_components = 0;
    double lowest = 0.0, highest = 0.0;
    double focus_places = 0;  ///< how many places the focus takes a face for; 0: none, or loaded
    Vector cv_predictions;    ///< n, of held-out faces; empty when loaded

    Index num_components() const { return rotations.cols(); }
};

struct ScorePrediction {
    double score = 0.0;
    double low95 = 0.0, high95 = 0.0;
    double leverage = 0.0;  ///< of this face; above 3 (A + 1) / n it is unlike the training
    bool extrapolates = false;
};

/// grades: one per face of the set, NaN: not graded (left out). Faces of one subject stay in one
/// fold.
ScoreModel train_score(const FaceDataset& faces, const Vector& grades, const ScoreOptions& options,
                       const Context& context);

/// Throws Status::mismatch for another topology.
ScorePrediction predict_score(const ScoreModel& model, const PointsRef& face,
                              const Context& context);

/// The face moved along the score by (target - its own predicted score) grades; pass the mean face
/// to see the bare direction. Predictions shrink towards the mean, so the score predicted for the
/// result may stop short of the target.
Points simulate_score(const ScoreModel& model, const PointsRef& face, double target,
                      const Context& context);

/// safetensors, kind "mien-score-model", format 1.
void save_score_model(const std::string& path, const ScoreModel& model, const Context& context);
ScoreModel load_score_model(const std::string& path, const SafetensorsReadOptions& options,
                            const Context& context);

}  // namespace mien
