// Coordinates of a face in an expression model.
//
// alternating: block relaxation, Algorithm 2 of J 4.2.3, for reproduction. exact: its limit, the
//   joint least squares of (4.14) solved at once. map: the same with Gaussian priors. mixture (the
//   default): the prior of b is the model's mixture over expressions; each component gives a linear
//   Gaussian estimate c_k and an evidence e_k, and the coordinates are sum_k w_k c_k, w_k ~ e_k:
//   the posterior mean. A face that looks neutral then stays neutral, which no single Gaussian
//   does.
//
// With B = [P Q] (with spill: [P + Q R, Q + P T], for map and mixture only), diagonal weights W
// (three equal entries per vertex), r = B' W (v - mean) and G = B' W B, component k with prior
// precision L_k and mean m_k gives
//   (G + s L_k) (c_k - m_k) = r - G m_k,  s the noise variance,
//   log e_k = log weight_k + [(c_k - m_k)'(r - G m_k) + 2 r'm_k - m_k'G m_k] / 2s
//             - log det(G/s + L_k) / 2 + log det(L_k) / 2 + constant.
// A weak smile is a smile: each trained expression is tried at a few intensities t, with mean t m,
// covariance t^2 C + (1 - t^2) f T and an equal part of its weight, T the variance of all
// expressions and f a small share; "neutral" and "any" as they are.
// Where an expression's mean follows the person, b ~ N(m + M a, C), the joint prior stays Gaussian:
// with A the identity's variances and K = C^-1
//   L_k = [A^-1 + M'K M, -M'K; -K M, K],  mean (0, m),  det L_k = det A^-1 det K.
#pragma once

#include "base/context.hpp"
#include "expression/expression_model.hpp"

namespace mien {

/// The numbers are the C ABI's numbers.
enum class FitMethod : std::int32_t { mixture = 0, map = 1, exact = 2, alternating = 3 };

struct FitOptions {
    FitMethod method = FitMethod::mixture;
    int max_sweeps = 200;     ///< alternating: at most, 1..100000
    double tolerance = 1e-6;  ///< alternating: stop when a sweep moves the expression by less (mm
                              ///< root mean square over all coordinates), 0: never
    double noise_mm2 = 0.0;   ///< 0: the model's own
};

struct FitResult {
    Vector identity;    ///< p, a
    Vector expression;  ///< q, b
    Matrix covariance;  ///< (p+q)^2, posterior of (a, b), mm^2; empty for exact and alternating
    std::vector<double> component_probabilities;  ///< of model.components; mixture only
    std::vector<double> part_probabilities;       ///< of the plan's components; mixture only
    double intensity = 1.0;  ///< expected, of the likeliest component; mixture only
    int sweeps = 0;          ///< alternating
    bool converged = true;   ///< alternating: the stop rule was met
};

/// What the fit needs of one face: linear in the data, so that several faces can be combined.
struct FaceEvidence {
    Vector projection;  ///< B' W (v - mean), p+q
    Matrix gram;        ///< B' W B; empty: the model's own (all weights one)
};

/// Factorisations that do not depend on the face, for weights of one.
struct FitPlan {
    struct Part {
        Matrix prior_precision;    ///< (p+q)^2, L without A^-1: of the expression, given the person
        Matrix solve;              ///< (G + s L)^-1, symmetric
        double log_det_prior = 0;  ///< of the expression's own part of it, K
        double log_offset = 0;     ///< everything in log e_k that does not depend on the face
        Vector mean;               ///< p+q, zeros and the component's mean
        Vector gram_mean;          ///< G m_k
        double weight = 1.0;       ///< prior probability, up to a common factor
        std::size_t component = 0;  ///< of model.components
        double intensity = 1.0;     ///< share of the component's mean
    };
    Matrix expression_gram;  ///< q x q, E'E of what the expression coordinates move, E = Q + P T
    Part map;
    std::vector<Part> components;  ///< every component at its intensities, in their order
};

/// Throws Status::mismatch, invalid_argument or invalid_mesh unless vertices and weights (or none)
/// belong to the model; rows of weight zero may hold anything.
void check_face(const ExpressionModel& model, const PointsRef& vertices,
                const Vector& weights_per_vertex);

/// sum_i w_i B_i' B_i for the modes B = (identity, expression) and #V weights that are not
/// negative. O(#V (p+q)^2).
Matrix mode_gram(const Context& context, const ExpressionModel& model, const Vector& weights);

/// Weights per vertex, >= 0, or empty for ones. O(#V (p+q)), and O(#V (p+q)^2) more with weights.
FaceEvidence gather_evidence(const Context& context, const ExpressionModel& model,
                             const PointsRef& vertices, const Vector& weights_per_vertex);

/// Throws Status::no_solution when the system is singular (`exact` with too few visible vertices).
FitResult fit_face(const ExpressionModel& model, const FaceEvidence& evidence,
                   const FitOptions& options);

/// Coordinates along P and along Q of a fit with `method`: the identity's part, the expression's
/// part, or both; empty vectors stand for zero.
Vector mode_coordinates(const ExpressionModel& model, FitMethod method, const Vector& identity,
                        const Vector& expression);

/// (p+q)^2: the precision of the expression, given the person (FitPlan::Part), from its own one (q
/// x q) and how its mean follows the person (ExpressionComponent).
Matrix precision_given_person(Index identity_modes, const Matrix& expression_precision,
                              const Matrix& follows);

/// Part for a Gaussian prior with the given precision (precision_given_person), that of the
/// identity (ExpressionModel::identity_precision) and mean on top of `gram`, which is that of the
/// joint coordinates (ModeSpill::pull_gram).
FitPlan::Part plan_part(const ExpressionModel& model, const Matrix& gram, double noise_mm2,
                        const Matrix& precision, const Matrix& identity_precision,
                        const Vector& expression_mean, double log_weight);

/// All parts of the model's mixture: every component at its intensities.
std::vector<FitPlan::Part> component_parts(const ExpressionModel& model, const Matrix& gram,
                                           double noise_mm2);

/// B' y without B in double: columns of floats, sums in double over fixed chunks.
Vector project_modes(const Context& context, const ModesView& modes, const Vector& displacement);
/// out += modes * coordinates.
void add_modes(const Context& context, const ModesView& modes, const Vector& coordinates,
               Eigen::Ref<Vector> out);

}  // namespace mien
