// What is said of meshes: windings, units, pieces, faults.
#include "mesh/mesh_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "mesh/winding.hpp"

namespace {

using namespace mien;

/// A ball of rings and sectors, wound outwards.
TriMesh ball(double radius, int rings = 12, int sectors = 16) {
    TriMesh mesh;
    mesh.vertices.resize(rings * sectors + 2, 3);
    constexpr double kPi = 3.14159265358979323846;
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double a = kPi * (r + 1) / (rings + 1), b = 2 * kPi * s / sectors;
            mesh.vertices.row(r * sectors + s) << radius * std::sin(a) * std::cos(b),
                radius * std::sin(a) * std::sin(b), radius * std::cos(a);
        }
    mesh.vertices.row(rings * sectors) << 0, 0, radius;
    mesh.vertices.row(rings * sectors + 1) << 0, 0, -radius;
    std::vector<std::array<int, 3>> triangles;
    const auto at = [&](int r, int s) { return r * sectors + (s + sectors) % sectors; };
    for (int s = 0; s < sectors; ++s) {
        triangles.push_back({rings * sectors, at(0, s), at(0, s + 1)});
        triangles.push_back({rings * sectors + 1, at(rings - 1, s + 1), at(rings - 1, s)});
        for (int r = 0; r + 1 < rings; ++r) {
            triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    mesh.triangles.resize(static_cast<Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            mesh.triangles(static_cast<Index>(t), k) =
                static_cast<std::uint32_t>(triangles[t][static_cast<std::size_t>(k)]);
    return mesh;
}

void turn(TriMesh& mesh, Index t) {
    std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
}

TEST(Winding, AStripWoundTheOtherWayIsTurnedBack) {
    const TriMesh good = ball(100);
    TriMesh mesh = good;
    for (Index t = 40; t < 120; ++t) turn(mesh, t);
    const WindingReport report = make_windings_consistent(mesh, WindingSettings(), Context());
    EXPECT_EQ(mesh.triangles, good.triangles);
    ASSERT_EQ(report.turned.size(), 80u);
    EXPECT_EQ(report.turned.front(), 40u);
    EXPECT_EQ(report.num_pieces, 1);
    EXPECT_GT(report.outward, 0.9);
}

TEST(Winding, APatchThatTouchesNothingIsTurnedByWhereItFaces) {
    const TriMesh whole = ball(100);
    TriMesh mesh = whole;
    // Triangles of one side get vertices of their own, as of another camera, wound inwards.
    mesh.vertices.conservativeResize(2 * whole.vertices.rows(), 3);
    mesh.vertices.bottomRows(whole.vertices.rows()) = whole.vertices;
    Index count = 0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        const Vector3 middle =
            (whole.vertices.row(whole.triangles(t, 0)) + whole.vertices.row(whole.triangles(t, 1)) +
             whole.vertices.row(whole.triangles(t, 2))) /
            3;
        if (middle[0] < 40) continue;
        ++count;
        for (int k = 0; k < 3; ++k)
            mesh.triangles(t, k) += static_cast<std::uint32_t>(whole.vertices.rows());
        turn(mesh, t);
    }
    const WindingReport report = make_windings_consistent(mesh, WindingSettings(), Context());
    EXPECT_GT(count, 20);
    EXPECT_EQ(static_cast<Index>(report.turned.size()), count);
    EXPECT_GT(outward_share(mesh), 0.9);
}

TEST(Winding, APatchThatTouchesInOneVertexIsAPieceOfItsOwn) {
    const TriMesh whole = ball(100);
    const Index n = whole.vertices.rows();
    TriMesh mesh = whole;
    mesh.vertices.conservativeResize(2 * n, 3);
    mesh.vertices.bottomRows(n) = whole.vertices;
    std::vector<std::uint8_t> in_patch(static_cast<std::size_t>(mesh.triangles.rows()), 0),
        at(static_cast<std::size_t>(n), 0);
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += whole.vertices(whole.triangles(t, k), 0);
        in_patch[static_cast<std::size_t>(t)] = sum > 3 * 40;
        for (int k = 0; k < 3; ++k) at[whole.triangles(t, k)] |= sum > 3 * 40 ? 1 : 2;
    }
    const auto shared = static_cast<std::uint32_t>(std::find(at.begin(), at.end(), 3) - at.begin());
    ASSERT_LT(shared, static_cast<std::uint32_t>(n));
    std::vector<std::uint32_t> patch;
    for (Index t = 0; t < mesh.triangles.rows(); ++t) {
        if (!in_patch[static_cast<std::size_t>(t)]) continue;
        patch.push_back(static_cast<std::uint32_t>(t));
        for (int k = 0; k < 3; ++k)
            if (mesh.triangles(t, k) != shared)
                mesh.triangles(t, k) += static_cast<std::uint32_t>(n);
        turn(mesh, t);
    }
    const WindingReport report = make_windings_consistent(mesh, WindingSettings(), Context());
    EXPECT_EQ(report.num_pieces, 2);
    EXPECT_EQ(report.turned, patch);
    EXPECT_GT(report.outward, 0.9);
}

TEST(Winding, FansGivenAreThoseOfWhatWasTurned) {
    TriMesh mesh = ball(100);
    turn(mesh, 7);
    TriangleFans fans(mesh.vertices.rows(), mesh.triangles, Context());
    EXPECT_FALSE(fans.wound_alike());
    make_windings_consistent(mesh, fans, WindingSettings(), Context());
    EXPECT_TRUE(fans.wound_alike());
}

TEST(Winding, TheLargerPartKeepsItsWindingEvenInwards) {
    TriMesh mesh = ball(100);
    turn_over(mesh);
    const TriMesh inside_out = mesh;
    turn(mesh, 7);
    const WindingReport report = make_windings_consistent(mesh, WindingSettings(), Context());
    EXPECT_EQ(report.turned, std::vector<std::uint32_t>{7});
    EXPECT_EQ(mesh.triangles, inside_out.triangles);
    EXPECT_LT(report.outward, -0.9);
}

TEST(Winding, AMoebiusBandIsCountedAndEnds) {
    TriMesh mesh;
    const int n = 12;
    mesh.vertices.resize(2 * n, 3);
    for (int i = 0; i < n; ++i) {
        const double a = 2 * 3.14159265358979323846 * i / n, h = a / 2;
        for (int side = 0; side < 2; ++side) {
            const double w = side == 0 ? -10 : 10;
            mesh.vertices.row(2 * i + side) << (50 + w * std::cos(h)) * std::cos(a),
                (50 + w * std::cos(h)) * std::sin(a), w * std::sin(h);
        }
    }
    mesh.triangles.resize(2 * n, 3);
    for (int i = 0; i < n; ++i) {
        const auto a = static_cast<std::uint32_t>(2 * i), b = a + 1;
        const bool last = i + 1 == n;
        const std::uint32_t c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        mesh.triangles.row(2 * i) << a, c, b;
        mesh.triangles.row(2 * i + 1) << b, c, d;
    }
    EXPECT_GT(make_windings_consistent(mesh, WindingSettings(), Context()).num_impossible_edges, 0);
}

TEST(LengthUnit, TheExtentOfAHeadNamesItsUnit) {
    for (const LengthUnit& unit : length_units()) {
        const TriMesh mesh = ball(95 / unit.to_mm);
        const std::vector<LengthUnit> found = plausible_units(robust_extent(mesh.vertices));
        ASSERT_FALSE(found.empty()) << unit.name;
        EXPECT_EQ(found[0].to_mm, unit.to_mm) << unit.name;
    }
    EXPECT_TRUE(plausible_units(1e-9).empty());
    EXPECT_EQ(unit_text(25.4), "in (25.4 mm)");
}

TEST(LengthUnit, SurfacesOfDifferentUnitsAreRefusedAndBothNamed) {
    const TriMesh mm = ball(95), cm = ball(9.5), bust = ball(300);
    EXPECT_NO_THROW(check_same_unit(mm.vertices, "a", bust.vertices, "b"));
    try {
        check_same_unit(mm.vertices, "the fit", cm.vertices, "the scan");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::mismatch);
        const std::string text = error.what();
        EXPECT_NE(text.find("unit"), std::string::npos);
        EXPECT_NE(text.find("when the fit is in mm, the scan is in cm"), std::string::npos) << text;
    }
}

TEST(MeshReport, AGoodMeshHasNoFaultsAndBadOnesAreNamed) {
    const TriMesh good = ball(95);
    EXPECT_TRUE(inspect_mesh(good, Context()).faults.empty());
    TriMesh bad = ball(9.5);
    turn_over(bad);
    turn(bad, 3);
    bad.triangles.conservativeResize(bad.triangles.rows() + 1, 3);
    bad.triangles.bottomRows(1) = bad.triangles.row(0);
    bad.vertices.conservativeResize(bad.vertices.rows() + 1, 3);
    bad.vertices.bottomRows(1) << 1, 2, 3;
    const MeshReport report = inspect_mesh(bad, Context());
    std::string all;
    for (const std::string& fault : report.faults) all += fault + "\n";
    for (const char* word : {"in cm", "twice", "no triangle", "wound against", "inside out"})
        EXPECT_NE(all.find(word), std::string::npos) << word << " in\n" << all;
    EXPECT_EQ(report.num_turned, 1);
    EXPECT_NE(mesh_report_json(report).find("\"turned_triangles\":1"), std::string::npos);
}

}  // namespace
