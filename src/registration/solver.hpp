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

/// Quadratic terms of the vertices that a step looks at, in the model frame. A row of zeros says
/// nothing about its vertex.
struct FitTerms {
    Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor>
        precision;                                                  ///< xx yy zz xy xz yz, 1/mm^2
    Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> pull;  ///< sum of H (q - x - mean)

    void reset(Index num_rows);
    void add(Index row, const Matrix3& precision, const Vector3& pull);
    void add_isotropic(Index row, double weight, const Vector3& target_displacement);
    void add_planar(Index row, double weight, double tau, const Vector3& normal,
                    const Vector3& target_displacement);
};

struct FitCoefficients {
    Eigen::MatrixXf kernel;  ///< r x 3
    Eigen::VectorXf pca;     ///< p
};

struct FitStepOptions {
    Index scalar_modes = 0;  ///< of the model's r; 0: none
    Index pca_modes = 0;
    double kernel_ridge = 1.0;  ///< rho: 1 / (amplification of the model's own variance)
    double pca_ridge = 1.0;
    bool move = true;   ///< solve for the small motion too
    bool scale = true;  ///< the motion may scale
    int max_iterations = 40;
    double tolerance = 0.1;  ///< by how much a step reduces the preconditioned residual
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

  private:
    using ConstMap = Eigen::Map<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
    ConstMap basis() const;
    ConstMap pca() const;
    friend class FitSystem;

    const DeformationModel& model_;
    std::vector<Index> rows_;
    Index num_rows_ = 0;
    Eigen::MatrixXf packed_basis_, packed_pca_;
    // Phi' W Phi of an earlier step, for preconditioning; W had the sum gram_weight_.
    Eigen::MatrixXf gram_;
    // Of the same step: Phi' W V and V' W V, V the trained modes and the motions.
    Eigen::MatrixXf coupling_, vector_gram_;
    double gram_weight_ = 0;
    int gram_age_ = 0;
    int iterations_ = 0;
};

}  // namespace mien
