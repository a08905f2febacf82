// The walls of a template that no scanner sees: the sacs of nostrils, the insides of lips and lids.
// They depend on the template alone, so a model file keeps them.
//
// Found by balls that rest on a vertex: on open skin a ball touches nothing else, between two walls
// it meets the other one. And by rays: open skin sees out.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct WallSettings {
    std::array<double, 6> probes_mm{{1, 2, 3, 4.5, 6, 8}};  ///< mm, > 0, ascending: radii [J]
    double touch = 0.7;     ///< 0 to 1, radii: a wall nearer to the ball's middle is met [J]
    double facing = -0.4;   ///< cosine: and faces the vertex [J]
    int rays = 16;          ///< >= 1: about the normal, as many as their cosine weighs [J]
    int open_rays = 4;      ///< 0 to rays: so many that lead out make a vertex open skin [J]
    double sight_mm = 60;   ///< mm, > 0: length of a ray [J]
    double lift_mm = 0.05;  ///< mm, > 0: a ray begins so far above the surface [J]
};

/// #V, 1 where a wall faces another one and hardly a ray leads out, 0 on open skin. O(V log F).
std::vector<std::uint8_t> find_walls(const TriMesh& mesh, const WallSettings& settings,
                                     const Context& context);

/// What find_walls() read, in 16 hexadecimal digits: the rule, its settings, the template. Walls
/// that were found for another one are not these. O(V + F), under a millisecond.
std::string walls_key(const TriMesh& mesh, const WallSettings& settings);

}  // namespace mien
