// Between mesh_file.cpp and the formats: each reader gets the whole file's bytes, each writer a
// file that is committed by its caller. Readers throw without the path; mesh_file.cpp adds it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/file.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien::formats {

TriMesh read_ply(const FileBytes& bytes, const Context& context);
TriMesh read_obj(const FileBytes& bytes, const Context& context);
TriMesh read_stl(const FileBytes& bytes, const Context& context);
TriMesh read_off(const FileBytes& bytes, const Context& context);

void write_ply(AtomicFile& file, const TriMesh& mesh, const Context& context);
void write_obj(AtomicFile& file, const TriMesh& mesh, const Context& context);
void write_stl(AtomicFile& file, const TriMesh& mesh, const Context& context);
void write_off(AtomicFile& file, const TriMesh& mesh, const Context& context);

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
    void add(const std::uint32_t* corners, std::size_t count, const std::uint32_t* texture);
    void finish(TriMesh& mesh, std::vector<float>& texture_values);

  private:
    std::vector<std::uint32_t> triangles_, texture_triangles_;
    bool any_texture_ = false;
};

/// Colours as numbers in 0..1 or 0..255 (decided by the largest of them) to bytes.
Colors colors_from_numbers(const std::vector<float>& rgb);

/// Appends a blank and the number, with so many significant digits.
void append_number(std::string& out, double value, int digits = 9);
void append_number(std::string& out, std::uint64_t value);

/// Checks that a coordinate survives as float32.
void check_float_range(const TriMesh& mesh);

}  // namespace mien::formats
