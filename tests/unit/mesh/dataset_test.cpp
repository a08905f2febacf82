#include "mesh/dataset.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "unit/mesh/sample_meshes.hpp"
#include "unit/scratch.hpp"

namespace {

using namespace mien;
using namespace mien::testing;

template <typename Call>
Status status_of(Call&& call) {
    try {
        call();
        return Status::ok;
    } catch (const Error& error) {
        return error.status();
    }
}

TEST(FaceDataset, FacesAndLabelsComeBack) {
    ScratchFolder folder;
    const TriMesh mesh = tetrahedron();
    FaceDatasetWriter writer(mesh.triangles, 4, {"smile", "neutral"});
    writer.add(mesh.vertices, 3, 1);
    writer.add(2.0 * mesh.vertices, 3, 0);
    writer.add(mesh.vertices, 4, 1);
    writer.save(folder / "set", Context());
    const FaceDataset set = FaceDataset::open(folder / "set", {}, Context());
    EXPECT_EQ(set.num_faces(), 3);
    EXPECT_EQ(set.num_vertices(), 4);
    EXPECT_EQ(set.triangles(), mesh.triangles);
    EXPECT_EQ(set.neutral_expression(), 1);
    EXPECT_EQ(set.subject(1), 3);
    EXPECT_EQ(set.expression(1), 0);
    EXPECT_EQ(set.units(), "millimetres");
    Points face;
    set.face(1, face);
    EXPECT_EQ(face, Points(2.0 * mesh.vertices));
    EXPECT_EQ(status_of([&] { set.face(3, face); }), Status::invalid_argument);
    EXPECT_EQ(status_of([&] { set.face(-1, face); }), Status::invalid_argument);
}

struct Labels {
    std::vector<std::int32_t> subject{0, 1}, expression{0, 1};
    std::vector<std::uint32_t> triangles{0, 1, 2};
    std::string names = "[\"neutral\", \"smile\"]", units = "metres";
};

void write_set(const std::string& path, const Labels& labels, bool doubles = true) {
    std::vector<double> wide(2 * 3 * 3, 0.001);
    std::vector<float> narrow(2 * 3 * 3, 0.001f);
    write_safetensors(
        path,
        {{"vertices",
          doubles ? DType::f64 : DType::f32,
          {2, 3, 3},
          doubles ? static_cast<const void*>(wide.data()) : narrow.data()},
         {"subject", DType::i32, {labels.subject.size()}, labels.subject.data()},
         {"expression", DType::i32, {labels.expression.size()}, labels.expression.data()},
         {"triangles", DType::u32, {labels.triangles.size() / 3, 3}, labels.triangles.data()}},
        {{"expression_names", labels.names}, {"units", labels.units}}, Context());
}

TEST(FaceDataset, UnitsAreBroughtToMillimetresForBothPrecisions) {
    ScratchFolder folder;
    Points face;
    for (bool doubles : {true, false}) {
        write_set(folder / "set", Labels(), doubles);
        const FaceDataset set = FaceDataset::open(folder / "set", {}, Context());
        set.face(1, face);
        EXPECT_NEAR(face(2, 2), 1.0, 1e-6);
    }
}

TEST(FaceDataset, LabelsTopologyAndUnitsAreChecked) {
    ScratchFolder folder;
    auto status = [&](auto&& change) {
        Labels labels;
        change(labels);
        write_set(folder / "set", labels);
        return status_of([&] { FaceDataset::open(folder / "set", {}, Context()); });
    };
    EXPECT_EQ(status([](Labels&) {}), Status::ok);
    EXPECT_EQ(status([](Labels& l) { l.expression[1] = 2; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.expression[0] = -1; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.subject[0] = -1; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.subject.push_back(0); }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.triangles[1] = 3; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.names = "[1]"; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.names = "neutral"; }), Status::bad_format);
    EXPECT_EQ(status([](Labels& l) { l.units = "inches"; }), Status::bad_format);
    EXPECT_EQ(status_of([&] { FaceDataset::open(folder / "missing", {}, Context()); }), Status::io);
}

TEST(FaceDataset, AnotherKindOfFileIsToldFromADatasetAndAnUnlabelledOneIsRead) {
    ScratchFolder folder;
    const float f[1] = {0};
    write_safetensors(folder / "model", {{"basis", DType::f32, {1}, f}},
                      {{"kind", "mien-deformation-model"}, {"format", "1.0"}}, Context());
    EXPECT_EQ(status_of([&] { FaceDataset::open(folder / "model", {}, Context()); }),
              Status::wrong_kind);
    write_set(folder / "set", Labels());
    EXPECT_EQ(status_of([&] { FaceDataset::open(folder / "set", {}, Context()); }), Status::ok);
}

TEST(FaceDataset, TheWriterRefusesWhatItsReaderWould) {
    ScratchFolder folder;
    const TriMesh mesh = tetrahedron();
    FaceDatasetWriter writer(mesh.triangles, 4, {"neutral"});
    Points bad = mesh.vertices;
    bad(2, 1) = 1e300;
    EXPECT_EQ(status_of([&] { writer.save(folder / "set", Context()); }), Status::invalid_argument);
    EXPECT_EQ(status_of([&] { writer.add(bad, 0, 0); }), Status::invalid_mesh);
    EXPECT_EQ(status_of([&] { writer.add(mesh.vertices.topRows(3), 0, 0); }), Status::mismatch);
    EXPECT_EQ(status_of([&] { writer.add(mesh.vertices, 0, 1); }), Status::invalid_argument);
    EXPECT_EQ(status_of([&] { writer.add(mesh.vertices, -1, 0); }), Status::invalid_argument);
    EXPECT_EQ(status_of([&] { FaceDatasetWriter(mesh.triangles, 3, {"neutral"}); }),
              Status::invalid_mesh);
    writer.add(mesh.vertices, 0, 0);
    writer.save(folder / "set", Context());
    EXPECT_EQ(FaceDataset::open(folder / "set", {}, Context()).num_faces(), 1);
}

}  // namespace
