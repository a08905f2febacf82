// The walls that no scanner sees: the sacs of nostrils, the insides of lips and lids. They lie
// against each other or behind the skin, so the closest point of a scan is seldom theirs, and a
// prior along the surface carries them little with the skin before them: left alone, a nostril's
// sac ends outside of a slim nose.
//
// Moved: u(y) = m - D (S + e I)^-1 p, a linear regression of the open skin's displacements u_j
// about the wall's vertex y; with weights w_j exp(-|x_j - y|^2 / 2 s^2), m and p the means of u_j
// and x_j - y, D and S their covariances, e a ridge. So a sac shrinks with its nose.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/tri_mesh.hpp"
#include "model/template_walls.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct InnerSettings {
    bool exclude = true;  ///< walls are excluded from correspondence [A]
    bool carry = true;    ///< and go with the skin [A]
    WallSettings walls;   ///< how they are found
    // Carried
    double reach_mm = 15;  ///< mm, > 0: farther skin does not take part [J]
    double spread_mm = 6;  ///< mm, > 0: s [J]
    double blend_mm = 2;   ///< mm, > 0: from the skin inwards until a wall is carried whole [J]
    double ridge_mm2 = 4;  ///< mm^2, > 0: e [J]
    double near_path_mm = 20, far_path_mm = 40;  ///< mm: along the surface from the skin that the
                                                 ///< wall hangs on; skin takes part whole, fading,
                                                 ///< and not, so that the inside of a lip goes with
                                                 ///< its own lip [J]
    double fallback = 1e-3;  ///< > 0: weight of all other open skin, which counts where nothing
                             ///< along the surface is within reach [J]
};

/// find_walls(), or all 0 when settings.exclude is false. O(V log F).
std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const InnerSettings& settings,
                                              const Context& context);

/// Moves the inner vertices with the open skin that they hang on. `template_mesh`: at rest, in its
/// own frame; `rest`: the same in the frame of `places`, perhaps of another form.
void carry_inner(const TriMesh& template_mesh, const VertexRings& rings, const Points& rest,
                 const std::vector<std::uint8_t>& inner, const InnerSettings& settings,
                 Points& places, const Context& context);

}  // namespace mien
