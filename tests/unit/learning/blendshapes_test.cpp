// Representations of a training set, blendshape regression, hierarchies.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/alignment.hpp"
#include "learning/blendshapes.hpp"
#include "learning/hierarchy.hpp"
#include "mesh/decimation.hpp"
#include "spectral/metrics.hpp"
#include "unit/scratch.hpp"
#include "unit/spectral/shapes.hpp"

namespace mien {
namespace {

/// Person k: two smooth identity amplitudes.
Points person(const TriMesh& mesh, Index k) {
    Points face = mesh.vertices;
    const double a = 3 * test::noise(static_cast<std::uint64_t>(7 * k)),
                 b = 3 * test::noise(static_cast<std::uint64_t>(7 * k + 1));
    for (Index v = 0; v < face.rows(); ++v) {
        face(v, 2) +=
            a * std::cos(0.12 * mesh.vertices(v, 0)) + b * std::sin(0.1 * mesh.vertices(v, 1));
        face(v, 0) += 0.3 * b * std::cos(0.15 * mesh.vertices(v, 1));
    }
    return face;
}
/// The expression's strength depends on the person.
Points expressed(const TriMesh& mesh, Index k) {
    Points face = person(mesh, k);
    const double a = 3 * test::noise(static_cast<std::uint64_t>(7 * k));
    for (Index v = 0; v < face.rows(); ++v)
        face(v, 1) += (2 + 0.5 * a) * std::exp(-std::pow(mesh.vertices(v, 1) - 10, 2) / 60);
    return face;
}
FacePairs pairs_of(const TriMesh& mesh, Index first, Index count) {
    FacePairs pairs;
    pairs.count = count;
    pairs.pair = [&mesh, first](Index k, Points& neutral, Points& expression) {
        neutral = person(mesh, first + k);
        expression = expressed(mesh, first + k);
    };
    return pairs;
}

TEST(FaceFeatures, EveryKindHasItsExactInverse) {
    const TriMesh mesh = test::face_like(12);
    FaceSource source;
    source.count = 8;
    source.face = [&](Index k, Points& face) { face = person(mesh, k); };
    for (int kind = 1; kind <= 6; ++kind) {
        const auto features =
            FaceFeatures::train(mesh.triangles, source, static_cast<FeatureKind>(kind), {});
        Similarity motion, away;
        away.rotation = Eigen::AngleAxisd(0.4, Vector3(1, 1, 0).normalized()).toRotationMatrix();
        away.translation << 50, 0, -20;
        const Points face = away.apply(person(mesh, 77));  // not of the training set
        const Features f = features->encode(face, &motion, {});
        const Points back = features->decode(f, &motion, {});
        const Points aligned = align_points(back, face, {}, false).apply(back);
        EXPECT_LT((aligned - face).rowwise().norm().maxCoeff(), 1e-6) << kind;
        if (kind <= 3) {
            EXPECT_LT((back - face).cwiseAbs().maxCoeff(), 1e-9) << kind;
        }
    }
}

TEST(FaceFeatures, NormalisedTrainingFacesFillMinusOneToOne) {
    const TriMesh mesh = test::face_like(10);
    FaceSource source;
    source.count = 6;
    source.face = [&](Index k, Points& face) { face = person(mesh, k); };
    const auto features =
        FaceFeatures::train(mesh.triangles, source, FeatureKind::deformation_normalised, {});
    double low = 0, high = 0;
    for (Index k = 0; k < 6; ++k) {
        const Features f = features->encode(person(mesh, k), nullptr, {});
        low = std::min(low, f.minCoeff());
        high = std::max(high, f.maxCoeff());
    }
    EXPECT_NEAR(low, -1, 1e-6);
    EXPECT_NEAR(high, 1, 1e-6);
}

TEST(FaceFeatures, ConstantFeaturesStayInvertible) {
    FeatureStatistics s = feature_statistics(2, [](Index k) {
        Features f(1, 2);
        f << 5, static_cast<double>(k);
        return f;
    });
    Features f(1, 2);
    f << 6, 0.25;
    Features g = f;
    standardise(s, g);
    destandardise(s, g);
    EXPECT_LT((f - g).norm(), 1e-12);
    normalise(s, g);
    denormalise(s, g);
    EXPECT_LT((f - g).norm(), 1e-12);
}

TEST(FaceFeatures, FileGivesTheSameFeatures) {
    const TriMesh mesh = test::face_like(8);
    FaceSource source;
    source.count = 4;
    source.face = [&](Index k, Points& face) { face = person(mesh, k); };
    const auto features =
        FaceFeatures::train(mesh.triangles, source, FeatureKind::euclidean_standardised, {});
    const mien::testing::ScratchFolder scratch;
    const std::string path = scratch / "features.safetensors";
    features->save(path, {});
    const auto loaded = FaceFeatures::load(path, {}, {});
    EXPECT_TRUE(loaded->encode(person(mesh, 9), nullptr, {}) ==
                features->encode(person(mesh, 9), nullptr, {}));
}

TEST(Blendshapes, PredictNewPeopleBetterThanTheMeanExpression) {
    const TriMesh mesh = test::face_like(12);
    const auto model = BlendshapeModel::train(mesh.triangles, pairs_of(mesh, 0, 15), {}, {});
    double predicted = 0, mean_only = 0;
    for (Index k = 30; k < 36; ++k) {
        const auto p = model->predict(person(mesh, k), {});
        predicted += l1_distance(p.spatial, expressed(mesh, k));
        Points mean = person(mesh, k);
        for (Index i = 0; i < 15; ++i) mean += (expressed(mesh, i) - person(mesh, i)) / 15;
        mean_only += l1_distance(mean, expressed(mesh, k));
        EXPECT_LT(l1_distance(p.differential, expressed(mesh, k)),
                  l1_distance(person(mesh, k), expressed(mesh, k)));
    }
    EXPECT_LT(predicted, 0.2 * mean_only);
}

TEST(Blendshapes, FileGivesTheSamePrediction) {
    const TriMesh mesh = test::face_like(8);
    const auto model = BlendshapeModel::train(mesh.triangles, pairs_of(mesh, 0, 6), {}, {});
    const mien::testing::ScratchFolder scratch;
    const std::string path = scratch / "blendshapes.safetensors";
    model->save(path, {});
    const auto loaded = BlendshapeModel::load(path, {}, {});
    const auto a = model->predict(person(mesh, 20), {}), b = loaded->predict(person(mesh, 20), {});
    EXPECT_LT((a.spatial - b.spatial).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((a.differential - b.differential).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Blendshapes, ParetoFrontHoldsWhatNothingBeats) {
    std::vector<BandChoice> choices(4);
    const double l1[] = {3, 2, 1, 2.5}, f[] = {1, 1.2, 3, 2};
    for (int i = 0; i < 4; ++i) choices[i].l1_mm = l1[i], choices[i].fmpd = f[i];
    mark_front(choices);
    EXPECT_TRUE(choices[0].on_front && choices[1].on_front && choices[2].on_front);
    EXPECT_FALSE(choices[3].on_front);
    EXPECT_TRUE(choices[1].chosen);
}

TEST(Decimation, KeepsVerticesOfTheMeshAndItsShape) {
    const TriMesh mesh = test::sphere(10, 4);
    const DecimatedMesh coarse = decimate(mesh, 600, {});
    EXPECT_LE(coarse.mesh.vertices.rows(), 600);
    EXPECT_GT(coarse.mesh.vertices.rows(), 500);
    for (Index v = 0; v < coarse.mesh.vertices.rows(); ++v)
        EXPECT_TRUE(coarse.mesh.vertices.row(v) ==
                    mesh.vertices.row(coarse.kept[static_cast<std::size_t>(v)]));
    EXPECT_LT(hausdorff_distance(mesh, coarse.mesh, {}), 0.4);
}

TEST(Decimation, DoesNotPullBordersInwards) {
    const TriMesh mesh = test::grid(10, 10, 20, 20);
    const DecimatedMesh coarse = decimate(mesh, 50, {});
    for (const double corner : {0.0, 10.0}) {
        EXPECT_NEAR(corner == 0.0 ? coarse.mesh.vertices.col(0).minCoeff()
                                  : coarse.mesh.vertices.col(0).maxCoeff(),
                    corner, 1e-12);
        EXPECT_NEAR(corner == 0.0 ? coarse.mesh.vertices.col(1).minCoeff()
                                  : coarse.mesh.vertices.col(1).maxCoeff(),
                    corner, 1e-12);
    }
}

TEST(Decimation, RefusesNonManifoldMeshes) {
    TriMesh mesh = test::grid(2, 2, 2, 2);
    mesh.vertices.conservativeResize(10, 3);
    mesh.vertices.row(9) << 0, 0, 5;
    mesh.triangles.conservativeResize(9, 3);
    mesh.triangles.row(8) << mesh.triangles(0, 0), mesh.triangles(0, 1), 9;
    mesh.triangles.conservativeResize(10, 3);
    mesh.triangles.row(9) << mesh.triangles(0, 1), mesh.triangles(0, 0), 9;
    EXPECT_EQ(test::status_of([&] { decimate(mesh, 5, {}); }), Status::invalid_mesh);
}

TEST(Hierarchy, MapsKeepConstantsAndPlaces) {
    const TriMesh mesh = test::face_like(24);
    for (const auto& levels :
         {quadric_hierarchy(mesh, 3, 3.0, {}), connectivity_hierarchy(mesh, 3, 2, 2, {})}) {
        ASSERT_EQ(levels->levels.size(), 4u);
        for (std::size_t l = 1; l < levels->levels.size(); ++l) {
            const MeshLevel& level = levels->levels[l];
            const Index fine = levels->levels[l - 1].mesh.vertices.rows(),
                        coarse = level.mesh.vertices.rows();
            EXPECT_LT(coarse, fine);
            EXPECT_LT(
                (level.down * Vector::Ones(fine) - Vector::Ones(coarse)).cwiseAbs().maxCoeff(),
                1e-12);
            EXPECT_LT((level.up * Vector::Ones(coarse) - Vector::Ones(fine)).cwiseAbs().maxCoeff(),
                      1e-12);
            // Up after down stays near the face: each vertex comes from its neighbourhood.
            const Points& x = levels->levels[l - 1].mesh.vertices;
            EXPECT_LT((level.up * (level.down * x) - x).rowwise().norm().maxCoeff(),
                      l == 1 ? 8.0 : 25.0);
        }
    }
}

TEST(Hierarchy, ConnectivitySamplesAreStrideApartAndCoverEverything) {
    const TriMesh mesh = test::grid(10, 10, 10, 10);
    const auto levels = connectivity_hierarchy(mesh, 1, 2, 1, {});
    const MeshLevel& level = levels->levels[1];
    // Within one edge of a kept vertex everywhere: no empty column in the map down.
    const Vector reached = level.down.transpose() * Vector::Ones(level.down.rows());
    EXPECT_GT(reached.minCoeff(), 0.0);
    for (const auto a : level.kept)
        for (Index f = 0; f < mesh.triangles.rows(); ++f)
            for (int c = 0; c < 3; ++c)
                if (mesh.triangles(f, c) == a) {
                    EXPECT_EQ(std::count(level.kept.begin(), level.kept.end(),
                                         mesh.triangles(f, (c + 1) % 3)),
                              0);
                }
}

TEST(Hierarchy, FileGivesTheSameMaps) {
    const TriMesh mesh = test::face_like(12);
    const auto levels = quadric_hierarchy(mesh, 2, 4.0, {});
    const mien::testing::ScratchFolder scratch;
    const std::string path = scratch / "levels.safetensors";
    save_mesh_hierarchy(path, *levels, {});
    const auto loaded = load_mesh_hierarchy(path, {}, {});
    ASSERT_EQ(loaded->levels.size(), levels->levels.size());
    for (std::size_t l = 1; l < levels->levels.size(); ++l) {
        EXPECT_EQ((Matrix(loaded->levels[l].up) - Matrix(levels->levels[l].up)).norm(), 0.0);
        EXPECT_EQ(loaded->levels[l].kept, levels->levels[l].kept);
    }
}

}  // namespace
}  // namespace mien
