// The normal equations of several faces of one person, and the search for their expressions.
//
// With d integrated out (joint_fit.hpp) the faces couple at each vertex through 3 x 3 blocks
//     C_kl = delta_kl M_k - M_k (I / s + sum_m M_m)^-1 M_l,
//     M_k = w_k (n n' / s_n + (I - n n') / s_t),   isotropic: w_k I / t,
// and (a, b_1 .. b_K) solve one symmetric system. The priors of the expressions come on top of it
// when a mixture component is tried for each face.
#pragma once

#include <limits>
#include <vector>

#include "expression/joint_fit.hpp"

namespace mien {

class JointSystem {
  public:
    /// `weights` per face, not empty where any face has some; all referred to for the system's
    /// life. `stride`: every so-many-th vertex speaks.
    JointSystem(const Context& context, const ExpressionModel& model,
                const JointFitOptions& options, const std::vector<Vector>& weights, Index stride);

    /// The normal equations of faces in the training's frame.
    void gather(const std::vector<Points>& placed);
    /// Solves with the components in `chosen` and climbs: a face takes another of its candidates
    /// wherever the joint evidence rises.
    void choose(std::vector<std::size_t>& chosen,
                const std::vector<std::vector<std::size_t>>& candidates);
    /// Turns and shifts face k onto the common face with its expression, along the normals; `pose`
    /// (training frame -> frame of the face) follows.
    void settle(Index k, std::vector<Points>& placed, Similarity& pose) const;

    Vector identity() const { return solution_.coordinates.head(p_); }
    Vector expression(Index k) const { return solution_.coordinates.segment(p_ + k * q_, q_); }
    /// K q x K q, posterior of all expressions.
    Matrix covariance(const std::vector<std::size_t>& chosen) const;

  private:
    struct Solution {
        Vector coordinates;
        double log_evidence = -std::numeric_limits<double>::infinity();
    };
    bool mixture() const;
    double shared_noise() const;
    const FitPlan::Part& part(std::size_t component) const;
    bool uniform() const;
    void weigh(const std::vector<Points>& placed);
    void gather_uniform(const std::vector<Points>& placed);
    void gather_blocks(const std::vector<Points>& placed);
    Matrix3 coupling(Index k, Index l, Index i) const;
    void add_gram(Index k, Index l, const Matrix& gram);
    Matrix with_priors(const std::vector<std::size_t>& choice) const;
    Solution solve_with(const std::vector<std::size_t>& choice) const;
    std::vector<Vector> rests(const std::vector<Points>& placed) const;

    const Context& context_;
    const ExpressionModel& model_;
    const JointFitOptions& options_;
    const std::vector<Vector>& weights_;
    Index count_, p_, q_;
    std::vector<Index> speakers_;
    Matrix modes_;                    ///< [P + Q R, Q + P T] at the speakers, 3 rows each
    std::vector<Matrix3> precision_;  ///< M_k at the speakers, face by face
    std::vector<Matrix3> common_;     ///< (I / s + sum_m M_m)^-1
    Matrix data_;                     ///< (p + K q)^2, with the identity's prior
    Vector right_;                    ///< p + K q
    Solution solution_;
};

}  // namespace mien
