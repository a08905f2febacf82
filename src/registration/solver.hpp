// The weighted least-squares step of a fit: which deformation and motion bring the template nearest
// to what was seen, given the prior?
//
//   minimise  sum_i (x_i + u_i - q_i)' H_i (x_i + u_i - q_i) + rho |a|^2 + |c|^2,
//   u = mean + Phi a + P c + G g
//
// with H_i from the evidence (fit_terms.hpp); a the scalar kernel modes (r x 3), c the trained
// vector modes, g a small similarity (7). With isotropic H and no P the system falls apart into one
// r x r matrix with three right-hand sides (2.33). Planes couple the axes. We then keep that r x r
// matrix as the preconditioner of conjugate gradients on the coupled system (fit_system.hpp): no
// 3r x 3r matrix is ever formed, and a step costs a few products with Phi.
#pragma once

#include "base/context.hpp"
#include "model/deformation_model.hpp"
#include "registration/fit_terms.hpp"

namespace mien {

struct FitCoefficients {
    Eigen::MatrixXf kernel;  ///< r x 3
    Eigen::VectorXf pca;     ///< p
};

/// Numerics of the steps: they change the time and the last digits. Tags in brackets:
/// registration/settings.hpp.
struct SolverSettings {
    int most_iterations = 40;  ///< >= 1, of conjugate gradients [J]
    int gram_life = 4;         ///< >= 1: steps for which one Phi' W Phi serves to precondition [J]
    Index sample_half_from = 2000;   ///< rows; with more, every second stands for all in it [J]
    Index sample_third_from = 6000;  ///< rows; with more, every third [J]
    double heavy = 3;  ///< > 1, mean weights; a row beyond it (a landmark) stands for itself [J]
    float ground = 1e-6f;  ///< of the largest diagonal: where nothing is seen at all [J]
    /// Of the diagonal of M, added to the Schur complement until it is positive definite, ten times
    /// more each time: what single precision took away. [J]
    float mend_from = 1e-4f, mend_to = 2;
    double least_variance = 1e-4;  ///< > 0: floor of a mode's prior variance [J]
    double single_precision =
        1e-10;  ///< of the whole right-hand side: residuals below are rounding [J]
};

struct FitStepOptions {
    Index scalar_modes = 0;  ///< of the model's r; 0: none
    Index pca_modes = 0;
    double kernel_ridge = 1.0;  ///< rho: 1 / (amplification of the model's own variance)
    double pca_ridge = 1.0;
    const Eigen::MatrixXf* kernel_mean = nullptr;  ///< what the prior expects of a, >= scalar_modes
                                                   ///< x 3; null: zero
    bool move = true;                              ///< solve for the small motion too
    bool scale = true;                             ///< the motion may scale
    double tolerance = 0.1;  ///< by how much a step reduces the preconditioned residual
    SolverSettings solver;
};

/// Phi' W Phi of an earlier step, for preconditioning; W had the sum `weight`. Of the same step:
/// Phi' W V and V' W V, V the trained modes and the motions.
struct GramCache {
    Eigen::MatrixXf gram, coupling, vector_gram;
    double weight = 0;
    int age = 0;
};

/// Keeps work space between steps. One per fit; not shared between threads.
class FitSolver {
  public:
    explicit FitSolver(const DeformationModel& model);

    /// The vertices that the steps look at from now on: row k of the terms is vertex rows[k]. Early
    /// rounds use a part of the vertices, because the modes that matter then are smooth. Empty: all
    /// vertices.
    void use_rows(std::vector<Index> rows, Index scalar_modes, Index pca_modes,
                  const Context& context);
    Index num_rows() const { return num_rows_; }
    Index vertex(Index row) const {
        return rows_.empty() ? row : rows_[static_cast<std::size_t>(row)];
    }

    /// Improves `coefficients` in place and returns the small motion about the current places
    /// `current` (one row per row, model frame). Throws Status::no_solution when the system is not
    /// positive definite.
    Similarity step(const FitTerms& terms, const PointsRef& current, const FitStepOptions& options,
                    FitCoefficients& coefficients, const Context& context);

    /// mean + Phi a + P c, #V x 3, of all vertices.
    Points displacement(const FitCoefficients& coefficients, const Context& context) const;

    int iterations() const { return iterations_; }  ///< conjugate gradient steps of the last call

    using ConstMap = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
    /// The modes at the rows: m x r, and 3m x p (x0 y0 z0 x1 ...).
    ConstMap basis() const;
    ConstMap pca() const;

  private:
    const DeformationModel& model_;
    std::vector<Index> rows_;
    Index num_rows_ = 0;
    Eigen::MatrixXf packed_basis_, packed_pca_;
    GramCache cache_;
    int iterations_ = 0;
};

}  // namespace mien
