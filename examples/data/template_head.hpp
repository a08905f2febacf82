// The template: the sculpture as a mesh with open eyes, an open mouth slit and an open neck, plus
// what the face builder needs to know of each vertex.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "numbers.hpp"

namespace mien::demo {

/// Which soft edge a vertex belongs to.
enum class Rim : unsigned char { none, lid_upper, lid_lower, lip_upper, lip_lower, lip_corner };

struct TemplateHead {
    std::vector<V3> points;                     ///< mm; mirror-symmetric in x
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
    std::vector<int> mirror;                    ///< the vertex on the other side
    std::vector<Rim> rim;                       ///< edge of a lid or lip, inner rows included
    std::vector<unsigned char> rim_row;         ///< 0 on the skin's edge, growing inwards
    std::vector<std::vector<int>> neighbours;   ///< by edges, ascending
    std::vector<std::pair<std::string, int>> landmarks;           ///< 68, Multi-PIE order
    std::vector<std::pair<std::string, std::vector<int>>> zones;  ///< "face" first
    std::vector<std::array<unsigned char, 3>> colors;
    std::vector<int> lips;  ///< vermilion
};

/// Made anew by each call (about a second); the same bits everywhere.
TemplateHead make_template_head();

}  // namespace mien::demo
