// What both kinds of VTK PolyData files hold: points, cells and named arrays of a type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/formats.hpp"
#include "mesh/ply_values.hpp"

namespace mien::formats {

/// "float", "unsigned_char", "vtktypeint64" (legacy) or "Float32", "UInt8" (XML), any case.
/// Bytes of an element; 0 for another word.
struct VtkType {
    PlyType type = PlyType::f32;
    bool wide = false;  ///< 64-bit integers, which PLY does not have
    bool wide_unsigned = false;
    std::size_t bytes() const { return wide ? 8 : ply_type_bytes(type); }
};
bool parse_vtk_type(const std::string& word, VtkType& type);

/// The value at `raw`.
double load_vtk(const char* raw, const VtkType& type, bool swapped);

/// A PolyData as it is read; both readers end in finish().
struct VtkPolyData {
    std::vector<double> points;  ///< 3 #V
    std::vector<float> colors;   ///< 3 #V or empty; 0..255
    std::vector<float> texture;  ///< 2 #V or empty
    PolygonSink polygons;

    /// Cells as offsets (the end of each) into connectivity, or as in old files: the number of
    /// corners before each cell. Strips alternate their direction. Throws for a number that is no
    /// vertex's.
    void add_cells(const std::vector<double>& offsets, const std::vector<double>& connectivity,
                   bool strips);
    /// `name` and the type of a point array tell whether it is a colour or texture coordinates.
    void add_point_array(const std::string& name, const VtkType& type, std::size_t columns,
                         const std::vector<double>& values, bool named_as_texture,
                         bool named_as_color);
    TriMesh finish();
};

}  // namespace mien::formats
