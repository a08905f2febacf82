#include "registration/evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "geometry/normals.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

Matrix3 precision_of(const FitTerms& terms, Index row) {
    const auto h = terms.precision.row(row).cast<double>();
    Matrix3 m;
    m << h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2];
    return m;
}

// A face, its own sheet raised by a millimetre as the scan, and a round of a fit at rest that looks
// at every vertex.
struct Scene {
    SmallFace face = small_face(20);
    ScanSurface surface;
    std::vector<std::uint8_t> inner;
    ColorFeatures colors;
    std::vector<Pin> pins;
    FitState state;
    Points normals;
    std::vector<Index> rows;
    Correspondences matches;

    explicit Scene(const TriMesh& scan) {
        surface = build_scan_surface(scan, {}, {});
        const Points& rest = face.model.template_mesh.vertices;
        inner.assign(static_cast<std::size_t>(rest.rows()), 0);
        state.places = rest;
        state.displacement = Points::Zero(rest.rows(), 3);
        normals = vertex_normals(rest, face.model.template_mesh.triangles);
        for (Index i = 0; i < rest.rows(); ++i) rows.push_back(i);
        find_correspondences(surface, rest, normals, {}, matches, {});
    }

    FitTerms terms_of(EvidenceFactory make, const EvidenceSettings& settings = {}) {
        const ScanView view(surface);
        const FitProblem problem{face.model, view, inner, colors, pins};
        const Similarity to_model;
        const CorrespondenceSettings match;
        FitTerms terms;
        terms.reset(static_cast<Index>(rows.size()));
        if (const auto term = make(problem, settings))
            term->add({problem, state, to_model, normals, rows, rows, matches, match, 1.0, 1},
                      terms, {});
        return terms;
    }

    std::vector<std::string> kinds(const EvidenceSettings& settings = {}) {
        const ScanView view(surface);
        const FitProblem problem{face.model, view, inner, colors, pins};
        std::vector<std::string> names;
        for (const auto& term : make_evidence(problem, settings)) names.push_back(term->name());
        return names;
    }
};

TriMesh raised_sheet() {
    TriMesh sheet = face_sheet(40);
    sheet.vertices.col(2).array() += 1;
    return sheet;
}

// A zone of lips, and a scan with red ones that have gone up by 3 mm.
void paint_lips(Scene& scene) {
    DeformationModel& model = scene.face.model;
    const Points &rest = model.template_mesh.vertices, &places = scene.surface.vertices;
    Zone lips{"lips", {}};
    const auto inside = [](double x, double y) {
        return x * x / 900 + (y + 35) * (y + 35) / 200 < 1;
    };
    for (Index i = 0; i < rest.rows(); ++i)
        if (inside(rest(i, 0), rest(i, 1))) lips.vertices.push_back(static_cast<std::uint32_t>(i));
    model.zones.push_back(lips);
    Colors seen(places.rows(), 3);
    for (Index i = 0; i < places.rows(); ++i) {
        const std::uint8_t green = inside(places(i, 0), places(i, 1) - 3) ? 90 : 160;
        seen.row(i) << 200, green, 130;
    }
    scene.surface.colors = color_signals(seen, {});
    scene.colors = ColorFeatures(model, scene.inner, {}, {});
}

TEST(Evidence, OnlyWhatTheProblemHasAndTheSettingsAskForIsMade) {
    Scene scene(raised_sheet());
    EXPECT_EQ(scene.kinds(), (std::vector<std::string>{"surface", "bend"}));
    scene.pins.push_back({5, Vector3(0, 0, 60), 2});
    paint_lips(scene);
    EXPECT_EQ(scene.kinds(), (std::vector<std::string>{"surface", "bend", "landmarks", "colors"}));
    EvidenceSettings settings;
    settings.bend.normal_length_mm = 0;
    settings.color.weight = 0;
    EXPECT_EQ(scene.kinds(settings), (std::vector<std::string>{"surface", "landmarks"}));
    scene.surface.colors.resize(0, 2);
    EXPECT_EQ(scene.kinds(), (std::vector<std::string>{"surface", "bend", "landmarks"}));
}

TEST(Evidence, OfLandmarksHoldsPinnedVerticesAlone) {
    Scene scene(raised_sheet());
    const Vector3 place(1, 2, 70);
    scene.pins.push_back({17, place, 2});
    const FitTerms terms = scene.terms_of(make_landmark_evidence);
    EXPECT_LT((precision_of(terms, 17) - 0.25 * Matrix3::Identity()).norm(), 1e-6);
    const Vector3 rest = scene.face.model.template_mesh.vertices.row(17).transpose();
    EXPECT_LT((terms.pull.row(17).transpose().cast<double>() - 0.25 * (place - rest)).norm(), 1e-4);
    FitTerms others = terms;
    others.precision.row(17).setZero();
    others.pull.row(17).setZero();
    EXPECT_EQ(others.precision.cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(others.pull.cwiseAbs().maxCoeff(), 0);
}

TEST(Evidence, OfTheSurfaceIsStiffAcrossItAndSoftAlongIt) {
    Scene scene(raised_sheet());
    EvidenceSettings settings;
    settings.surface.weight = 0.5;
    settings.surface.tangential = 0.1;
    const FitTerms terms = scene.terms_of(make_surface_evidence, settings);
    const Index middle = 10 * 21 + 4;  // off the nose
    ASSERT_GT(scene.matches.weight[middle], 0);
    const Matrix3 h = precision_of(terms, middle);
    const Vector3 normal = scene.matches.normals.row(middle).transpose();
    const double across = normal.dot(h * normal);
    EXPECT_NEAR(across, 0.5 * scene.matches.weight[middle], 1e-5);
    const Vector3 along = normal.unitOrthogonal();
    EXPECT_NEAR(along.dot(h * along), 0.1 * across, 1e-5);
    EXPECT_GT(terms.pull(middle, 2), 0) << "the scan lies above";
}

// A plane looks the same wherever one stands on it.
TEST(Evidence, OfBendingSaysNothingOnAPlaneAndPullsAlongABend) {
    TriMesh plane = face_sheet(40);
    plane.vertices.col(2).setConstant(61);
    EXPECT_LT(Scene(plane).terms_of(make_bend_evidence).precision.cwiseAbs().maxCoeff(), 1e-9);

    // A cylinder, and vertices whose normals are those of 3 mm further along it.
    TriMesh bent = face_sheet(40);
    const auto height = [](double x) { return std::sqrt(80.0 * 80.0 - x * x); };
    for (Index i = 0; i < bent.vertices.rows(); ++i)
        bent.vertices(i, 2) = height(bent.vertices(i, 0));
    Scene scene(bent);
    const Index vertex = 10 * 21 + 10;
    Points& places = scene.state.places;
    for (Index i = 0; i < places.rows(); ++i) {
        places(i, 2) = height(places(i, 0));
        scene.normals.row(i) = Eigen::RowVector3d(places(i, 0) + 3, 0, places(i, 2)).normalized();
    }
    scene.face.model.template_mesh.vertices = places;
    find_correspondences(scene.surface, places, scene.normals, {}, scene.matches, {});
    const FitTerms terms = scene.terms_of(make_bend_evidence);
    const Matrix3 h = precision_of(terms, vertex);
    EXPECT_GT(h(0, 0), 20 * h(1, 1)) << "it bends along x alone";
    EXPECT_NEAR(terms.pull(vertex, 0) / h(0, 0), 3, 0.5) << "that is where its normal belongs";
}

TEST(Evidence, OfColorsKnowsTheDirectionOfTheGradientAlone) {
    Scene scene(raised_sheet());
    paint_lips(scene);
    const FitTerms terms = scene.terms_of(make_color_evidence);
    Index asked = 0;
    double up = 0;
    for (Index row = 0; row < terms.pull.rows(); ++row) {
        const Matrix3 h = precision_of(terms, row);
        if (!(h.trace() > 0)) continue;
        ++asked;
        const Vector3 values = Eigen::SelfAdjointEigenSolver<Matrix3>(h).eigenvalues();
        EXPECT_LT(values[1], 1e-3 * values[2] + 1e-9);
        up += terms.pull(row, 1);
    }
    EXPECT_GT(asked, 20);
    EXPECT_GT(up, 0);
}

// A kind of its own, as somebody who extends the room would write it.
TEST(Evidence, AKindIsOneClassWithOneFunction) {
    struct Gravity final : EvidenceTerm {
        const char* name() const override { return "gravity"; }
        void add(const EvidenceRound& round, FitTerms& terms, const Context&) override {
            for (std::size_t row = 0; row < round.vertex_of.size(); ++row)
                terms.add(static_cast<Index>(row), Matrix3::Zero(), Vector3(0, -1, 0));
        }
    };
    Scene scene(raised_sheet());
    const FitTerms terms = scene.terms_of(
        [](const FitProblem&, const EvidenceSettings&) -> std::unique_ptr<EvidenceTerm> {
            return std::make_unique<Gravity>();
        });
    EXPECT_EQ(terms.pull.col(1).maxCoeff(), -1);
    EXPECT_EQ(terms.precision.cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace mien
