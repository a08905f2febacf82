// Files beside a mesh file: the images and material libraries that it names.
#pragma once

#include <string>
#include <vector>

#include "mesh/formats.hpp"

namespace mien::formats {

/// Reads the file that a mesh names, from the mesh's folder: as named where that is a path below
/// this folder, else by the name's last part (exporters write their own machine's paths). False,
/// with a warning in the log, when there is none; what a file names is never looked for elsewhere.
bool read_companion(const Source& source, const std::string& reference, FileBytes& bytes,
                    const Context& context);

/// Adds the image that `reference` names and returns its number, or -1 where it cannot be read.
/// References that were asked for before give the same number; `known` holds them.
struct KnownImages {
    std::vector<std::string> references;
    std::vector<std::int32_t> numbers;
};
std::int32_t add_companion_image(TriMesh& mesh, const Source& source, const std::string& reference,
                                 KnownImages& known, const Context& context);

/// Writes the mesh's images beside the target and returns their file names in order. An image keeps
/// its name; where a file of this name with other bytes exists already, the target's own name goes
/// in front. Pixels become a PNG.
std::vector<std::string> write_companion_images(Target& target, const TriMesh& mesh,
                                                const Context& context);

/// "scan" of "folder/scan.obj".
std::string stem_of(const std::string& path);

/// The part of a path, of any system's, after its last separator.
std::string last_part(const std::string& path);

}  // namespace mien::formats
