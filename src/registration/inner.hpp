// The walls that no scanner sees: the sacs of nostrils, the insides of lips and lids. They lie
// against each other or behind the skin, so the closest point of a scan is seldom theirs, and a
// prior along the surface carries them little with the skin before them: left alone, a nostril's
// sac ends outside of a slim nose.
//
// Moved: u(y) = m - D (S + e I)^-1 p, a linear regression of the open skin's displacements u_j
// about the wall's vertex y; with weights w_j exp(-|x_j - y|^2 / 2 s^2), m and p the means of u_j
// and x_j - y, D and S their covariances, e a ridge. So a sac shrinks with its nose.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct InnerSettings {
    bool exclude = true;  ///< walls are excluded from correspondence [A]
    bool carry = true;    ///< and go with the skin [A]
    // Found by balls that rest on a vertex: on open skin a ball touches nothing else, between two
    // walls it meets the other one.
    std::array<double, 6> probes_mm{{1, 2, 3, 4.5, 6, 8}};  ///< mm, > 0, ascending: radii [J]
    double touch = 0.7;     ///< 0 to 1, radii: a wall nearer to the ball's middle is met [J]
    double facing = -0.4;   ///< cosine: and faces the vertex [J]
    int rays = 16;          ///< >= 1: about the normal, as many as their cosine weighs [J]
    int open_rays = 4;      ///< 0 to rays: so many that lead out make a vertex open skin [J]
    double sight_mm = 60;   ///< mm, > 0: length of a ray [J]
    double lift_mm = 0.05;  ///< mm, > 0: a ray begins so far above the surface [J]
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

/// #V, 1 where a wall of the template faces another one and hardly a ray leads out, 0 on open skin;
/// all 0 when settings.exclude is false. O(V log F).
std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const InnerSettings& settings,
                                              const Context& context);

/// Moves the inner vertices with the open skin that they hang on. `template_mesh`: at rest, in its
/// own frame; `rest`: the same in the frame of `places`, perhaps of another form.
void carry_inner(const TriMesh& template_mesh, const VertexRings& rings, const Points& rest,
                 const std::vector<std::uint8_t>& inner, const InnerSettings& settings,
                 Points& places, const Context& context);

}  // namespace mien
