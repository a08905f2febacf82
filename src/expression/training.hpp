// From a study's faces to an expression model: joint span, subspaces, prior, noise.
#pragma once

#include <memory>
#include <vector>

#include "base/context.hpp"
#include "expression/column_source.hpp"
#include "expression/expression_model.hpp"
#include "expression/joint_pca.hpp"
#include "expression/joint_span.hpp"
#include "expression/mode_search.hpp"
#include "expression/noise.hpp"
#include "expression/prior.hpp"
#include "expression/smooth_identity.hpp"
#include "mesh/dataset.hpp"

namespace mien {

/// A number of modes that stands for "by hold-out". The default since 100 people of seed 1 gave
/// 0.16 mm on 40 of seed 2 by it (75 + 75 modes), 0.17 with 50 + 50 (tests/bench/README.md).
constexpr Index kSearchedModes = 0;

struct TrainOptions {
    JointPcaOptions subspaces;  ///< modes of 0: by hold-out over the people (mode_search.hpp)
    ModeSearch search;
    JointSpanOptions span;  ///< ranks of 0: max(3 modes, modes + 60)
    PriorOptions prior;
    SmoothIdentityOptions smooth;  ///< what people may differ by beyond the training's
    /// Posture: faces are aligned rigidly on these vertices (forehead, nose bridge), in training
    /// and by every fit of the model; empty: faces are taken as they lie.
    std::vector<std::uint32_t> stable_vertices;
    double map_noise_mm2 = 0.0, mixture_noise_mm2 = 0.0;  ///< 0: by cross-validation
    TrainOptions() {
        span.identity_rank = span.expression_rank = 0;
        subspaces.identity_modes = subspaces.expression_modes = kSearchedModes;
    }
};

struct TrainReport {
    Index subjects = 0, faces = 0, skipped_faces = 0;
    double k = 1, lambda = 0;
    int iterations = 0;
    double last_angle_rad = 0;
    bool converged = true;
    Vector orthogonality;            ///< ||P_c Q_c'||, c = 1 ..
    Vector joint_pca_orthogonality;  ///< the same of joint PCA on these faces
    double identity_explained = 0, expression_explained = 0;  ///< shares of the training variance
    double span_cut = 0;  ///< share of the variance that the joint span does not hold
    NoiseLevels noise;
    Index smooth_modes = 0;                         ///< identity modes of the smooth prior
    double smooth_variance_mm2 = 0;                 ///< of that prior
    std::vector<TriedSmoothness> tried_smoothness;  ///< empty where nobody could be left out
    std::vector<TriedModes> tried_modes;            ///< empty unless a number of modes was searched
};

/// Deterministic; the same bits for any thread count. O(passes #V s r). Throws
/// Status::invalid_argument (no neutral faces, fewer than 2 subjects, nothing to learn),
/// memory_budget, cancelled, corrupt.
std::shared_ptr<const ExpressionModel> train_expression_model(const ColumnSource& source,
                                                              const TrainOptions& options,
                                                              const Context& context,
                                                              TrainReport* report = nullptr);
std::shared_ptr<const ExpressionModel> train_expression_model(
    std::shared_ptr<const FaceDataset> dataset, const TrainOptions& options, const Context& context,
    TrainReport* report = nullptr);

}  // namespace mien
