// More than one face in a scan: two surfaces over each other (two visits merged into one file, a
// double shell), or two persons side by side. A fit follows one of them, and looks good.
#pragma once

#include <string>

#include "mesh/tri_mesh.hpp"

namespace mien {

/// [J]; tags in brackets: registration/settings.hpp.
struct PieceSettings {
    bool enabled = true;
    double as_large = 0.5;  ///< 0 to 1: of the largest piece's triangles; smaller ones are clothes
                            ///< and furniture
    double over = 0.6;      ///< 0 to 1: share of their common box that both fill: strips of two
                            ///< cameras share less
    double beside = 0.05;   ///< 0 to 1: of the common box; pieces that share less are apart
    Index least_triangles = 200;  ///< >= 1: of a piece that can be a face
};

/// What the two largest pieces of a scan are to each other; empty texts: nothing of note.
struct PieceFindings {
    std::string doubt;  ///< they lie over each other: which one the fit follows is chance
    std::string note;   ///< they lie apart
};

/// `mesh` cleaned, mm. O(F).
PieceFindings find_pieces(const TriMesh& mesh, const PieceSettings& settings);

}  // namespace mien
