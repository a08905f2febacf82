// Landmarks as the programs write that people pick them with. A file is told by its content, its
// name decides only where the content leaves it open (.pts, .csv, .txt).
//
//   json      {"points": {name: [x, y, z]}} on a scan, {"vertices": {name: index}} on a template
//   mrk.json  3D Slicer markups: positionStatus, coordinateSystem LPS or RAS, coordinateUnits
//   fcsv      3D Slicer's older fiducials, RAS unless the file says LPS
//   pp        MeshLab's picked points
//   pts       lines x y z, or name x y z; iBUG's header is understood
//   ljson     menpo, versions 1 to 3
//   csv, txt  name,x,y,z or name,vertex, or vertex numbers alone; , ; tab or blank between them
//
// Slicer's coordinates are handed out as LPS, the frame that Slicer writes mesh files in.
// Landmarks without a name get their number in the file, from "1".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// One landmark of a file: where it was picked, which vertex it is, or neither.
struct Mark {
    enum class Where : std::int32_t { not_picked = 0, place = 1, vertex = 2 };
    std::string name;
    Where where = Where::not_picked;
    Vector3 point = Vector3::Zero();  ///< in the file's unit; zero unless `where` is place
    std::uint32_t vertex = 0;         ///< 0 unless `where` is vertex
};

/// What a landmark file says.
struct LandmarkFile {
    std::string format;       ///< "json", "mrk.json", "fcsv", "pp", "pts", "ljson", "csv"
    std::string system;       ///< "LPS", "RAS" as the file says it, or empty
    double unit_to_mm = 0;    ///< as the file says it; 0: it does not
    std::vector<Mark> marks;  ///< in the file's order, names unique
};

/// Reads a landmark file of any of the formats. Not picked are: null, not a number, a status other
/// than "defined", an inactive point, and placeholders (the same place with three equal
/// coordinates, as 0 0 0, more than once; any place more than twice). Throws Status::io, bad_format
/// with the line or name, invalid_argument for a name that comes twice. O(size).
LandmarkFile read_landmark_file(const std::string& path, const Context& context);

/// The same from memory; `path` only tells the extension and is named in errors.
LandmarkFile parse_landmarks(const char* data, std::size_t size, const std::string& path);

/// Writes by extension: .json, .mrk.json (LPS), .fcsv (LPS), .pp, .pts, .ljson, .csv. Points that
/// were not picked are written as the format says so, and left out of .pts and .ljson keeps them as
/// null. The unit is kept where the format can name it (.json, .mrk.json, .csv); .fcsv is brought
/// to mm, as Slicer takes it for. Vertex numbers go to .json and .csv only. Throws Status::io,
/// bad_format (unknown extension), invalid_argument (what the format cannot hold, with the name).
void write_landmark_file(const std::string& path, const LandmarkFile& given);

/// Marks the placeholders among the places as not picked and says how many there were.
std::size_t drop_placeholders(std::vector<Mark>& marks);

namespace landmark_formats {
// One parser per family; each leaves placeholders and doubled names to parse_landmarks().
LandmarkFile read_json(const char* data, std::size_t size, const std::string& path);
LandmarkFile read_picked_points(const char* data, std::size_t size, const std::string& path);
LandmarkFile read_fiducial_csv(const char* data, std::size_t size, const std::string& path);
LandmarkFile read_table(const char* data, std::size_t size, const std::string& path,
                        const char* format);

/// "", "nan", "-1.#IND", "n/a", "missing", ... in any case.
bool means_not_picked(const std::string& text);
/// mm per unit for "mm", "millimetre", "cm", ... in any case; 0 for a name that is none.
double unit_of_name(const std::string& name);
/// Lower case ASCII.
std::string lower(std::string text);
}  // namespace landmark_formats

}  // namespace mien
