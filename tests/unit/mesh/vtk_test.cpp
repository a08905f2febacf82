// VTK PolyData, legacy and XML, and clouds of points as text.
#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "mesh/image.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_meshes.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

void expect_square(const TriMesh& mesh, bool appearance) {
    EXPECT_EQ(mesh.vertices, points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}}));
    if (!appearance) return;
    ASSERT_EQ(mesh.colors.rows(), 4);
    EXPECT_EQ(mesh.colors.row(3), (Eigen::Matrix<std::uint8_t, 1, 3>(9, 8, 7)));
    EXPECT_EQ(mesh.texture_triangles, mesh.triangles);
    EXPECT_EQ(mesh.texture.row(2), Eigen::RowVector2f(1, 1));
}

template <typename T>
std::string big(const std::vector<T>& values) {
    std::string out;
    for (T value : values) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof value);
        for (std::size_t k = sizeof(T); k-- > 0;) out += raw[k];
    }
    return out;
}

template <typename T>
std::string little(const std::vector<T>& values) {
    return std::string(reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size());
}

const std::vector<float> kVtkPoints = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<float> kTexture = {0, 0, 1, 0, 1, 1, 0, 1};
const std::vector<std::uint8_t> kColors = {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7};

const std::string kVtkAscii =
    "# vtk DataFile Version 3.0\na face\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
    "0 0 0 1 0 0 1 1 0\n0 1 0\nVERTICES 1 2\n1 0\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"
    "CELL_DATA 2\nSCALARS label int 1\nLOOKUP_TABLE default\n1 2\nPOINT_DATA 4\n"
    "NORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 nan\nTEXTURE_COORDINATES uv 2 float\n"
    "0 0 1 0 1 1 0 1\nFIELD FieldData 1\nRGB 3 4 unsigned_char\n255 0 0 0 255 0 0 0 255 9 8 7\n";

std::string binary_legacy(bool fifth) {
    std::string file = std::string("# vtk DataFile Version ") + (fifth ? "5.1" : "4.2") +
                       "\nvtk output\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n" +
                       big(kVtkPoints) + "\n";
    if (fifth)
        file += "METADATA\nINFORMATION 0\n\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n" +
                big<std::int64_t>({0, 3, 6}) + "\nCONNECTIVITY vtktypeint64\n" +
                big<std::int64_t>({0, 1, 2, 0, 2, 3}) + "\n";
    else
        file += "POLYGONS 2 8\n" + big<std::int32_t>({3, 0, 1, 2, 3, 0, 2, 3}) + "\n";
    return file + "POINT_DATA 4\nSCALARS colour unsigned_char 3\nLOOKUP_TABLE default\n" +
           little(kColors) + "\nTEXTURE_COORDINATES t 2 float\n" + big(kTexture) + "\n";
}

TEST(Vtk, LegacyFilesOfEveryEncodingAreRead) {
    expect_square(parse_mesh(kVtkAscii, "vtk"), true);
    expect_square(parse_mesh(binary_legacy(false), "vtk"), true);
    expect_square(parse_mesh(binary_legacy(true), "vtk"), true);
    EXPECT_NE(
        parse_message("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n", "vtk")
            .find("UNSTRUCTURED_GRID"),
        std::string::npos);
}

TEST(Vtk, StripsAlternateTheirDirection) {
    const TriMesh mesh = parse_mesh(
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
        "0 0 0 1 0 0 0 1 0 1 1 0\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n",
        "vtk");
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {2, 1, 3}}));
}

std::string vtp_of(const std::string& arrays_open, const std::string& points,
                   const std::string& polys, const std::string& data, const std::string& tail) {
    return "<?xml version=\"1.0\"?>\n<!-- a <face> -->\n<VTKFile type=\"PolyData\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" " +
           arrays_open +
           ">\n<PolyData>\n<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfPolys=\"2\">\n"
           "<PointData TCoords=\"uv map\">" +
           data + "</PointData><CellData></CellData><Points>" + points +
           "</Points><Verts></Verts>" + "<Polys>" + polys + "</Polys></Piece></PolyData>" + tail +
           "</VTKFile>\n";
}

std::string array_of(const std::string& type, const std::string& name, int columns,
                     const std::string& format, const std::string& content) {
    return "<DataArray type='" + type + "' Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(columns) + "\" " + format + ">" + content + "</DataArray>\n";
}

std::string ascii_vtp() {
    const std::string format = "format=\"ascii\"";
    return vtp_of("", array_of("Float32", "Points", 3, format, "0 0 0 1 0 0\n1 1 0 0 1 0 "),
                  array_of("Int64", "connectivity", 1, format, "0 1 2 0 2 3") +
                      array_of("Int64", "offsets", 1, format, "3 6"),
                  array_of("UInt8", "RGB", 3, format, "255 0 0 0 255 0 0 0 255 9 8 7") +
                      array_of("Float32", "uv map", 2, format, "0 0 1 0 1 1 0 1"),
                  "");
}

/// Raw data after the tags, each array with its length in front.
std::string appended_vtp() {
    std::string data;
    std::string offsets[5];
    int next = 0;
    for (const std::string& array :
         {little(kColors), little(kTexture), little(kVtkPoints),
          little<std::int64_t>({0, 1, 2, 0, 2, 3}), little<std::int64_t>({3, 6})}) {
        offsets[next++] = "format=\"appended\" offset=\"" + std::to_string(data.size()) + "\"";
        data += little<std::uint32_t>({static_cast<std::uint32_t>(array.size())}) + array;
    }
    return vtp_of("header_type=\"UInt32\"", array_of("Float32", "Points", 3, offsets[2], ""),
                  array_of("Int64", "connectivity", 1, offsets[3], "") +
                      array_of("Int64", "offsets", 1, offsets[4], ""),
                  array_of("UInt8", "RGB", 3, offsets[0], "") +
                      array_of("Float32", "uv map", 2, offsets[1], ""),
                  "<AppendedData encoding=\"raw\">\n_" + data + "\n</AppendedData>");
}

/// Arrays compressed by zlib in blocks of 32 bytes, as base64 text.
const char* const kCompressed[] = {
    "AQAAACAAAAAMAAAAEQAAAA==eJz7z8DA8B+EOTnYARgmAxY=",
    "AQAAACAAAAAAAAAAEQAAAA==eJxjYICBBnsEjWADACL0Av0=",
    "AgAAACAAAAAQAAAAEQAAAA8AAAA=eJxjYEAGDfao7AZ7ABLJAj54nGNggIEGexAJAARLAMA=",
    "AgAAACAAAAAQAAAAEQAAAA4AAAA=eJxjYIAARijNxIAKAABYAAR4nGNigABmKA0AAEgABg==",
    "AQAAACAAAAAQAAAADgAAAA==eJxjZoAANigNAABwAAo=",
};

std::string compressed_vtp(bool appended) {
    std::string format[5], content[5], data;
    for (int k = 0; k < 5; ++k) {
        format[k] = appended ? "format=\"appended\" offset=\"" + std::to_string(data.size()) + "\""
                             : "format=\"binary\"";
        content[k] = appended ? "" : std::string("\n  ") + kCompressed[k] + "\n";
        data += kCompressed[k];
    }
    return vtp_of("header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"",
                  array_of("Float32", "Points", 3, format[2], content[2]),
                  array_of("Int64", "connectivity", 1, format[3], content[3]) +
                      array_of("Int64", "offsets", 1, format[4], content[4]),
                  array_of("UInt8", "RGB", 3, format[0], content[0]) +
                      array_of("Float32", "uv map", 2, format[1], content[1]),
                  appended ? "<AppendedData encoding=\"base64\">_" + data + "</AppendedData>" : "");
}

TEST(Vtp, XmlFilesOfEveryEncodingAreRead) {
    expect_square(parse_mesh(ascii_vtp(), "vtp"), true);
    expect_square(parse_mesh(appended_vtp(), "vtp"), true);
    if (!images_are_decoded()) GTEST_SKIP() << "built without zlib";
    expect_square(parse_mesh(compressed_vtp(false), "vtp"), true);
    expect_square(parse_mesh(compressed_vtp(true), "vtp"), true);
}

TEST(Vtp, EveryTruncatedLengthAndFlippedBitIsHandled) {
    for (const std::string& whole :
         {kVtkAscii, binary_legacy(false), binary_legacy(true), ascii_vtp(), appended_vtp(),
          compressed_vtp(false), compressed_vtp(true)}) {
        const char* extension = whole[0] == '#' ? "vtk" : "vtp";
        for (std::size_t size = 0; size < whole.size(); ++size)
            parse_message(whole.substr(0, size), extension);
        for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 3) {
            std::string damaged = whole;
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
            parse_message(damaged, extension);
        }
    }
}

TEST(Xyz, PointsWithColoursNormalsHeadingsAndSeparators) {
    EXPECT_EQ(parse_mesh("X Y Z\n0 0 0\n1.5 2 -3e1\n", "xyz").vertices,
              points_of({{0, 0, 0}, {1.5, 2, -30}}));
    EXPECT_EQ(parse_mesh("# c\n2\n0,0,0\n1,2,3\n", "xyz").vertices,
              points_of({{0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(parse_mesh("0;0;0\r1;2;3\r", "xyz").vertices, points_of({{0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(parse_mesh("0 0 0 255 0 7\n1 2 3 0 0 0\n", "xyz").colors.row(0),
              (Eigen::Matrix<std::uint8_t, 1, 3>(255, 0, 7)));
    EXPECT_EQ(parse_mesh("0 0 0 0.5 0.25 1\n1 2 3 0 0 0\n", "xyz").colors.row(0),
              (Eigen::Matrix<std::uint8_t, 1, 3>(128, 64, 255)));
    EXPECT_EQ(parse_mesh("0 0 0 0 0.6 0.8\n1 2 3 0 0 1\n", "xyz").colors.rows(), 0);
    EXPECT_EQ(parse_mesh("0 0 0 0 0.6 -0.8\n1 2 3 0 0 1\n", "xyz").colors.rows(), 0);
    EXPECT_EQ(parse_mesh("0 0 0 17 1 2 3\n1 2 3 0 200 0 0\n", "xyz").colors.row(0),
              (Eigen::Matrix<std::uint8_t, 1, 3>(1, 2, 3)));
    EXPECT_EQ(parse_mesh("0 0 0\nnan nan nan\n1 2 3\n", "xyz").vertices.rows(), 2);
    for (const char* text :
         {"", "a b c\n", "0 0\n1 1\n", "0 0 0\n1 1\n", "0 0 0\n1 2 3 x\n", "0 0 0\n1 2 3 4\n"})
        EXPECT_NE(parse_message(text, "xyz"), "read") << text;
}

}  // namespace
