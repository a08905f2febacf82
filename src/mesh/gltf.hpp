// glTF 2.0 meshes with morph targets: an expression model's blendshapes in one file.
#pragma once

#include <string>
#include <vector>

#include "mesh/formats.hpp"

namespace mien {

/// A named change of a mesh's vertices.
struct MorphTarget {
    std::string name;  ///< UTF-8
    Points offsets;    ///< #V x 3, mm, what is added at weight 1
};

/// A mesh with its morph targets.
struct MorphMesh {
    TriMesh mesh;
    std::vector<MorphTarget> targets;
};

/// Reads a .glb or .gltf file with its targets; those that several primitives have are joined by
/// number. A file without targets gives none. Errors as read_mesh_file().
MorphMesh read_morph_mesh(const std::string& path, const Context& context);

/// Writes one .glb file with named targets. Throws invalid_argument for another extension,
/// mismatch for offsets of another number of vertices, otherwise as write_mesh_file().
void write_morph_mesh(const std::string& path, const TriMesh& mesh,
                      const std::vector<MorphTarget>& targets, const Context& context);

namespace formats {

/// `targets` may be null: they are not read then.
TriMesh read_gltf_document(const Source& source, std::vector<MorphTarget>* targets,
                           const Context& context);
void write_glb_document(Target& target, const TriMesh& mesh,
                        const std::vector<MorphTarget>& targets, const Context& context);

}  // namespace formats
}  // namespace mien
