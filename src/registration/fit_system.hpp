// The coupled normal equations of one step, as products with them and a preconditioner.
//
//   A = B' H B + R,   B = [Phi (x) I3 | P | G],
//
// H the evidence's blocks, R the prior's ridge. The kernel's smooth modes are nearly motions, and
// nearly the trained modes too. Seen apart, a motion and the modes that undo it look stiff, and
// together only the prior resists them: conjugate gradients wander along such pairs for tens of
// iterations, and in single precision never twice along the same way. So all are preconditioned
// together,
//
//   [K C; C' M]^-1,  K = Phi' W Phi + ridge,  C = Phi' W V,  M = V' W V + ridge,
//
// W the mean of H's diagonal, V the trained modes and the motions, by the Schur complement
// S = M - C' K^-1 C.
#pragma once

#include "base/dense.hpp"
#include "registration/solver.hpp"

namespace mien {

/// Flat unknown: kernel (3 r, axis by axis), pca (p), motion (7, 6 without scale, or 0).
struct FitLayout {
    Index r, p, g;
    Index size() const { return 3 * r + p + g; }
};

/// Lives for one step; borrows all that it is given.
class FitSystem {
  public:
    using VectorF = Eigen::VectorXf;
    using MatrixF = Eigen::MatrixXf;

    /// `basis`, `pca`: the modes at the rows. `prior_variance`: of the model, or empty. `current`:
    /// places of the rows. Throws Status::no_solution when the equations are not positive definite.
    FitSystem(FitSolver::ConstMap basis, FitSolver::ConstMap pca, const Matrix& prior_variance,
              GramCache& cache, const FitTerms& terms, const PointsRef& current,
              const FitStepOptions& options, FitLayout layout, const Context& context);

    double radius() const { return radius_; }
    const Vector3& centre() const { return centre_; }
    void load_pull() { field_ = terms_.pull; }

    void project(VectorF& out);                      ///< out = B' field
    void add_expected(VectorF& out) const;           ///< out += ridge times the prior's mean
    void apply(const VectorF& theta, VectorF& out);  ///< out = A theta
    void precondition(const VectorF& in, VectorF& out) const;

  private:
    bool coupled() const { return layout_.r > 0 && layout_.p + layout_.g > 0; }
    double total_weight() const { return terms_.precision.leftCols<3>().cast<double>().sum() / 3; }
    void weigh(Index first, Index count);
    void project_vectors(VectorF& out);
    void expand_vectors(const VectorF& theta);
    void vectors_at(Index i, Eigen::Matrix<float, 3, Eigen::Dynamic>& block) const;
    void set_ridge(const Matrix& prior_variance);
    void factor_kernel();
    void sample_gram();
    void couple_vectors(const std::vector<Index>& rows, const VectorF& root, const MatrixF& sample);
    void factor_coupled(double scale);
    void factor_vectors();

    const FitSolver::ConstMap basis_, pca_;
    GramCache& cache_;
    const FitTerms& terms_;
    const PointsRef current_;
    const FitStepOptions& options_;
    const FitLayout layout_;
    const Context& context_;
    Vector3 centre_;
    double radius_ = 1;
    dense::Field field_;
    Points flat_;
    VectorF kernel_ridge_;  // 3 r
    int factor_of_[3] = {0, 1, 2};
    MatrixF kernel_factor_[3], vector_factor_;  // Cholesky, lower triangles, of K and S
    MatrixF coupling_, carried_;                // C and K^-1 C, 3 r x (p + g)
};

}  // namespace mien
