// The seam between TriangleTree and its search loops, which are compiled once per instruction set
// (base/lanes.inc): plain data and plain functions only. The loops find candidates in float, with
// bounds that never exclude a right one; a function of the tree judges each candidate in double,
// the same one for every instruction set. So the answers are the same to the bit, whichever loops
// ran.
#pragma once

#include <cstdint>

namespace mien::tree_search {

constexpr int kWidth = 8;  // children of a node, triangles of a block

/// Boxes of the children, coordinate by coordinate, wider than what they hold by the rounding that
/// a search within them makes: relative to the box's own largest coordinate, so that one far vertex
/// does not widen the others.
struct alignas(32) Node {
    float lower[3][kWidth], upper[3][kWidth];
};

/// Four planes for each triangle, n . x - offset: its own, and through each edge the one at right
/// angles to it, which points away from the triangle. Beyond triangles without area, whose planes
/// are all zero, a squared distance is at least plane^2 + max(0, edges)^2, and above and beside an
/// edge just that.
struct alignas(32) Block {
    float normal[4][3][kWidth], offset[4][kWidth];
    float size[kWidth];  ///< largest coordinate of the triangle, to which its rounding is relative
};

/// Judges one primitive against what was found so far. Returns the new reach: for points a squared
/// distance, for rays the largest t of interest.
using Judge = double (*)(void* search, std::uint32_t slot);

struct Tree {
    const Node* nodes;
    const Block* blocks;  ///< null for a cloud: the lowest children are points
    const std::uint32_t*
        level_begin;  ///< first node of each level, the level above the blocks first
    std::uint32_t num_levels;
    float extent;  ///< largest coordinate; queries and boxes are relative to the middle of the tree
};

struct Loops {
    /// Judges every primitive that may lie within sqrt(reach) of the point, near ones first.
    void (*around)(const Tree& tree, const double point[3], double reach, Judge judge,
                   void* search);
    /// Judges every triangle that origin + t direction may cross at 0 <= t <= reach.
    void (*along)(const Tree& tree, const double origin[3], const double direction[3], double reach,
                  Judge judge, void* search);
};

const Loops& portable_loops();
const Loops& avx2_loops();

}  // namespace mien::tree_search
