// Neutralization beyond the model's own vertices: larger templates, raw scans, poses, random faces.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/error.hpp"
#include "expression/neutralize_mesh.hpp"
#include "expression/sampling.hpp"
#include "expression/scan_transfer.hpp"
#include "expression/training.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::mean_distance;
using test::study;
using test::trained_model;

/// The study's face with `rows` more rows of vertices behind its upper rim.
TriMesh enlarged(const Points& face, int rows) {
    const int side = study().side;
    TriMesh mesh;
    mesh.vertices.resize(face.rows() + rows * side, 3);
    mesh.vertices.topRows(face.rows()) = face;
    for (int r = 0; r < rows; ++r)
        for (int x = 0; x < side; ++x)
            mesh.vertices.row(face.rows() + r * side + x) =
                face.row((side - 1) * side + x) + Eigen::RowVector3d(0, 10.0 * (r + 1), 0);
    mesh.triangles.resize(study().triangles.rows() + 2 * rows * (side - 1), 3);
    mesh.triangles.topRows(study().triangles.rows()) = study().triangles;
    Index t = study().triangles.rows();
    for (int r = 0; r < rows; ++r)
        for (int x = 0; x + 1 < side; ++x) {
            const std::uint32_t a = static_cast<std::uint32_t>((side - 1 + r) * side + x);
            const std::uint32_t s = static_cast<std::uint32_t>(side);
            mesh.triangles.row(t++) << a, a + 1, a + s;
            mesh.triangles.row(t++) << a + 1, a + s + 1, a + s;
        }
    return mesh;
}

TEST(NeutralizeMesh, LargerTemplatesMoveSmoothlyBehindTheRim) {
    const Points face = study().face(80, 4);  // "raise" moves the upper rim
    const TriMesh mesh = enlarged(face, 8);
    const Points neutral =
        neutralize_mesh(Context(), trained_model<10>(), mesh, Vector(), {}).neutral_vertices;
    EXPECT_TRUE(neutral.topRows(face.rows()) ==
                neutralize(Context(), trained_model<10>(), face, Vector(), {}).neutral_vertices);
    const Points moved = neutral - mesh.vertices;
    const int side = study().side;
    auto row_mean = [&](Index row) {
        return moved.middleRows(row * side, side).rowwise().norm().mean();
    };
    EXPECT_GT(row_mean(side), 0.3 * row_mean(side - 1));
    for (int r = side; r + 1 < side + 8; ++r) EXPECT_LT(row_mean(r + 1), row_mean(r));
    EXPECT_LT(row_mean(side + 7), 0.3 * row_mean(side - 1));
}

TEST(NeutralizeMesh, AForeignTopologyIsRefused) {
    TriMesh mesh = enlarged(study().face(80, 4), 2);
    mesh.triangles(3, 1) = 0;
    EXPECT_EQ(match_topology(trained_model<10>(), mesh.vertices.rows(), mesh.triangles),
              TopologyMatch::none);
    try {
        neutralize_mesh(Context(), trained_model<10>(), mesh, Vector(), {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::mismatch);
    }
}

TEST(Neutralize, RigidMotionOfTheInputMovesTheResultAlong) {
    const Points face = study().face(81, 2);
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 1).normalized()).toRotationMatrix();
    motion.translation = Vector3(200, -50, 90);
    NeutralizeOptions rigid;
    rigid.pose = Pose::rigid;
    const Points here =
        neutralize(Context(), trained_model<10>(), face, Vector(), rigid).neutral_vertices;
    const Points there =
        neutralize(Context(), trained_model<10>(), motion.apply(PointsRef(face)), Vector(), rigid)
            .neutral_vertices;
    EXPECT_LT(mean_distance(motion.apply(PointsRef(here)), there), 1e-3);
    // Without being told, a face that lies far away is found out.
    const Points found =
        neutralize(Context(), trained_model<10>(), motion.apply(PointsRef(face)), Vector(), {})
            .neutral_vertices;
    EXPECT_LT(mean_distance(found, there), 1e-9);
    EXPECT_LT(mean_distance(here, study().neutral(81)),
              0.6 * mean_distance(face, study().neutral(81)));
}

TEST(ScanTransfer, AScanThatIsTheFaceItselfMovesLikeTheFace) {
    TriMesh fitted;
    fitted.vertices = study().face(82, 1);
    fitted.triangles = study().triangles;
    const Points neutral =
        neutralize(Context(), trained_model<10>(), fitted.vertices, Vector(), {}).neutral_vertices;
    TriMesh scan = fitted;
    scan.colors = Colors::Constant(scan.vertices.rows(), 3, 99);
    ScanTransferOptions options;
    options.smoothing_mm = 0.0;
    const ScanTransferResult result = transfer_to_scan(Context(), fitted, neutral, scan, options);
    EXPECT_LT(mean_distance(result.scan.vertices, neutral), 1e-6);
    EXPECT_TRUE(result.scan.colors == scan.colors);
    EXPECT_TRUE(result.scan.triangles == scan.triangles);
    EXPECT_EQ(result.num_far_vertices, 0);
}

TEST(ScanTransfer, FarPartsKeepTheirShape) {
    TriMesh fitted;
    fitted.vertices = study().rest;
    fitted.triangles = study().triangles;
    // The whole face turns; a flap that stands 60 mm off its rim must turn with it, rigidly.
    Similarity turn;
    turn.rotation = Eigen::AngleAxisd(0.1, Vector3(0, 0, 1)).toRotationMatrix();
    const Points neutral = turn.apply(PointsRef(fitted.vertices));
    TriMesh scan = enlarged(study().rest, 6);
    for (Index i = study().rest.rows(); i < scan.vertices.rows(); ++i)
        scan.vertices(i, 2) +=
            8.0 * (1.0 + static_cast<double>(i - study().rest.rows()) / study().side);
    const ScanTransferResult result = transfer_to_scan(Context(), fitted, neutral, scan, {});
    EXPECT_GT(result.num_far_vertices, 0);
    const Points expected = turn.apply(PointsRef(scan.vertices));
    // The flap moves by up to 19 mm; where it passes over into the face the two motions blend.
    EXPECT_LT((result.scan.vertices - expected).rowwise().norm().maxCoeff(), 1.5);
    EXPECT_LT(
        (result.scan.vertices - expected).bottomRows(2 * study().side).rowwise().norm().maxCoeff(),
        1.0);
}

TEST(ScanTransfer, PointCloudsAndDetachedPiecesAreTaken) {
    TriMesh fitted;
    fitted.vertices = study().rest;
    fitted.triangles = study().triangles;
    TriMesh cloud;
    cloud.vertices = study().rest;
    const Points neutral = (study().rest.rowwise() + Eigen::RowVector3d(1, 2, 3)).eval();
    EXPECT_LT(mean_distance(transfer_to_scan(Context(), fitted, neutral, cloud, {}).scan.vertices,
                            neutral),
              1e-9);
    EXPECT_THROW(transfer_to_scan(Context(), fitted, neutral.topRows(5), cloud, {}), Error);
}

TEST(Sampling, RandomFacesFollowTheModelAndTheirSeed) {
    EXPECT_TRUE(sample_face(Context(), trained_model<10>(), 5, "open") ==
                sample_face(Context(), trained_model<10>(), 5, "open"));
    EXPECT_FALSE(sample_face(Context(), trained_model<10>(), 5, "open") ==
                 sample_face(Context(), trained_model<10>(), 6, "open"));
    const Index people = trained_model<10>().num_people_modes();
    Vector sum = Vector::Zero(people), square = sum;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const Vector all = sample_coordinates(trained_model<10>(), seed, "")
                               .identity.cwiseQuotient(trained_model<10>().identity_deviations);
        EXPECT_TRUE(all.tail(all.size() - people).isZero(0.0)) << "no person showed these";
        const Vector z = all.head(people);
        sum += z;
        square += z.cwiseAbs2();
    }
    EXPECT_LT((sum / 400).cwiseAbs().maxCoeff(), 0.2);
    EXPECT_LT((square / 400 - Vector::Ones(sum.size())).cwiseAbs().maxCoeff(), 0.35);
    EXPECT_THROW(sample_coordinates(trained_model<10>(), 1, "nobody"), Error);
}

TEST(Sampling, TransferredExpressionComesOffAgain) {
    const NeutralizationResult source =
        neutralize(Context(), trained_model<10>(), study().face(83, 1), Vector(), {});
    TriMesh target;
    target.vertices = study().neutral(84);
    target.triangles = study().triangles;
    TriMesh worn = target;
    worn.vertices = transfer_expression(Context(), trained_model<10>(), target, Similarity(),
                                        source.expression);
    EXPECT_GT(mean_distance(worn.vertices, target.vertices), 0.3);
    const Points back =
        neutralize(Context(), trained_model<10>(), worn.vertices, Vector(), {}).neutral_vertices;
    EXPECT_LT(mean_distance(back, target.vertices),
              0.3 * mean_distance(worn.vertices, target.vertices));
}

}  // namespace
}  // namespace mien
