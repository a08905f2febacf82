// What programs and systems do to mesh files, by kind: marks before the text, other line ends,
// words for undefined numbers, other names, other byte orders, names that mislead. Each of these
// was read wrongly once, most of them without a word.
#include <gtest/gtest.h>

#include <cstring>

#include "base/error.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/mesh/parse_mesh.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

constexpr const char* kObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
constexpr const char* kOff = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
constexpr const char* kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";

struct KindOfFile {
    const char *extension, *text;
};
constexpr KindOfFile kKindsOfFile[] = {{"obj", kObj}, {"ply", kPly}, {"off", kOff}, {"stl", kStl}};

void expect_square(const TriMesh& mesh, const std::string& what) {
    EXPECT_EQ(mesh.vertices, points_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})) << what;
    EXPECT_EQ(mesh.triangles, triangles_of({{0, 1, 2}, {0, 2, 3}})) << what;
}

TEST(ReaderKinds, AByteOrderMarkBeforeTheTextIsSteppedOver) {
    for (const KindOfFile& sample : kKindsOfFile)
        expect_square(parse_mesh(std::string("\xef\xbb\xbf") + sample.text, sample.extension),
                      sample.extension);
}

TEST(ReaderKinds, TextInSixteenBitUnitsOfBothByteOrdersIsRead) {
    for (const KindOfFile& sample : kKindsOfFile)
        for (const bool little : {true, false}) {
            std::string wide = little ? "\xff\xfe" : "\xfe\xff";
            for (const char* c = sample.text; *c != '\0'; ++c)
                wide += little ? std::string{*c, '\0'} : std::string{'\0', *c};
            expect_square(parse_mesh(wide, sample.extension), sample.extension);
        }
}

TEST(ReaderKinds, AnyLineEndEndsALine) {
    for (const KindOfFile& sample : kKindsOfFile)
        for (const char* end : {"\r", "\r\n", "\r\r\n", "\n\n", " \r", "\t\r\n"})
            expect_square(parse_mesh(replaced(sample.text, "\n", end), sample.extension),
                          sample.extension);
}

TEST(ReaderKinds, LeadingBlanksAndCapitalsDoNotHideAnAsciiStl) {
    std::string capitals = kStl;
    for (char& c : capitals)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    for (const std::string& text :
         {capitals, "  \n\t " + std::string(kStl), "\r\n" + capitals, replaced(kStl, "s\n", "\n")})
        expect_square(parse_mesh(text, "stl"), text);
}

TEST(ReaderKinds, AnAsciiStlMayStandOnOneLine) {
    const std::string one = replaced(kStl, "\n", " ");
    expect_square(parse_mesh(one, "stl"), one);
    expect_square(parse_mesh(replaced(one, "solid s ", "solid "), "stl"), "no name");
    expect_square(parse_mesh(replaced(one, "solid s ", "solid of a facet of s "), "stl"), "words");
    EXPECT_EQ(parse_status(one.substr(0, one.size() / 2), "stl"), Status::bad_format);
}

// A header that was edited, or whose program lost count: a part of the surface went without a word.
TEST(ReaderKinds, CountsBelowWhatTheFileHoldsAreRefused) {
    const std::string fewer = replaced(kPly, "face 2", "face 1");
    EXPECT_NE(parse_message(fewer, "ply").find("goes on for 8 bytes"), std::string::npos)
        << parse_message(fewer, "ply");
    expect_square(parse_mesh(std::string(kPly) + "\n \n", "ply"), "blank lines");
    std::string binary =
        replaced(std::string(kPly, std::strstr(kPly, "0 0 0")), "ascii", "binary_little_endian");
    for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
        binary.append(reinterpret_cast<const char*>(&x), sizeof x);
    for (const std::int32_t second : {1, 2}) {
        binary += '\3';
        for (const std::int32_t corner : {0, second, second + 1})
            binary.append(reinterpret_cast<const char*>(&corner), sizeof corner);
    }
    expect_square(parse_mesh(binary, "ply"), "binary");
    expect_square(parse_mesh(binary + std::string("\0\0\0\0\0\0\0\0\r\n", 10), "ply"), "padding");
    EXPECT_NE(parse_message(replaced(binary, "face 2", "face 1"), "ply").find("goes on for 13"),
              std::string::npos);
}

TEST(ReaderKinds, ABinaryStlThatCountsTooFewTrianglesIsRefused) {
    const auto stl = [](std::uint32_t counted, std::size_t held, std::size_t more) {
        std::string bytes(80, ' ');
        bytes.append(reinterpret_cast<const char*>(&counted), 4);
        for (std::size_t t = 0; t < held; ++t) {
            const float z = static_cast<float>(t);
            const float triangle[12] = {0, 0, 1, 0, 0, z, 1, 0, z, 0, 1, z};
            bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
            bytes.append(2, '\0');
        }
        return bytes + std::string(more, 'x');
    };
    EXPECT_EQ(parse_mesh(stl(100, 100, 37), "stl").triangles.rows(), 100);
    EXPECT_EQ(parse_mesh(stl(100, 100, 500), "stl").triangles.rows(), 100);
    for (const std::uint32_t counted : {0u, 50u})
        EXPECT_NE(parse_message(stl(counted, 100, 0), "stl").find("hold 100"), std::string::npos)
            << counted;
}

TEST(ReaderKinds, LinesOfMoreNumbersThanThePlyHeaderNamesAreTold) {
    const std::string message = parse_message(replaced(kPly, "0 1 0\n", "0 1 0 0.25\n"), "ply");
    EXPECT_NE(message.find("more numbers than the header names"), std::string::npos) << message;
}

TEST(ReaderKinds, CommentsMayTouchTheLastCornerOfAnObjFace) {
    expect_square(parse_mesh(replaced(replaced(kObj, "3/3\n", "3/3#a\n"), "4/4\n", "4#b\n"), "obj"),
                  "comments");
    const std::string message = parse_message(replaced(kObj, "v 1 0 0", "v 1,5 0,1 0,0"), "obj");
    EXPECT_NE(message.find("decimal"), std::string::npos) << message;
}

TEST(ReaderKinds, WordsForUndefinedNumbersAreNotANumberAndUnusedPointsGo) {
    for (const char* word :
         {"nan", "-nan", "NaN", "nan(ind)", "-nan(ind)", "-1.#IND", "1.#QNAN", "-1.#IND00",
          "1.#QNAN0", "1.#SNAN", "1.#INF", "-1.#INF00", "inf", "1e999"}) {
        const std::string point = std::string(word) + " 0 " + word + "\n";
        const std::string obj = std::string("v ") + point + "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" +
                                "v 2 " + point + "f 2 3 4\nf 2 4 5\n";
        expect_square(parse_mesh(obj, "obj"), word);
        std::string ply = replaced(kPly, "vertex 4", "vertex 5");
        ply = replaced(ply, "end_header\n", "end_header\n" + point);
        ply = replaced(replaced(ply, "3 0 2 3", "3 1 3 4"), "3 0 1 2", "3 1 2 3");
        expect_square(parse_mesh(ply, "ply"), word);
        // Where a triangle uses the point nothing is dropped without a word.
        EXPECT_NE(parse_message(replaced(obj, "f 2 3 4", "f 1 3 4"), "obj").find("not finite"),
                  std::string::npos)
            << word;
        // A normal that nobody uses may be anything.
        const std::string normals =
            replaced(replaced(kPly, "float z\n", "float z\nproperty float nx\n"), "0 0\n",
                     "0 0 " + std::string(word) + "\n");
        expect_square(
            parse_mesh(replaced(replaced(normals, "1 1 0\n", "1 1 0 1\n"), "0 1 0\n", "0 1 0 1\n"),
                       "ply"),
            word);
    }
    // A comment after a number is none of these.
    EXPECT_EQ(parse_mesh("v 1 2 3.#IN\nv 0 0 1.# x\n", "obj").vertices(1, 2), 1.0);
    EXPECT_EQ(parse_mesh("v 1 2 3 # IND\n", "obj").vertices(0, 2), 3.0);
}

TEST(ReaderKinds, ExponentsOfFortranAreUnderstood) {
    EXPECT_EQ(parse_mesh("v 1.5D+02 -2d-1 3.D0\n", "obj").vertices, points_of({{150, -0.2, 3}}));
    EXPECT_EQ(parse_message("v 1.5D 0 0\n", "obj").substr(0, 6), "line 1");
}

TEST(ReaderKinds, FaceListsUnderOtherNamesAreReadOrNamed) {
    for (const char* name : {"vertices", "vertex_indexes", "vertexIndices", "VERTEX_INDICES",
                             "verts", "indices", "vertex_index"})
        expect_square(parse_mesh(replaced(kPly, "vertex_indices", name), "ply"), name);
    for (const char* name : {"faces", "Face", "triangles", "polygon", "cells"})
        expect_square(
            parse_mesh(replaced(kPly, "element face", std::string("element ") + name), "ply"),
            name);
    const std::string odd = parse_message(replaced(kPly, "vertex_indices", "my_list"), "ply");
    EXPECT_NE(odd.find("'my_list'"), std::string::npos) << odd;
    EXPECT_NE(odd.find("vertex_indices"), std::string::npos) << odd;
    const std::string none =
        parse_message(replaced(replaced(kPly, "list uchar int vertex_indices",
                                        "int a\nproperty int b\nproperty int c\nproperty int d"),
                               "x", "x"),
                      "ply");
    EXPECT_NE(none.find("vertex_indices"), std::string::npos) << none;
    // Two lists, neither by its name: not guessed.
    const std::string two = parse_message(
        replaced(
            replaced(kPly, "vertex_indices", "vertices\nproperty list uchar int vertex_normals"),
            "3 0 1 2\n3 0 2 3", "3 0 1 2 0\n3 0 2 3 0"),
        "ply");
    EXPECT_NE(two.find("'vertices', 'vertex_normals'"), std::string::npos) << two;
}

TEST(ReaderKinds, ABinaryPlyMayHaveAHeaderOfLoneReturnsAndDataThatLooksLikeALineEnd) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string file = replaced(
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar q\n"
            "property float x\nproperty float y\nproperty float z\nend_header\n",
            "\n", end);
        const float values[3] = {1.f, 2.f, 3.f};
        file += '\n';  // the value of q
        file.append(reinterpret_cast<const char*>(values), sizeof values);
        EXPECT_EQ(parse_mesh(file, "ply").vertices, points_of({{1, 2, 3}})) << int(end[0]);
    }
}

std::string binary_off(bool big_endian, bool face_colors, const char* keyword = "OFF BINARY\n") {
    std::string file = keyword;
    auto put = [&](std::uint32_t bits) {
        for (int k = 0; k < 4; ++k)
            file += static_cast<char>(bits >> (big_endian ? 24 - 8 * k : 8 * k));
    };
    auto put_float = [&](float value) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, 4);
        put(bits);
    };
    for (std::uint32_t count : {4u, 2u, 0u}) put(count);
    for (float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
        put_float(value);
    for (std::uint32_t corner : {1u, 2u}) {
        for (std::uint32_t word : {3u, 0u, corner, corner + 1}) put(word);
        if (face_colors) put(0);
    }
    return file;
}

TEST(ReaderKinds, BinaryOffOfBothByteOrdersWithAndWithoutFaceColours) {
    for (const bool big : {true, false})
        for (const bool colors : {true, false}) {
            const std::string file = binary_off(big, colors);
            expect_square(parse_mesh(file, "off"), file.substr(0, 3));
            for (std::size_t size = 0; size < file.size(); ++size)
                EXPECT_NE(parse_message(file.substr(0, size), "off"), "read") << size;
        }
    expect_square(parse_mesh(binary_off(false, true, "OFF BINARY\r\n"), "off"), "returns");
}

TEST(ReaderKinds, WhatAFileHoldsDecidesWhereItsNameMisleads) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const KindOfFile& sample : kKindsOfFile) all.emplace_back(sample.extension, sample.text);
    ScratchFolder folder;
    TriMesh square = parse_mesh(kPly, "ply");
    for (const char* name : {"b.ply", "b.stl"}) {
        write_mesh_file(folder / name, square, Context());
        all.emplace_back(name, read_bytes(folder / name));
    }
    for (const auto& file : all)
        for (const char* extension : {"ply", "obj", "stl", "off", "txt", ""})
            expect_square(parse_mesh(file.second, extension), file.first + " as " + extension);
}

TEST(ReaderKinds, DecimalCommasAreNotReadAsSeparators) {
    for (const char* text : {"1,5 2,25 3,75\n", "1,5;2,25;3,75\n", "0 0 0\n1 2 3,5\n"})
        EXPECT_NE(parse_message(text, "xyz").find("decimal"), std::string::npos) << text;
    for (const char* text : {"1.5,2.25,3.75\n", "1.5, 2.25, 3.75\n", "1.5 , 2.25 , 3.75 \n",
                             "  1.5;2.25;3.75;\n", "1.5\t2.25\t3.75\r\n"})
        EXPECT_EQ(parse_mesh(text, "xyz").vertices, points_of({{1.5, 2.25, 3.75}})) << text;
    EXPECT_NE(parse_message("v 1 2 3,5\n", "obj").find("decimal"), std::string::npos);
    for (const KindOfFile& sample : kKindsOfFile)
        EXPECT_NE(parse_message(replaced(sample.text, "1 1 0\n", "1 1,5 0\n"), sample.extension),
                  "read")
            << sample.extension;
}

TEST(ReaderKinds, FacesOfOldObjFilesAreNoPointCloud) {
    expect_square(parse_mesh(replaced(kObj, "f ", "fo "), "obj"), "fo");
}

TEST(ReaderKinds, NoFormatThatTellsItsEndIsReadCutShort) {
    constexpr const char* kVtk =
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0\n1 0 0\n"
        "0 1 0\nPOLYGONS 1 4\n3 0 1 2\n";
    constexpr const char* kVtp =
        "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">"
        "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 "
        "0 1 0</DataArray></Points><Polys><DataArray type=\"Int32\" Name=\"connectivity\" "
        "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
        "format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>\n";
    for (const KindOfFile& sample :
         {KindOfFile{"ply", kPly}, {"stl", kStl}, {"off", kOff}, {"vtk", kVtk}, {"vtp", kVtp}}) {
        const std::string whole = sample.text;
        EXPECT_EQ(parse_message(whole, sample.extension), "read") << sample.extension;
        // A VTK file that ends before its polygons is a cloud of points.
        const std::size_t cloud = whole.find("POLYGONS");
        for (std::size_t size = cloud == std::string::npos ? 0 : cloud + 8; size + 3 < whole.size();
             ++size)
            EXPECT_NE(parse_message(whole.substr(0, size), sample.extension), "read")
                << sample.extension << " cut to " << size;
    }
}

TEST(ReaderKinds, EveryFormatOfTheTableReadsWhatItWrites) {
    ScratchFolder folder;
    EXPECT_GE(mesh_formats().size(), 5u);
    for (const MeshFormat& format : mesh_formats()) {
        if (!format.writes) continue;
        const std::string path = folder / (std::string("m.") + format.extension);
        write_mesh_file(path, tetrahedron(), Context());
        const TriMesh back = read_mesh_file(path, Context());
        EXPECT_EQ(back.vertices.rows(), 4) << format.extension;
        EXPECT_EQ(back.triangles.rows(), 4) << format.extension;
    }
}

TEST(ReaderKinds, CoordinatesFarFromTheOriginLoseNothing) {
    ScratchFolder folder;
    TriMesh far = grid(12);
    for (Index v = 0; v < far.vertices.rows(); ++v)
        far.vertices.row(v) =
            (0.137 * far.vertices.row(v) + Eigen::RowVector3d(4.5e6, -2.25e6, 1e3 / 3)).eval();
    for (const MeshFormat& format : mesh_formats()) {
        if (!format.writes) continue;
        const std::string path = folder / (std::string("m.") + format.extension);
        if (std::string(format.extension) == "stl") {
            EXPECT_THROW(write_mesh_file(path, far, Context()), Error);
            continue;
        }
        write_mesh_file(path, far, Context());
        const TriMesh back = read_mesh_file(path, Context());
        EXPECT_LT((back.vertices - far.vertices).cwiseAbs().maxCoeff(), 1e-3) << format.extension;
    }
    // Near the origin files stay small.
    write_mesh_file(folder / "near.ply", grid(12), Context());
    EXPECT_NE(read_bytes(folder / "near.ply").find("property float x"), std::string::npos);
    EXPECT_NE(read_bytes(folder / "m.ply").find("property double x"), std::string::npos);
}

}  // namespace
