// Wavefront MTL: newmtl, Kd, map_Kd. Other maps (gloss, bumps) are no colour of the skin.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/formats.hpp"

namespace mien::formats {

struct LibraryMaterial {
    std::string name;
    std::array<float, 3> color{{1.f, 1.f, 1.f}};  ///< Kd
    std::string image;                            ///< map_Kd without its options, or empty
};

/// Appends the materials of the libraries that an OBJ names on one line (one name with blanks, or
/// several). A missing library is a warning in the log.
void read_material_library(const Source& source, const std::string& names,
                           std::vector<LibraryMaterial>& materials, const Context& context);

/// Of the text of one library.
void parse_material_library(const char* begin, const char* end,
                            std::vector<LibraryMaterial>& materials);

/// Writes the library and the images beside the target, appends the line that names it to `out`,
/// and returns the materials' names as they stand there, each its own.
std::vector<std::string> write_material_library(Target& target, const TriMesh& mesh,
                                                std::string& out, const Context& context);

}  // namespace mien::formats
