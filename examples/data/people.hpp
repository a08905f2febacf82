// Inside of the face builder: identity directions and expressions over the template.
#pragma once

#include <string>
#include <vector>

#include "demo_faces.hpp"
#include "template_head.hpp"

namespace mien::demo {

/// The template's vertices followed by points inside the head that move along with identity.
struct Anatomy {
    TemplateHead head;
    std::vector<V3> rest;     ///< template vertices, then eyeball left, right, hinge left, right
    std::vector<double> jaw;  ///< 0..1 per vertex: how much it follows the lower jaw
    std::vector<V3> normals;  ///< of the template
    int eyeball[2] = {0, 0}, hinge[2] = {0, 0};  ///< indices into `rest`; left, right
    int count() const { return static_cast<int>(head.points.size()); }
};
Anatomy make_anatomy();

struct IdentityBasis {
    std::vector<std::string> names;
    std::vector<std::vector<V3>> directions;  ///< over Anatomy::rest
};
IdentityBasis make_identity_basis(const Anatomy& anatomy);

/// Numbers of Person::places: three for each of twelve features.
constexpr int kNumPlaces = 36;

/// The person without expression, over Anatomy::rest.
std::vector<V3> neutral_shape(const Anatomy& anatomy, const IdentityBasis& basis,
                              const Person& person);

/// Vertices (without the inner points) of one expression on a neutral shape.
std::vector<V3> express(const Anatomy& anatomy, const std::vector<V3>& neutral,
                        const Person& person, int expression);

std::vector<V3> normals_of(const std::vector<V3>& points,
                           const std::vector<std::array<int, 3>>& triangles);

}  // namespace mien::demo
