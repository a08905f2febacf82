// Landmark files of every kind: what they say, what they leave open, and what is wrong with them.
#include "mesh/landmark_file.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/zone_file.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

LandmarkFile parse_marks(const std::string& text, const std::string& path) {
    const std::vector<char> exact(text.begin(), text.end());
    return parse_landmarks(exact.data(), exact.size(), path);
}

const Mark& named(const LandmarkFile& file, const std::string& name) {
    for (const Mark& mark : file.marks)
        if (mark.name == name) return mark;
    throw std::runtime_error("no landmark " + name);
}

void expect_place(const LandmarkFile& file, const std::string& name, double x, double y, double z) {
    const Mark& mark = named(file, name);
    EXPECT_EQ(mark.where, Mark::Where::place) << name;
    EXPECT_EQ(mark.point, Vector3(x, y, z)) << name;
}

void expect_not_picked(const LandmarkFile& file, const std::string& name) {
    EXPECT_EQ(named(file, name).where, Mark::Where::not_picked) << name;
    EXPECT_TRUE(named(file, name).point.isZero()) << name;
}

std::string message_of(const std::string& text, const std::string& path, Status status) {
    try {
        parse_marks(text, path);
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), status) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown for " << text;
    return "";
}

TEST(LandmarkFile, OwnJsonKeepsNullNanAndNamesApart) {
    const LandmarkFile file = parse_marks(
        "{\"note\": [1, {\"a\": 2}], \"points\": {\"a\": [1, 2.5, -3], \"b\": null, \"c\": "
        "[1, NaN, 2], \"d\": [null, null, null], \"e\": [], \"f\": [\"NaN\", \"nan\", \"\"]}}",
        "x.json");
    EXPECT_EQ(file.format, "json");
    ASSERT_EQ(file.marks.size(), 6u);
    expect_place(file, "a", 1, 2.5, -3);
    for (const char* name : {"b", "c", "d", "e", "f"}) expect_not_picked(file, name);
}

TEST(LandmarkFile, VertexNumbersComeFromJsonTablesAndPlainLists) {
    for (const char* text : {"{\"vertices\": {\"1\": 7, \"2\": 9}}", "{\"vertices\": [7, 9]}"}) {
        const LandmarkFile file = parse_marks(text, "x.json");
        EXPECT_EQ(named(file, "1").vertex, 7u);
        EXPECT_EQ(named(file, "2").vertex, 9u);
        EXPECT_EQ(named(file, "2").where, Mark::Where::vertex);
    }
    EXPECT_EQ(named(parse_marks("name,vertex\nchin,12\nnose,\n", "x.csv"), "chin").vertex, 12u);
    expect_not_picked(parse_marks("name,vertex\nchin,12\nnose,\n", "x.csv"), "nose");
    EXPECT_EQ(named(parse_marks("7\n9\n", "x.txt"), "2").vertex, 9u);
}

TEST(LandmarkFile, SlicerMarkupsHonourStatusFrameAndUnit) {
    const std::string points =
        "\"controlPoints\": [{\"label\": \"a\", \"position\": [1, 2, 3], \"positionStatus\": "
        "\"defined\"}, {\"label\": \"b\", \"position\": [0, 0, 0], \"positionStatus\": "
        "\"undefined\"}, {\"label\": \"c\", \"position\": [4, 5, 6], \"positionStatus\": "
        "\"preview\"}, {\"position\": [7, 8, 9]}]";
    const LandmarkFile lps =
        parse_marks("{\"markups\": [{\"coordinateSystem\": \"LPS\", \"coordinateUnits\": \"mm\", " +
                        points + "}]}",
                    "x.mrk.json");
    EXPECT_EQ(lps.format, "mrk.json");
    EXPECT_EQ(lps.unit_to_mm, 1);
    expect_place(lps, "a", 1, 2, 3);
    expect_place(lps, "4", 7, 8, 9);
    expect_not_picked(lps, "b");
    expect_not_picked(lps, "c");
    const LandmarkFile ras =
        parse_marks("{\"markups\": [{\"coordinateSystem\": \"RAS\", " + points + "}]}", "x.json");
    EXPECT_EQ(ras.system, "RAS");
    expect_place(ras, "a", -1, -2, 3);
}

TEST(LandmarkFile, SlicerFiducialsAreRasUnlessTheySayLps) {
    const std::string rows =
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\r\n"
        "vtkMRML_0,1.5,-2,3,0,0,0,1,1,1,0,chin,,\r\n\"v,1\",nan,0,0,0,0,0,1,1,1,0,nose,,\r\n";
    const std::string head = "# Markups fiducial file version = 4.11\r\n";
    expect_place(parse_marks(head + "# CoordinateSystem = LPS\r\n" + rows, "x.fcsv"), "chin", 1.5,
                 -2, 3);
    expect_place(parse_marks(head + "# CoordinateSystem = 0\r\n" + rows, "x.fcsv"), "chin", -1.5, 2,
                 3);
    expect_not_picked(parse_marks(head + rows, "renamed.txt"), "nose");
}

TEST(LandmarkFile, MeshLabPointsThatAreOffAreNotPicked) {
    const LandmarkFile file = parse_marks(
        "<!DOCTYPE PickedPoints>\n<PickedPoints>\n <DocumentData/>\n <point x=\"1\" y=\"2\" "
        "z=\"-3e-1\" active=\"1\" name=\"a &amp; b\"/>\n <point active='0' name='c' x='4' y='5' "
        "z='6'/>\n</PickedPoints>\n",
        "x.pp");
    EXPECT_EQ(file.format, "pp");
    expect_place(file, "a & b", 1, 2, -0.3);
    expect_not_picked(file, "c");
}

TEST(LandmarkFile, PtsIsNumberedFromOneAndRefusedInTwoDimensions) {
    const LandmarkFile file =
        parse_marks("version: 1\nn_points:  3\n{\n1 2 3\nnan nan nan\n4 5 6\n}\n", "x.pts");
    EXPECT_EQ(file.format, "pts");
    expect_place(file, "1", 1, 2, 3);
    expect_not_picked(file, "2");
    expect_place(file, "3", 4, 5, 6);
    expect_place(parse_marks("Version 1.0\n2\nS0 1 2 3\nS1 4 5 6\n", "x.pts"), "S1", 4, 5, 6);
    EXPECT_NE(message_of("version: 1\nn_points: 1\n{\n1 2\n}\n", "x.pts", Status::bad_format)
                  .find("image"),
              std::string::npos);
}

TEST(LandmarkFile, LjsonIsReadInAllThreeVersions) {
    const std::string points = "{\"points\": [[1, 2, 3], [null, null, null], [4, 5, 6]]}";
    const std::string labels = "\"labels\": [{\"label\": \"chin\", \"mask\": [2]}]";
    const std::string two = "{\"version\": 2, " + labels + ", \"landmarks\": " + points + "}";
    for (const std::string& text :
         {two, "{\"version\": 3, \"groups\": {\"LJSON\": " + two + "}}"}) {
        const LandmarkFile file = parse_marks(text, "x.ljson");
        EXPECT_EQ(file.format, "ljson");
        expect_place(file, "1", 1, 2, 3);
        expect_not_picked(file, "2");
        expect_place(file, "chin", 4, 5, 6);
    }
    expect_place(parse_marks("{\"version\": 1, \"groups\": [{\"label\": \"a\", \"landmarks\": "
                             "[{\"point\": [1, 2, 3]}]}]}",
                             "x.ljson"),
                 "1", 1, 2, 3);
}

TEST(LandmarkFile, TablesMayUseAnySeparatorTitlesAndDecimalCommas) {
    for (const char* text :
         {"name,x,y,z\nchin,1.5,2,-3\n", "chin,1.5,2,-3\n",
          "\xef\xbb\xbfLabel;X;Y;Z\r\nchin;1,5;2;-3\r\n", "z,y,x,landmark\n-3,2,1.5,chin\n",
          "chin 1.5 2 -3\n", "chin\t1.5\t2\t-3\r", "id,x_mm,y_mm,z_mm\n\"chin\",1.5,+2,-3\n"})
        expect_place(parse_marks(text, "x.csv"), "chin", 1.5, 2, -3);
    EXPECT_EQ(parse_marks("name,x (cm),y (cm),z (cm)\nchin,1,2,3\n", "x.csv").unit_to_mm, 10);
    const LandmarkFile gaps = parse_marks(
        "name,x,y,z\na,,,\nb,not defined,n/a,-\nc,-1.#IND,1.#QNAN,nan(ind)\nd,1,2,3\n", "x.csv");
    for (const char* name : {"a", "b", "c"}) expect_not_picked(gaps, name);
    expect_place(gaps, "d", 1, 2, 3);
}

TEST(LandmarkFile, DecimalCommasBetweenCommasAreNotReadAsColumns) {
    for (const char* text : {"name,x,y,z\nchin,1,5,2,25,-3,75\n", "chin,1,5,2,25,-3,75\n"})
        EXPECT_NE(message_of(text, "x.csv", Status::bad_format).find("decimal points"),
                  std::string::npos);
    // Columns that titles name, trailing separators and a confidence behind are no such thing.
    for (const char* text : {"name,x,y,z,sure\nchin,1.5,2,-3,0.9\n", "name,x,y,z\nchin,1.5,2,-3,\n",
                             "chin,1.5,2,-3,1,1,1\n"})
        expect_place(parse_marks(text, "x.csv"), "chin", 1.5, 2, -3);
}

TEST(LandmarkFile, WhatWasCutShortIsNotTakenForFewerLandmarks) {
    EXPECT_NE(
        message_of("name,x,y,z\na,1,2,3\nb,4,5\n", "x.csv", Status::bad_format).find("line 3"),
        std::string::npos);
    for (const char* text :
         {"version: 1\nn_points: 3\n{\n1 2 3\n4 5 6\n}\n", "Version 1.0\n3\nS0 1 2 3\nS1 4 5 6\n"})
        EXPECT_NE(message_of(text, "x.pts", Status::bad_format).find("promises 3 points"),
                  std::string::npos);
    message_of("<PickedPoints><point x=\"1\" y=\"2\" z=\"3\" name=\"a\"/>", "x.pp",
               Status::bad_format);
}

TEST(LandmarkFile, UnitsStayWithTheNumbersInEveryFormat) {
    const LandmarkFile given =
        parse_marks("{\"units\": \"cm\", \"points\": {\"a\": [1, -2, 3]}}", "x.json");
    EXPECT_EQ(given.unit_to_mm, 10);
    ScratchFolder folder;
    for (const char* name : {"m.json", "m.mrk.json", "m.csv"}) {
        write_landmark_file(folder / name, given);
        const LandmarkFile back = read_landmark_file(folder / name, Context());
        EXPECT_EQ(back.unit_to_mm, 10) << name;
        expect_place(back, "a", 1, -2, 3);
    }
    // Slicer takes these for millimetres whatever they say.
    write_landmark_file(folder / "m.fcsv", given);
    expect_place(read_landmark_file(folder / "m.fcsv", Context()), "a", 10, -20, 30);
    message_of(
        "{\"markups\": [{\"coordinateUnits\": \"mm\", \"controlPoints\": [{\"label\": \"a\", "
        "\"position\": [1, 2, 3]}]}, {\"coordinateUnits\": \"cm\", \"controlPoints\": [{\"label\": "
        "\"b\", \"position\": [1, 2, 3]}]}]}",
        "x.mrk.json", Status::bad_format);
}

TEST(LandmarkFile, RepeatedPlaceholdersAreNotPicked) {
    const LandmarkFile zeros = parse_marks(
        "{\"points\": {\"a\": [0, 0, 0], \"b\": [1, 2, 3], \"c\": [-0.0, 0, 0]}}", "x.json");
    expect_not_picked(zeros, "a");
    expect_not_picked(zeros, "c");
    expect_place(zeros, "b", 1, 2, 3);
    const LandmarkFile ones = parse_marks(
        "a,-1,-1,-1\nb,-1,-1,-1\nc,9,8,7\nd,9,8,7\ne,5,6,7\nf,5,6,7\ng,5,6,7\n", "x.csv");
    for (const char* name : {"a", "b", "e", "f", "g"}) expect_not_picked(ones, name);
    expect_place(ones, "c", 9, 8, 7);  // two names may mean one place: shut lips
    // A single landmark at the origin may be one: a scanner may put it there.
    expect_place(parse_marks("a,0,0,0\nb,1,2,3\n", "x.csv"), "a", 0, 0, 0);
}

TEST(LandmarkFile, MistakesAreNamedWithTheirPlace) {
    EXPECT_NE(
        message_of("{\"points\": {\"chin\": [1, 2]}}", "x.json", Status::bad_format).find("'chin'"),
        std::string::npos);
    EXPECT_NE(message_of("name,x,y,z\nchin,1,two,3\n", "x.csv", Status::bad_format).find("line 2"),
              std::string::npos);
    EXPECT_NE(message_of("a,1,2,3\na,4,5,6\n", "x.csv", Status::invalid_argument).find("twice"),
              std::string::npos);
    message_of("", "x.csv", Status::bad_format);
    message_of("{\"zones\": {}}", "x.json", Status::bad_format);
    message_of("{\"points\": {}}", "x.json", Status::bad_format);
    message_of("<svg><point/></svg>", "x.pp", Status::bad_format);
    message_of(std::string(200, '['), "x.json", Status::bad_format);
    message_of("{\"vertices\": {\"a\": 1.5}}", "x.json", Status::bad_format);
    message_of("{\"unit\": \"ell\", \"points\": {\"a\": [1, 2, 3]}}", "x.json", Status::bad_format);
}

TEST(LandmarkFile, EveryFormatComesBackAsItWasWritten) {
    const LandmarkFile given = parse_marks(
        "{\"points\": {\"a <&\\\"> b\": [1.1, -2.25, 1e-7], \"b,c\": null, \"d\": [4, 5, 6]}}",
        "x.json");
    ScratchFolder folder;
    for (const char* name : {"m.json", "m.mrk.json", "m.fcsv", "m.pp", "m.ljson", "m.csv"}) {
        const std::string path = folder / name;
        write_landmark_file(path, given);
        const LandmarkFile back = read_landmark_file(path, Context());
        ASSERT_EQ(back.marks.size(), 3u) << name;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(back.marks[i].name, given.marks[i].name) << name;
            EXPECT_EQ(back.marks[i].where, given.marks[i].where) << name;
            EXPECT_EQ(back.marks[i].point, given.marks[i].point) << name;
        }
    }
    write_landmark_file(folder / "m.pts", given);
    expect_place(read_landmark_file(folder / "m.pts", Context()), "3", 4, 5, 6);
    EXPECT_THROW(write_landmark_file(folder / "m.doc", given), Error);
    const LandmarkFile vertices = parse_marks("{\"vertices\": {\"a\": 3}}", "x.json");
    EXPECT_THROW(write_landmark_file(folder / "v.pp", vertices), Error);
    write_landmark_file(folder / "v.csv", vertices);
    EXPECT_EQ(named(read_landmark_file(folder / "v.csv", Context()), "a").vertex, 3u);
}

TEST(LandmarkFile, EveryTruncationIsReadOrATypedError) {
    const LandmarkFile given = parse_marks(
        "{\"points\": {\"a\": [1.1, -2.25, 3], \"b\": null, \"c\": [4, 5, 6]}}", "x.json");
    ScratchFolder folder;
    for (const char* name :
         {"m.json", "m.mrk.json", "m.fcsv", "m.pp", "m.ljson", "m.csv", "m.pts"}) {
        write_landmark_file(folder / name, given);
        const std::string whole = read_bytes(folder / name);
        // The table and the fiducials alone do not tell where they end; the last character of the
        // others is a line's end.
        const bool open = std::string(name) == "m.csv" || std::string(name) == "m.fcsv";
        for (std::size_t size = 0; size < whole.size(); ++size) try {
                parse_marks(whole.substr(0, size), name);
                EXPECT_TRUE(open || size + 3 >= whole.size()) << name << " cut to " << size;
            } catch (const Error& error) {
                EXPECT_NE(error.status(), Status::internal);
            }
    }
}

TEST(ZoneFile, ListsBesideTheZonesAreZonesToo) {
    ScratchFolder folder;
    write_bytes(folder / "z.json",
                "{\"note\": \"n\", \"zones\": {\"b\": [3, 1], \"a\": []}, \"lips\": [4, 5]}");
    const std::vector<Zone> zones = read_zone_file(folder / "z.json", Context());
    ASSERT_EQ(zones.size(), 3u);
    EXPECT_EQ(zones[0].name, "b");
    EXPECT_EQ(zones[0].vertices, (std::vector<std::uint32_t>{3, 1}));
    EXPECT_EQ(zones[2].name, "lips");
    write_zone_file(folder / "back.json", zones);
    EXPECT_EQ(read_zone_file(folder / "back.json", Context())[2].vertices, zones[2].vertices);
    for (const char* text :
         {"{}", "[1]", "{\"zones\": {\"a\": [-1]}}", "{\"zones\": {\"a\": 3}}",
          "{\"zones\": {\"a\": [1], \"a\": [2]}}", "{\"zones\": {\"a\": [0.5]}}"})
        EXPECT_THROW(parse_zones(text, std::string(text).size(), "z.json"), Error) << text;
}

}  // namespace
