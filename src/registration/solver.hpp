// The weighted least-squares step of a fit: which deformation and motion bring the template nearest
// to what was seen, given the prior?
//
//   minimise  sum_i (x_i + u_i - q_i)' H_i (x_i + u_i - q_i) + rho |a|^2 + |c|^2,
//   u = mean + Phi a + P c + G g
//
// with H_i = w_i (n n' + tau (I - n n')) from a surface hit, or w_i I from a landmark; a the scalar
// kernel modes (r x 3), c the trained vector modes, g a small similarity (7). With tau = 1 and no P
// the system falls apart into one r x r matrix with three right-hand sides (2.33). With tau < 1 the
// axes couple. We then keep that r x r matrix as the preconditioner of conjugate gradients on the
// coupled system: no 3r x 3r matrix is ever formed, and a step costs a few products with Phi.
#pragma once

#include "base/context.hpp"
#include "model/deformation_model.hpp"

namespace mien {

/// Per-vertex quadratic terms in the model frame. A row of zeros says nothing about its vertex.
struct FitTerms {
    Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor> precision;  ///< xx yy zz xy xz yz, 1/mm^2
    Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> pull;       ///< sum of H (q - x - mean)

    void reset(Index num_vertices);
    void add_isotropic(Index vertex, double weight, const Vector3& target_displacement);
    void add_planar(Index vertex, double weight, double tau, const Vector3& normal,
                    const Vector3& target_displacement);
};

struct FitCoefficients {
    Eigen::MatrixXf kernel;  ///< r x 3
    Eigen::VectorXf pca;     ///< p
};

struct FitStepOptions {
    Index scalar_modes = 0;       ///< of the model's r; 0: none
    Index pca_modes = 0;
    double kernel_ridge = 1.0;    ///< rho: 1 / (amplification of the model's own variance)
    double pca_ridge = 1.0;
    bool move = true;             ///< solve for the small motion too
    bool scale = true;            ///< the motion may scale
    int max_iterations = 40;
    double tolerance = 1e-3;      ///< of the preconditioned residual, relative
};

/// Keeps work space between steps. One per fit; not shared between threads.
class FitSolver {
  public:
    explicit FitSolver(const DeformationModel& model);

    /// Improves `coefficients` (sized by prepare) in place and returns the small motion about the
    /// current places `current` (#V x 3, model frame): x -> x + w x x + t + s x.
    /// Throws Status::no_solution when the system is not positive definite.
    Similarity step(const FitTerms& terms, const PointsRef& current, const FitStepOptions& options,
                    FitCoefficients& coefficients, const Context& context);

    /// mean + Phi a + P c, #V x 3.
    Points displacement(const FitCoefficients& coefficients, const Context& context) const;

    int iterations() const { return iterations_; }  ///< conjugate gradient steps of the last call

  private:
    const DeformationModel& model_;
    int iterations_ = 0;
};

}  // namespace mien
