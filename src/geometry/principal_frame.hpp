// A frame that a surface has of itself: turned with the surface, it turns alike. What starts from
// it ends at the same place however the surface was given.
#pragma once

#include "base/types.hpp"

namespace mien {

/// Right-handed; columns are the directions in which the surface spreads most, second and least.
/// Their signs: of the two directions along which its third moments are largest, towards the side
/// that reaches farther; the last follows. By area; points without triangles count one each.
/// Directions of equal spread are any of their plane. Throws Status::no_solution for vertices that
/// are not finite. O(V + F).
Matrix3 principal_frame(const Points& vertices, const Triangles& triangles);

}  // namespace mien
