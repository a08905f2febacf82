// Faces of one person at several visits, neutralized for measuring what changed between them.
//
//     v_k = mean + P a + d + E b_k + e_k,   d ~ N(0, s I) shared,   E = Q + P T,
//     e_k ~ N(0, (s_n n n' + s_t (I - n n')) / w_k),   n the face's own normal.
//
// A template fitted to a scan lies on the skin to a tenth of a millimetre but slides along it by a
// millimetre and more, otherwise at every visit; an expression that is read from where the vertices
// went takes the slide for motion, and a slide over a moving cheek reads as a millilitre. So the
// noise is small along the normal and large across it: what the surfaces show decides, and vertices
// only help. d, what the identity modes miss of this person, is common to all visits, so that
// differences between visits tell the expressions apart without it. With d integrated out the
// visits couple at each vertex through 3 x 3 blocks
//     C_kl = delta_kl M_k - M_k (I / s + sum_m M_m)^-1 M_l,   M_k = w_k (n n' / s_n + (I - n n') /
//     s_t),
// and (a, b_1 .. b_K) solve one symmetric system. Modes are smooth: every third vertex or so speaks
// for its neighbours. Where a change is expected (the treated zone) no vertex speaks, and the
// expression there is what it is elsewhere. Each visit's mixture component is chosen by coordinate
// ascent on the joint evidence.
//
// The neutral face of visit k: the person's first neutral face with the expression b_k says where
// each vertex should be; its foot on the fitted surface k, less the expression's displacement
// there, is where it is. Neutral faces of one person are so in correspondence along the skin, and
// differ by what lies between the surfaces.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/neutralize.hpp"

namespace mien {

struct VisitFace {
    Points vertices;  ///< in the model's topology, finite
    Vector weights;   ///< per vertex, >= 0: 0 where the scan had no data; empty: all one
};

struct VisitsOptions {
    Pose pose = Pose::automatic;
    double normal_noise_mm2 = 0.3;       ///< s_n, > 0
    double tangential_noise_mm2 = 30.0;  ///< s_t, > 0
    std::vector<std::uint32_t> treated;  ///< vertices where the person may have changed
};

struct VisitsResult {
    std::vector<Points> neutral_vertices;  ///< per visit, in the frame of its face
    std::vector<Vector> expressions;       ///< b_k
    std::vector<std::string> components;   ///< name of each visit's mixture component
    std::vector<Similarity> poses;         ///< training frame -> frame of the face
    Matrix covariance;                     ///< K q x K q, posterior of (b_1 .. b_K)
};

/// Throws as neutralize(); Status::invalid_argument for no face. O(K^2 #V (p+q)^2 / 3) and a system
/// of p + K q unknowns.
VisitsResult neutralize_visits(const Context& context, const ExpressionModel& model,
                               const std::vector<VisitFace>& faces, const VisitsOptions& options);

/// What the expressions, taken off or not, add to the volume from visit `first` to visit `second`
/// over some of the model's vertices, mL, and the posterior's deviation of it.
struct RemovedVolume {
    double removed_ml = 0.0;
    double sd_ml = 0.0;
};
RemovedVolume removed_volume(const Context& context, const ExpressionModel& model,
                             const VisitsResult& visits, std::size_t first, std::size_t second,
                             const std::vector<std::uint32_t>& zone);

}  // namespace mien
