// The walls that no scanner sees: the sacs of nostrils, the insides of lips and lids. They lie
// against each other or behind the skin, so the closest point of a scan is seldom theirs, and a
// prior along the surface carries them little with the skin before them: left alone, a nostril's
// sac ends outside of a slim nose.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"
#include "registration/refine.hpp"

namespace mien {

/// #V, 1 where a wall of the template faces another one within 8 mm and hardly a ray leads out, 0
/// on open skin.
std::vector<std::uint8_t> find_inner_vertices(const TriMesh& mesh, const Context& context);

/// Moves the inner vertices with the open skin that they hang on, by a linear regression of its
/// displacements (so that a sac shrinks with its nose), Gaussian in the straight distance; first of
/// all over the skin within 20 to 40 mm along the surface, so that the inside of a lip goes with
/// its own lip; blended in over the first 2 mm. `template_mesh`: at rest, in its own frame; `rest`:
/// the same in the frame of `places`, perhaps of another form.
void carry_inner(const TriMesh& template_mesh, const VertexRings& rings, const Points& rest,
                 const std::vector<std::uint8_t>& inner, Points& places, const Context& context);

}  // namespace mien
