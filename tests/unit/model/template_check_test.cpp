// What makes a mesh a bad template is found and named with its vertices.
#include "model/template_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "mesh/winding.hpp"
#include "unit/model/support.hpp"

namespace {

using namespace mien;
using mien::model_test::bumpy_sheet;

/// A sheet of 140 mm across its corners, wound with +z out; bulging, so that outside is clear.
TriMesh face_like() {
    TriMesh mesh = bumpy_sheet(16, 2.0);
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        mesh.vertices(v, 2) -= mesh.vertices.row(v).head<2>().squaredNorm() / 80;
    return mesh;
}

std::vector<TemplateFinding> check(const TriMesh& mesh, TemplateCheckOptions options = {}) {
    return check_template(mesh, options, Context());
}

const TemplateFinding* find(const std::vector<TemplateFinding>& findings, const std::string& code) {
    for (const TemplateFinding& finding : findings)
        if (finding.code == code) return &finding;
    return nullptr;
}

/// Landmarks on the sheet: eyes above, mouth below, nose between, by grid places.
std::vector<Landmark> features(bool exchanged = false) {
    std::vector<Landmark> landmarks;
    const auto add = [&](const std::string& name, int x, int y) {
        landmarks.push_back({name, static_cast<std::uint32_t>(17 * y + x)});
    };
    for (int k = 0; k < 3; ++k) {
        add((exchanged ? "eye_left_" : "eye_right_") + std::to_string(k), 3 + k, 12 + k % 2);
        add((exchanged ? "eye_right_" : "eye_left_") + std::to_string(k), 11 + k, 12 + k % 2);
        add("mouth_outer_" + std::to_string(k), 7 + k, 4 + k % 2);
        add("nose_base_" + std::to_string(k), 7 + k, 8 + k % 2);
    }
    return landmarks;
}

TEST(TemplateCheck, AGoodTemplateHasNoFindings) {
    TemplateCheckOptions options;
    options.mirror = true;
    const std::vector<TemplateFinding> findings = check(face_like(), options);
    EXPECT_TRUE(findings.empty()) << template_findings_json(findings);
}

TEST(TemplateCheck, AWholeBodyInDecimetresIsRefusedWithTheReason) {
    TriMesh mesh = face_like();
    mesh.vertices *= 17.0 / 140;  // as MakeHuman's base: 1.7 m in dm
    const std::vector<TemplateFinding> findings = check(mesh);
    const TemplateFinding* unit = find(findings, "unit");
    ASSERT_NE(unit, nullptr);
    EXPECT_EQ(unit->kind, FindingKind::error);
    EXPECT_NE(unit->text.find("a whole body in dm"), std::string::npos) << unit->text;
    EXPECT_EQ(findings.front().kind, FindingKind::error);
}

TEST(TemplateCheck, AnInsideOutTemplateIsAnError) {
    TriMesh mesh = face_like();
    turn_over(mesh);
    ASSERT_NE(find(check(mesh), "inside-out"), nullptr);
    EXPECT_EQ(find(check(mesh), "inside-out")->kind, FindingKind::error);
}

TEST(TemplateCheck, TrianglesWoundTheOtherWayAreNamed) {
    TriMesh mesh = face_like();
    std::swap(mesh.triangles(5, 1), mesh.triangles(5, 2));
    const std::vector<TemplateFinding> findings = check(mesh);
    const TemplateFinding* winding = find(findings, "winding");
    ASSERT_NE(winding, nullptr);
    EXPECT_EQ(winding->vertices.size(), 3u);
}

TEST(TemplateCheck, HelpersUnusedAndDoubledVerticesAreNamed) {
    TriMesh mesh = face_like();
    const Index n = mesh.vertices.rows();
    mesh.vertices.conservativeResize(n + 5, 3);
    mesh.vertices.row(n) << 60, 0, 0;
    mesh.vertices.row(n + 1) << 61, 0, 0;
    mesh.vertices.row(n + 2) << 60, 1, 0;
    mesh.vertices.row(n + 3) << 0, 60, 0;
    mesh.vertices.row(n + 4) = mesh.vertices.row(3);
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 2, 3);
    mesh.triangles.row(mesh.triangles.rows() - 2) << static_cast<std::uint32_t>(n),
        static_cast<std::uint32_t>(n + 1), static_cast<std::uint32_t>(n + 2);
    mesh.triangles.row(mesh.triangles.rows() - 1) << 0, 0, 1;
    const std::vector<TemplateFinding> findings = check(mesh);
    ASSERT_NE(find(findings, "helpers"), nullptr);
    EXPECT_EQ(find(findings, "helpers")->vertices.front(), static_cast<std::uint32_t>(n));
    ASSERT_NE(find(findings, "unused"), nullptr);
    EXPECT_EQ(find(findings, "unused")->vertices.size(), 2u);
    ASSERT_NE(find(findings, "seams"), nullptr);
    EXPECT_EQ(find(findings, "seams")->vertices,
              std::vector<std::uint32_t>{static_cast<std::uint32_t>(n + 4)});
    ASSERT_NE(find(findings, "degenerate"), nullptr);
    EXPECT_EQ(find(findings, "degenerate")->kind, FindingKind::error);
}

TEST(TemplateCheck, AnAsymmetricVertexIsNamedWhenSymmetryIsAskedFor) {
    TriMesh mesh = face_like();
    mesh.vertices(40, 2) += 30;
    TemplateCheckOptions options;
    EXPECT_EQ(find(check(mesh, options), "symmetry"), nullptr);
    options.mirror = true;
    const std::vector<TemplateFinding> findings = check(mesh, options);
    const TemplateFinding* symmetry = find(findings, "symmetry");
    ASSERT_NE(symmetry, nullptr);
    EXPECT_NE(std::find(symmetry->vertices.begin(), symmetry->vertices.end(), 40u),
              symmetry->vertices.end());
}

TEST(TemplateCheck, PoseSidesAndClosedEyesAreSeenByLandmarks) {
    TemplateCheckOptions options;
    options.landmarks = features();
    TriMesh mesh = face_like();
    const std::vector<TemplateFinding> upright = check(mesh, options);
    EXPECT_EQ(find(upright, "pose"), nullptr) << template_findings_json(upright);
    EXPECT_EQ(find(upright, "left-right"), nullptr);
    ASSERT_NE(find(upright, "closed"), nullptr);  // nothing is cut out at the eyes
    options.landmarks = features(true);
    EXPECT_NE(find(check(mesh, options), "left-right"), nullptr);
    options.landmarks = features();
    mesh.vertices.col(0) *= -1, mesh.vertices.col(1) *= -1;  // upside down
    EXPECT_NE(find(check(mesh, options), "pose"), nullptr);
    options.landmarks.push_back({"far", 100000});
    EXPECT_THROW(check(mesh, options), Error);
}

}  // namespace
