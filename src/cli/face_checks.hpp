// What measuring commands look at before they print numbers of faces that do not belong together:
// other triangles, other frames, mirror images, other units, inside out.
#pragma once

#include <string>
#include <vector>

#include "commands.hpp"

namespace mien::cli {

/// One face of a measurement and the file that it was read from.
struct NamedFace {
    const Mesh& mesh;
    const std::string& path;
};

/// Throws std::runtime_error unless both faces have the same triangles, wherever each begins: the
/// same number of vertices alone does not put them in correspondence. Cost O(triangles).
void expect_same_triangles(const NamedFace& before, const NamedFace& after);

/// Throws std::runtime_error when the face is wound inside out: gains would be printed as losses.
void expect_outside_out(const Session& session, const NamedFace& face);

/// A warning on stderr when a mesh is so small or so large that its file is hardly in mm.
void warn_of_unit(const Session& session, const NamedFace& face);

/// Warnings on stderr about two faces in correspondence that do not lie in one frame, that mirror
/// one another, or that are the same; returned as they were printed. `aligned`: one was laid onto
/// the other already. Cost O(vertices).
std::vector<std::string> warn_of_frames(const Session& session, const NamedFace& before,
                                        const NamedFace& after, bool aligned);

/// What two visits have in common.
struct VisitPair {
    double stable_rms_mm = 0;  ///< between their stable zones, once these lie on each other
    double size_ratio = 1;     ///< of the later face to the first
};

/// How much larger the second face is, by the root mean square distance of the vertices that count
/// (one byte each, 1) from their centre; 1 where fewer than a hundred do. O(#V).
double size_ratio(const Mesh& first, const Mesh& second, const std::vector<char>& counts);

/// What is wrong with two visits that a report compares. Throws std::runtime_error for other units
/// and for mirror images, whose volumes would be read as changes; returns warnings, which were
/// printed, for one face twice, for stable zones that stay apart as those of two persons do, and
/// for faces of two sizes, which volumes would tell as swelling or loss all over.
std::vector<std::string> check_visits(const Session& session, const NamedFace& first,
                                      const NamedFace& later, const VisitPair& pair);

}  // namespace mien::cli
