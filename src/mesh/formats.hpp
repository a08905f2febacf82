// Between mesh_file.cpp and the formats: each reader gets the whole file's bytes, each writer a
// file that is committed by its caller. Readers throw without the path; mesh_file.cpp adds it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/file.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien::formats {

/// A mesh file's bytes.
struct Source {
    FileBytes bytes;
    std::string path;  ///< empty: from memory, without files beside it
};

/// A mesh file under construction, and the files beside it, which are committed first.
struct Target {
    AtomicFile& file;
    std::string path;
    std::vector<std::unique_ptr<AtomicFile>> companions;
};

TriMesh read_ply(const Source& source, const Context& context);
TriMesh read_obj(const Source& source, const Context& context);
TriMesh read_stl(const Source& source, const Context& context);
TriMesh read_off(const Source& source, const Context& context);
TriMesh read_gltf(const Source& source, const Context& context);
TriMesh read_vtk(const Source& source, const Context& context);
TriMesh read_vtp(const Source& source, const Context& context);
TriMesh read_xyz(const Source& source, const Context& context);

void write_ply(Target& target, const TriMesh& mesh, const Context& context);
void write_obj(Target& target, const TriMesh& mesh, const Context& context);
void write_stl(Target& target, const TriMesh& mesh, const Context& context);
void write_off(Target& target, const TriMesh& mesh, const Context& context);
void write_glb(Target& target, const TriMesh& mesh, const Context& context);

/// The size is exactly what the header's number of triangles needs: no text has such a size.
bool is_exact_binary_stl(const char* data, std::size_t size);
/// Text that begins with "solid" in any case, and has a facet or its end soon after.
bool is_ascii_stl(const char* data, std::size_t size);

/// Cancellation is looked at once per so many elements.
constexpr std::size_t kCancelInterval = 1 << 16;

/// Hands `out` over to the file, and asks for cancellation, whenever it has grown past
/// kCancelInterval bytes.
void write_when_long(AtomicFile& file, std::string& out, const Context& context);

/// Marks a corner without texture coordinate in PolygonSink.
constexpr std::uint32_t kNoTexture = 0xffffffffu;

/// Collects polygons as triangle fans around their first corner; polygons of fewer than three
/// corners (points, lines) are dropped. finish() writes the mesh's triangle arrays; corners
/// without a texture coordinate, in a mesh that has some, share one appended (0, 0).
class PolygonSink {
  public:
    /// Room for so many triangles, which the file must be able to hold.
    void reserve(std::size_t num_triangles) { triangles_.reserve(3 * num_triangles); }
    void add(const std::uint32_t* corners, std::size_t count, const std::uint32_t* texture,
             std::uint32_t material = 0);
    bool any() const { return !triangles_.empty(); }
    void finish(TriMesh& mesh, std::vector<float>& texture_values);

  private:
    std::vector<std::uint32_t> triangles_, texture_triangles_, materials_;
    bool any_texture_ = false, any_material_ = false;
};

/// Colours as numbers in 0..1 or 0..255 (decided by the largest of them) to bytes.
Colors colors_from_numbers(const std::vector<float>& rgb);

/// The largest step between neighbouring numbers that a written coordinate may have, mm.
constexpr double kCoordinateStep_mm = 1e-3;

/// True when float32 would move a coordinate of this mesh by more than half of that step: a scan in
/// a site's grid, kilometres from the origin.
bool needs_double(const TriMesh& mesh);

/// Appends a blank and the number, with so many significant digits.
void append_number(std::string& out, double value, int digits = 9);
/// The same for a coordinate: nine digits, or all where nine are too coarse.
void append_coordinate(std::string& out, double value);
void append_number(std::string& out, std::uint64_t value);

/// Checks that a coordinate survives as float32.
void check_float_range(const TriMesh& mesh);

}  // namespace mien::formats
