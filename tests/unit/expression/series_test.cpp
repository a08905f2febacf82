#include "expression/visits.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/training.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::study;
using test::trained_model;

/// Vertex by vertex, as faces in true correspondence are.
VisitsOptions series_by_vertex() {
    VisitsOptions options;
    options.noise = JointNoise::isotropic;
    return options;
}

TEST(Series, SharesOneIdentityAndBeatsEachScanAlone) {
    double alone = 0, together = 0;
    for (int subject = 60; subject < 68; ++subject) {
        std::vector<VisitFace> scans;
        for (int expression = 1; expression < 5; ++expression) {
            scans.push_back({study().face(subject, expression), Vector()});
            alone += 0.25 * mean_distance(neutralize(Context(), trained_model<8>(),
                                                     scans.back().vertices, Vector(), {})
                                              .neutral_vertices,
                                          study().neutral(subject));
        }
        const VisitsResult result =
            neutralize_visits(Context(), trained_model<8>(), scans, series_by_vertex());
        together += mean_distance(result.shared_vertices, study().neutral(subject));
        ASSERT_EQ(result.neutral_vertices.size(), 4u);
        ASSERT_EQ(result.components.size(), 4u);
    }
    EXPECT_LT(together, 0.8 * alone);
}

TEST(Series, WeightsOfOneEqualNoWeights) {
    std::vector<VisitFace> plain, weighted;
    for (int expression = 1; expression < 4; ++expression) {
        plain.push_back({study().face(61, expression), Vector()});
        weighted.push_back({study().face(61, expression), Vector::Ones(study().rest.rows())});
    }
    const VisitsResult a =
        neutralize_visits(Context(), trained_model<8>(), plain, series_by_vertex());
    const VisitsResult b =
        neutralize_visits(Context(), trained_model<8>(), weighted, series_by_vertex());
    EXPECT_LT(mean_distance(a.shared_vertices, b.shared_vertices), 1e-3);
}

TEST(Series, AChangeInTheTreatedZoneIsKept) {
    const Points before = study().face(62, 2);
    // A swelling that resembles an expression: where "open" moves the face.
    const Points swelling = study().bump(60, 20, 18, Vector3(0, -6, 2));
    std::vector<VisitFace> scans = {{before, Vector()},
                                    {study().face(62, 3), Vector()},
                                    {study().neutral(62) + swelling, Vector()}};
    VisitsOptions options = series_by_vertex();
    const VisitsResult plain = neutralize_visits(Context(), trained_model<8>(), scans, options);
    for (Index i = 0; i < study().rest.rows(); ++i)
        if (swelling.row(i).norm() > 0.3) options.treated.push_back(static_cast<std::uint32_t>(i));
    const VisitsResult kept = neutralize_visits(Context(), trained_model<8>(), scans, options);
    const Points truth = study().neutral(62) + swelling;
    EXPECT_LT(mean_distance(kept.neutral_vertices[2], truth),
              0.5 * mean_distance(plain.neutral_vertices[2], truth) + 0.02);
}

TEST(Series, AHoleInOneScanIsFilledFromTheOthers) {
    std::vector<VisitFace> scans;
    for (int expression = 1; expression < 4; ++expression)
        scans.push_back({study().face(63, expression), Vector()});
    VisitFace torn{study().face(63, 4), Vector::Ones(study().rest.rows())};
    for (Index i = 40; i < 60; ++i) {
        torn.weights[i] = 0.0;
        torn.vertices.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    scans.push_back(torn);
    const VisitsResult result =
        neutralize_visits(Context(), trained_model<8>(), scans, series_by_vertex());
    ASSERT_TRUE(result.neutral_vertices[3].allFinite());
    const Points truth = study().neutral(63);
    EXPECT_LT(
        mean_distance(result.neutral_vertices[3].middleRows(40, 20), truth.middleRows(40, 20)),
        0.3);
}

TEST(Series, SaysWhenAFaceIsAnotherPersons) {
    std::vector<VisitFace> scans = {{study().face(64, 1), Vector()},
                                    {study().face(64, 2), Vector()},
                                    {study().face(64, 3), Vector()}};
    const VisitsResult same =
        neutralize_visits(Context(), trained_model<8>(), scans, series_by_vertex());
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(visit_warnings(trained_model<8>(), same, k).empty()) << k;
    scans.push_back({study().face(65, 2), Vector()});
    const VisitsResult mixed =
        neutralize_visits(Context(), trained_model<8>(), scans, series_by_vertex());
    EXPECT_FALSE(visit_warnings(trained_model<8>(), mixed, 3).empty());
}

TEST(Series, LargerMeshesFollowBehindTheRim) {
    std::vector<std::shared_ptr<const TriMesh>> same, larger;
    for (int expression = 1; expression < 4; ++expression) {
        auto mesh = std::make_shared<TriMesh>();
        mesh->vertices = study().face(66, expression);
        mesh->triangles = study().triangles;
        same.push_back(mesh);
        // A collar: each vertex of the first row once more, 10 mm below.
        auto collared = std::make_shared<TriMesh>(*mesh);
        const Index n = mesh->vertices.rows(), side = study().side;
        collared->vertices.conservativeResize(n + side, 3);
        for (Index k = 0; k < side; ++k)
            collared->vertices.row(n + k) = study().rest.row(k) - Vector3(0, 10, 0).transpose();
        const Index m = collared->triangles.rows();
        collared->triangles.conservativeResize(m + 2 * (side - 1), 3);
        for (std::uint32_t k = 0; k + 1 < static_cast<std::uint32_t>(side); ++k) {
            const std::uint32_t below = static_cast<std::uint32_t>(n) + k;
            collared->triangles.row(m + 2 * k) << k, below + 1, k + 1;
            collared->triangles.row(m + 2 * k + 1) << k, below, below + 1;
        }
        larger.push_back(collared);
    }
    const VisitsResult a =
        neutralize_visit_meshes(Context(), trained_model<8>(), same, {}, series_by_vertex());
    const VisitsResult b =
        neutralize_visit_meshes(Context(), trained_model<8>(), larger, {}, series_by_vertex());
    const Index n = study().rest.rows();
    ASSERT_EQ(b.neutral_vertices[1].rows(), n + study().side);
    ASSERT_EQ(b.shared_vertices.rows(), n + study().side);
    EXPECT_LT((a.neutral_vertices[1] - b.neutral_vertices[1].topRows(n)).cwiseAbs().maxCoeff(),
              1e-9);
    EXPECT_LT((b.neutral_vertices[1].bottomRows(study().side) -
               larger[1]->vertices.bottomRows(study().side))
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              5.0);
    EXPECT_THROW(neutralize_visit_meshes(Context(), trained_model<8>(), {same[0], larger[1]}, {},
                                         series_by_vertex()),
                 Error);
    EXPECT_THROW(neutralize_visit_meshes(Context(), trained_model<8>(), larger, {Vector()},
                                         series_by_vertex()),
                 Error);
    EXPECT_THROW(neutralize_visit_meshes(Context(), trained_model<8>(), {}, {}, series_by_vertex()),
                 Error);
    VisitsOptions wrong = series_by_vertex();
    wrong.treated = {100000};
    EXPECT_THROW(neutralize_visit_meshes(Context(), trained_model<8>(), larger, {}, wrong), Error);
}

TEST(Series, RefusesNothingAndFitsWithoutAPrior) {
    EXPECT_THROW(neutralize_visits(Context(), trained_model<8>(), {}, series_by_vertex()), Error);
    VisitsOptions options = series_by_vertex();
    options.fit.method = FitMethod::exact;
    const VisitFace face{study().face(60, 1), Vector()};
    EXPECT_THROW(neutralize_visits(Context(), trained_model<8>(), {face, face}, options), Error);
}

}  // namespace
}  // namespace mien
