#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "measure/random.hpp"
#include "measure/score_model.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

// Ellipsoids that differ by smooth random modes; a hidden bulge low on one side grows with the
// score.
struct Study {
    TriMesh mesh;
    Points bulge;
    Vector truth, grades;
    std::string path;

    explicit Study(int count, double grade_noise) {
        mesh = test::sphere(1, 3);
        mesh.vertices.col(0) *= 60;
        mesh.vertices.col(1) *= 90;
        mesh.vertices.col(2) *= 75;
        bulge = Points::Zero(mesh.vertices.rows(), 3);
        for (Index v = 0; v < bulge.rows(); ++v) {
            const double d = (mesh.vertices.row(v) - Eigen::RowVector3d(20, -60, 45)).norm();
            bulge.row(v) = Eigen::RowVector3d(0, -1, 0.5) * 2.5 * std::exp(-d * d / 800);
        }
        SplitMix random(17);
        FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral"});
        truth.resize(count);
        grades.resize(count);
        for (int k = 0; k < count; ++k) {
            truth[k] = 4 * random.uniform();
            grades[k] = truth[k] + grade_noise * random.normal();
            writer.add(face(truth[k], random), k, 0);
        }
        path = ::testing::TempDir() + "mien_score_study.safetensors";
        writer.save(path, {});
    }
    ~Study() { std::remove(path.c_str()); }

    Points face(double score, SplitMix& random) const {
        Points points = mesh.vertices + score * bulge;
        for (int mode = 0; mode < 6; ++mode) {
            const double amount = random.normal(), a = 0.02 + 0.006 * mode;
            for (Index v = 0; v < points.rows(); ++v)
                points.row(v) += amount * std::sin(a * mesh.vertices(v, mode % 3) + mode) *
                                 mesh.vertices.row(v).normalized();
        }
        return points;
    }
    FaceDataset open() const { return FaceDataset::open(path, {}, {}); }
};

ScoreOptions quick() {
    ScoreOptions options;
    options.curvature_share = 0.3;
    options.curvature_radius_mm = 30;
    return options;
}

double correlation(const Points& a, const Points& b) {
    return a.cwiseProduct(b).sum() / (a.norm() * b.norm());
}

TEST(Score, FindsTheHiddenBulgeAndPredictsHeldOutFaces) {
    const Study study(100, 0.3);
    const ScoreModel model = train_score(study.open(), study.grades, quick(), {});
    EXPECT_GT(model.q2, 0.7);
    EXPECT_GT(correlation(model.unit_displacement, study.bulge), 0.9);
    SplitMix random(99);
    int covered = 0;
    double square = 0;
    for (int k = 0; k < 40; ++k) {
        const double truth = 4 * random.uniform();
        const ScorePrediction p = predict_score(model, study.face(truth, random), {});
        covered += p.low95 <= truth && truth <= p.high95;
        square += (p.score - truth) * (p.score - truth) / 40;
    }
    EXPECT_GE(covered, 36);
    EXPECT_LT(std::sqrt(square), 0.7);
}

TEST(Score, RefusesGradesThatAreAllTheSame) {
    const Study study(20, 0.2);
    EXPECT_EQ(
        test::status_of([&] { train_score(study.open(), Vector::Constant(20, 2.0), quick(), {}); }),
        Status::no_solution);
}

TEST(Score, IgnoresWhereTheFaceStandsAndReachesTheScoreItSimulates) {
    const Study study(40, 0.2);
    ScoreOptions options = quick();
    options.curvature_share = 0;
    const ScoreModel model = train_score(study.open(), study.grades, options, {});
    SplitMix random(5);
    const Points face = study.face(1.0, random);
    Points moved = face.rowwise() + Eigen::RowVector3d(300, -20, 50);
    const double own = predict_score(model, face, {}).score;
    EXPECT_NEAR(predict_score(model, moved, {}).score, own, 1e-6);
    const Points older = simulate_score(model, moved, own + 1.0, {});
    EXPECT_NEAR(predict_score(model, older, {}).score, own + 1.0, 0.3);
    EXPECT_LT((older - moved).rowwise().norm().maxCoeff(), 20);
}

TEST(Score, SurvivesItsFileAndRefusesOtherTopologies) {
    const Study study(30, 0.2);
    const ScoreModel model = train_score(study.open(), study.grades, quick(), {});
    const std::string path = ::testing::TempDir() + "mien_score_model.safetensors";
    save_score_model(path, model, {});
    const ScoreModel again = load_score_model(path, {}, {});
    std::remove(path.c_str());
    SplitMix random(5);
    const Points face = study.face(3.0, random);
    EXPECT_EQ(predict_score(again, face, {}).score, predict_score(model, face, {}).score);
    EXPECT_EQ(predict_score(again, face, {}).high95, predict_score(model, face, {}).high95);
    const TriMesh other = test::sphere(50, 2);
    EXPECT_EQ(test::status_of([&] { predict_score(again, other.vertices, {}); }), Status::mismatch);
}

TEST(Score, AllSeventeenFeaturesLearnTooAndSurviveTheirFile) {
    const Study study(60, 0.2);
    ScoreOptions options = quick();
    options.features = ScoreFeatures::all;
    const ScoreModel model = train_score(study.open(), study.grades, options, {});
    EXPECT_EQ(model.feature_mean.size(), 17 * study.mesh.vertices.rows());
    EXPECT_GT(model.q2, 0.8);
    EXPECT_GT(model.shape_scale.minCoeff(), 0);
    const std::string path = ::testing::TempDir() + "mien_score_all.safetensors";
    save_score_model(path, model, {});
    const ScoreModel loaded = load_score_model(path, {}, {});
    SplitMix random(5);
    const Points face = study.face(2.5, random);
    EXPECT_EQ(predict_score(loaded, face, {}).score, predict_score(model, face, {}).score);
    EXPECT_NEAR(predict_score(model, face, {}).score, 2.5, 1.0);
}

TEST(Score, LeavesOutUngradedFacesAndRefusesTooFew) {
    const Study study(30, 0.2);
    Vector grades = study.grades;
    for (Index k = 0; k < 10; ++k) grades[k] = std::nan("");
    EXPECT_EQ(train_score(study.open(), grades, quick(), {}).num_samples, 20);
    grades.head(26).setConstant(std::nan(""));
    EXPECT_EQ(test::status_of([&] { train_score(study.open(), grades, quick(), {}); }),
              Status::invalid_argument);
    EXPECT_EQ(test::status_of([&] { train_score(study.open(), Vector::Ones(3), quick(), {}); }),
              Status::mismatch);
}

}  // namespace
}  // namespace mien
