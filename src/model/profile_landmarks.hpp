// Landmarks of the middle of the face that a template's shape defines by itself: glabella, nasion,
// columella, sublabiale and pogonion, the bulges and hollows of its profile. A template of 68
// points lacks them, and the field's profile measurements start there.
//
// The profile is the template's midline (vertices that are their own mirror images about x = 0)
// seen from the side, y up and z forward, between four of the 68 points. Found once, on the
// template; every fitted face has them at the same vertices.
//   nasion      least z between the nasal tip and kAboveEyes over the eyes: the hollow of the root
//   glabella    greatest z from there to kAboveNasion higher
//   columella   farthest from the chord of tip and base, on the profile between them
//   pogonion    greatest z between the chin's lowest point and half the way to the lower lip's
//   border sublabiale  least z from there to the lower lip's border
// On a flat hollow a vertex more or less changes z by little: such a landmark is no better placed
// than the template's edges are long.
#pragma once

#include <vector>

#include "mesh/tri_mesh.hpp"

namespace mien {

/// Those that are not among `known` already, whatever their spelling there. Throws
/// Status::not_found when `known` lacks a point that the search starts from (the 68-point names
/// nose_bridge_3, nose_base_2, mouth_outer_09, jaw_08, eye_right_3, eye_left_0), Status::mismatch
/// for a vertex that the template does not have, and Status::invalid_mesh for a template that is
/// not symmetric about x = 0 or has no midline there. O(#V log #V).
std::vector<Landmark> profile_landmarks(const TriMesh& template_mesh,
                                        const std::vector<Landmark>& known);

}  // namespace mien
