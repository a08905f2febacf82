// One person's faces taken apart together: one identity, an expression each. One to K faces.
//
//     v_k = mean + P a + d + E b_k + e_k,   d ~ N(0, s I) shared,   E = Q + P T,
//
// d is what the identity modes miss of this person (s, the model's noise level). It is common to
// all faces, so that differences between faces tell the expressions apart without it. What differs
// beyond the model, e_k, has one of two laws:
//   isotropic     N(0, t I / w_k), t a share of s: vertices in true correspondence.
//   along_normal  N(0, (s_n n n' + s_t (I - n n')) / w_k), n the face's own normal: templates that
//                 were fitted to scans lie on the skin to a tenth of a millimetre but slide along
//                 it by a millimetre and more, otherwise at every visit. An expression that is read
//                 from where the vertices went takes the slide for motion, and a slide over a
//                 moving cheek reads as a millilitre: what the surfaces show decides.
// A single isotropic face cannot tell d from e: both together are N(0, s I / w), and its answer is
// the posterior mean over all mixture components (fit.hpp), with its pose and its outliers
// (placed_fit.hpp). With more faces, or along normals, joint_system.hpp couples them; each face's
// mixture component is then chosen by coordinate ascent on the joint evidence.
//
// In a treated zone the person may have changed: no vertex there is a witness of expression,
// identity or pose, in the single fits and in the joint one; the expression there is what it is
// elsewhere.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/fit.hpp"
#include "expression/placed_fit.hpp"

namespace mien {

/// A face in the model's topology.
struct JointFace {
    Points vertices;  ///< #V x 3, mm; where its weight is 0 it may hold anything
    Vector weights;   ///< per vertex, >= 0: 0 where the scan had no data; empty: all one
};

enum class JointNoise { isotropic, along_normal };

/// How the joint answer is looked for. Taken over from the visits' fit, not tuned anew; the round
/// limit is a guard.
struct JointSearch {
    Index speakers = 3000;  ///< along normals: about so many vertices enter the normal equations,
                            ///< each for its neighbours (modes are smooth), >= 1
    int pose_steps = 2;     ///< along normals: steps of the poses between solutions, 0..20
    double far_mm = 2.0;    ///< off the common face: no witness of the pose, > 0
    Index candidates = 3;   ///< mixture components tried per face, the likeliest of its own fit
    int max_rounds = 20;    ///< of coordinate ascent over the faces, at most
};

struct JointFitOptions {
    FitOptions fit;  ///< joint: mixture or map; noise_mm2 is s, 0: the model's
    Pose pose = Pose::automatic;
    JointNoise noise = JointNoise::along_normal;
    double face_noise_share = 0.01;      ///< isotropic: t / s, > 0
    double normal_noise_mm2 = 0.3;       ///< s_n, > 0
    double tangential_noise_mm2 = 30.0;  ///< s_t, > 0
    std::vector<std::uint32_t> treated;  ///< vertices where the person may have changed
    JointSearch search;
};

struct JointFit {
    Vector identity;                  ///< a
    std::vector<Vector> expressions;  ///< b_k
    Matrix covariance;                ///< K q x K q, posterior of (b_1 .. b_K); without prior empty
    std::vector<std::size_t> chosen;  ///< each face's part of the mixture (of the
                                      ///< model's plan); map: empty
    std::vector<Similarity> poses;    ///< training frame -> frame of the face
    std::vector<Points> placed;       ///< the faces in the training's frame
    std::vector<PlacedFit> alone;     ///< each face's own fit
};

/// Throws Status::mismatch, invalid_mesh, invalid_argument (no face, options out of range, a joint
/// fit without a prior), no_solution. One isotropic face: O(#V (p+q)). Else O(K^2 m (p+q)^2), m the
/// speakers (isotropic: all vertices, and O(K^2 #V (p+q)) when all weights are one), and systems of
/// p + K q unknowns.
JointFit fit_faces(const Context& context, const ExpressionModel& model,
                   const std::vector<JointFace>& faces, const JointFitOptions& options);

/// Weights of the vertices that may speak about the expression: the face's, 0 in the treated zone;
/// empty: all one.
Vector witness_weights(const Vector& weights_per_vertex, Index num_vertices,
                       const std::vector<std::uint32_t>& treated);

}  // namespace mien
