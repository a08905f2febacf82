// A triangle mesh as plain arrays. A scan may be anything a scanner makes: open, in pieces, not
// manifold. Only what check_mesh() promises may be assumed of it.
#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"

namespace mien {

struct TriMesh {
    Points vertices;              ///< #V x 3, mm
    Triangles triangles;          ///< #F x 3; may be empty (a point cloud)
    Colors colors;                ///< #V x 3 or empty
    TextureCoordinates texture;   ///< #T x 2 or empty
    Triangles texture_triangles;  ///< #F x 3 indices into `texture`, or empty
};

/// Named vertex of a template.
struct Landmark {
    std::string name;
    std::uint32_t vertex = 0;
};

/// Named point on a scan, mm.
struct LandmarkPoint {
    std::string name;
    Vector3 point = Vector3::Zero();
};

/// Named vertex set of a template.
struct Zone {
    std::string name;
    std::vector<std::uint32_t> vertices;
};

/// Throws Status::invalid_mesh with the first offending index: no vertex, a coordinate that is not
/// finite, a triangle index out of range, attribute arrays of another length.
void check_mesh(const TriMesh& mesh, const char* what);

}  // namespace mien
