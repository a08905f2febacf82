#include "spectral/deformation_representation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/safetensors.hpp"
#include "geometry/alignment.hpp"
#include "mesh/mesh_file.hpp"
#include "shapes.hpp"
#include "spectral/deformation_transfer.hpp"

namespace mien {
namespace {

double round_trip_error(const TriMesh& mesh, const Points& face) {
    const DeformationRepresentation dr(mesh, {});
    const Points back = dr.decode(dr.encode(face, {}), {});
    return (align_points(back, face, {}, false).apply(back) - face).rowwise().norm().maxCoeff();
}
Matrix3 turn(double angle) {
    return Eigen::AngleAxisd(angle, Vector3(0.3, -1, 0.6).normalized()).toRotationMatrix();
}

// Sum over the triangles' edges of the relative deviation of x from the mean of both ends' lengths.
double half_way_edge_error(const TriMesh& mesh, const Points& other, const Points& x) {
    double sum = 0;
    for (Index f = 0; f < mesh.triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c) {
            const Index i = mesh.triangles(f, c), j = mesh.triangles(f, (c + 1) % 3);
            const double wanted = 0.5 * ((mesh.vertices.row(i) - mesh.vertices.row(j)).norm() +
                                         (other.row(i) - other.row(j)).norm());
            sum += std::abs((x.row(i) - x.row(j)).norm() / wanted - 1);
        }
    return sum;
}

TEST(PolarDecomposition, IsExactForAnyMatrix) {
    for (int i = 0; i < 20; ++i) {
        const Matrix3 t = Matrix3::Random() * (i % 2 == 0 ? 1 : -1);
        Matrix3 rotation, stretch;
        polar_decomposition(t, rotation, stretch);
        EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
        EXPECT_LT((rotation * stretch - t).norm(), 1e-12);
        EXPECT_LT((stretch - stretch.transpose()).norm(), 1e-14);
    }
}

TEST(PolarDecomposition, RefusesWhatIsNotFinite) {
    Matrix3 rotation, stretch, t = Matrix3::Identity();
    t(1, 2) = std::numeric_limits<double>::quiet_NaN();
    try {
        polar_decomposition(t, rotation, stretch);
        FAIL() << "a matrix with NaN was decomposed";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::no_solution);
    }
}

TEST(RotationLogarithm, IsExactUpToPi) {
    for (const double angle : {0.0, 1e-12, 0.4, 3.0, 3.14159265, 3.141592653589793}) {
        const Matrix3 r = turn(angle);
        EXPECT_LT((rotation_exponential(rotation_logarithm(r)) - r).norm(), 1e-12) << angle;
        EXPECT_NEAR(rotation_logarithm(r).norm(), angle, 1e-9) << angle;
    }
}

TEST(DeformationRepresentation, TemplateIsZeroAndTranslationDoesNotShow) {
    const TriMesh mesh = test::face_like();
    const DeformationRepresentation dr(mesh, {});
    EXPECT_LT(dr.encode(mesh.vertices, {}).cwiseAbs().maxCoeff(), 1e-9);
    const Points moved = mesh.vertices.rowwise() + Eigen::RowVector3d(5, 6, -7);
    EXPECT_LT(dr.encode(moved, {}).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(DeformationRepresentation, RoundTripIsExactForBendsAndNoise) {
    const TriMesh mesh = test::face_like();
    EXPECT_LT(round_trip_error(mesh, test::bent(mesh.vertices, 6)), 1e-8);
    EXPECT_LT(round_trip_error(mesh, test::noisy(mesh.vertices, 0.3)), 1e-6);
}

TEST(DeformationRepresentation, RoundTripIsExactForFlatTemplates) {
    const TriMesh flat = test::grid(10, 10, 9, 7);
    EXPECT_LT(round_trip_error(flat, test::bent(flat.vertices, 1)), 1e-6);
}

TEST(DeformationRepresentation, RotationAndScaleAreTheSameEverywhere) {
    const TriMesh mesh = test::face_like();
    const DeformationRepresentation dr(mesh, {});
    const Matrix3 r = turn(1.1);
    const Points face = 1.3 * mesh.vertices * r.transpose();
    const Features f = dr.encode(face, {});
    const Vector3 expected = rotation_logarithm(r);
    for (Index v = 0; v < f.rows(); ++v) {
        EXPECT_LT((f.row(v).head<3>().transpose() - expected).norm(), 1e-6);
        EXPECT_LT(
            (f.row(v).tail<6>() - (Vector(6) << .3, .3, .3, 0, 0, 0).finished().transpose()).norm(),
            1e-6);
    }
}

TEST(DeformationRepresentation, TurnsBeyondPiStayContinuous) {
    // A strip rolled up by more than a turn.
    const TriMesh strip = test::grid(100, 4, 100, 3);
    Points rolled = strip.vertices;
    for (Index v = 0; v < rolled.rows(); ++v) {
        const double angle = 8.0 * strip.vertices(v, 0) / 100, radius = 100 / 8.0;
        rolled.row(v) << radius * std::sin(angle), strip.vertices(v, 1),
            radius * (1 - std::cos(angle));
    }
    const DeformationRepresentation dr(strip, {});
    const Features f = dr.encode(rolled, {});
    EXPECT_NEAR(f.leftCols<3>().rowwise().norm().maxCoeff(), 8.0, 0.2);
    EXPECT_LT(round_trip_error(strip, rolled), 1e-5);
    // Half of the deformation is half of the roll, not a crumple.
    const Points half = dr.decode(0.5 * f, {});
    double worst = 0;
    for (Index v = 0; v + 1 < 101; ++v)
        worst = std::max(worst, std::abs((half.row(v + 1) - half.row(v)).norm() - 1.0));
    EXPECT_LT(worst, 0.02);
}

TEST(DeformationRepresentation, BeatsEuclideanInterpolationOfARotatedPart) {
    const TriMesh mesh = test::grid(40, 10, 40, 10);
    Points turned = mesh.vertices;  // the right half turns about x = 20 by 80 degrees
    for (Index v = 0; v < turned.rows(); ++v) {
        const double along = turned(v, 0) - 20;
        if (along <= 0) continue;
        const double angle = std::min(1.4, along / 4 * 1.4);
        turned(v, 0) = 20 + along * std::cos(angle);
        turned(v, 2) = along * std::sin(angle);
    }
    const DeformationRepresentation dr(mesh, {});
    const Points half = dr.decode(0.5 * dr.encode(turned, {}), {}),
                 mean = 0.5 * (mesh.vertices + turned);
    EXPECT_LT(half_way_edge_error(mesh, turned, half),
              0.5 * half_way_edge_error(mesh, turned, mean));
}

TEST(DeformationRepresentation, BeatsEuclideanInterpolationOfABentSheetOfThinTriangles) {
    // Columns 0.05 and 1.95 mm wide by turns, so that cotangents differ a hundredfold; rolled by 2
    // rad.
    TriMesh sheet = test::grid(40, 10, 40, 10);
    for (Index v = 0; v < sheet.vertices.rows(); ++v)
        if (std::lround(sheet.vertices(v, 0)) % 2 == 1) sheet.vertices(v, 0) -= 0.95;
    Points rolled = sheet.vertices;
    for (Index v = 0; v < rolled.rows(); ++v) {
        const double angle = 2.0 * sheet.vertices(v, 0) / 40, radius = 40 / 2.0;
        rolled.row(v) << radius * std::sin(angle), sheet.vertices(v, 1),
            radius * (1 - std::cos(angle));
    }
    const DeformationRepresentation dr(sheet, {});
    const Points half = dr.decode(0.5 * dr.encode(rolled, {}), {}),
                 mean = 0.5 * (sheet.vertices + rolled);
    EXPECT_LT(half_way_edge_error(sheet, rolled, half),
              0.5 * half_way_edge_error(sheet, rolled, mean));
}

// Thin triangles at the corners of the mouth once turned their neighbours by radians half-way.
TEST(DeformationRepresentation, BeatsEuclideanInterpolationOfAnOpeningJaw) {
    const std::string folder = std::string(MIEN_SHARED_DATA) + "/ict/";
    if (!std::filesystem::exists(folder + "model.safetensors"))
        GTEST_SKIP() << "needs the shared data";
    const TriMesh mesh = read_mesh_file(folder + "template.ply", {});
    const SafetensorsFile file = SafetensorsFile::open(folder + "model.safetensors", {}, {});
    const auto names = nlohmann::json::parse(file.metadata().at("expression_names"))
                           .get<std::vector<std::string>>();
    const std::size_t jaw =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "jawOpen") - names.begin());
    ASSERT_LT(jaw, names.size());
    const Index n = mesh.vertices.rows();
    const auto* modes = static_cast<const float*>(
        file.tensor("expression_modes", DType::f32, {static_cast<std::int64_t>(names.size()), n, 3})
            .data);
    const Points open =
        mesh.vertices + Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(
                            modes + 3 * n * static_cast<Index>(jaw), n, 3)
                            .cast<double>();
    const DeformationRepresentation dr(mesh, {});
    const Points half = dr.decode(0.5 * dr.encode(open, {}), {}),
                 mean = 0.5 * (mesh.vertices + open);
    EXPECT_LT(half_way_edge_error(mesh, open, half), half_way_edge_error(mesh, open, mean));
}

TEST(DeformationRepresentation, SurvivesDegenerateRingsAndPieces) {
    TriMesh mesh = test::face_like();
    const Index n = mesh.vertices.rows();
    mesh.vertices.row(70) = mesh.vertices.row(71);
    mesh.vertices.conservativeResize(n + 4, 3);
    mesh.vertices.bottomRows(4) << 100, 0, 0, 101, 0, 0, 100, 1, 0, 55, 55,
        55;  // a triangle and a loose vertex
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 1, 3);
    mesh.triangles.bottomRows(1) << static_cast<std::uint32_t>(n),
        static_cast<std::uint32_t>(n + 1), static_cast<std::uint32_t>(n + 2);
    const DeformationRepresentation dr(mesh, {});
    const Points face = test::bent(mesh.vertices, 1);
    const Features f = dr.encode(face, {});
    EXPECT_TRUE(f.allFinite());
    const Points back = dr.decode(f, {});
    const Points a = back.topRows(n), b = face.topRows(n);
    EXPECT_LT((align_points(a, b, {}, false).apply(a) - b).rowwise().norm().maxCoeff(), 1e-5);
}

TEST(DeformationRepresentation, AnchorsPlaceTheFace) {
    const TriMesh mesh = test::face_like();
    const DeformationRepresentation dr(mesh, {});
    const Points face = test::bent(mesh.vertices, 3).rowwise() + Eigen::RowVector3d(9, 9, 9);
    const Points back = dr.decode(dr.encode(face, {}), {17}, face.row(17), {});
    EXPECT_LT((back - face).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(DeformationRepresentation, SameBitsForOneAndThreeThreads) {
    const TriMesh mesh = test::face_like();
    const DeformationRepresentation dr(mesh, {});
    const Points face = test::noisy(mesh.vertices, 0.2);
    ThreadPool pool(3);
    Context three;
    three.pool = &pool;
    const Features one = dr.encode(face, {});
    EXPECT_TRUE(one == dr.encode(face, three));
    EXPECT_TRUE(dr.decode(one, {}) == dr.decode(one, three));
}

TEST(DeformationRepresentation, RefusesWhatDoesNotFit) {
    const TriMesh mesh = test::face_like();
    const DeformationRepresentation dr(mesh, {});
    EXPECT_EQ(test::status_of([&] { dr.encode(mesh.vertices.topRows(5), {}); }), Status::mismatch);
    EXPECT_EQ(test::status_of([&] { dr.decode(Features::Zero(5, 9), {}); }), Status::mismatch);
    EXPECT_EQ(test::status_of([&] { dr.decode(Features::Zero(mesh.vertices.rows(), 3), {}); }),
              Status::mismatch);
    Points broken = mesh.vertices;
    broken(1, 1) = std::nan("");
    EXPECT_EQ(test::status_of([&] { dr.encode(broken, {}); }), Status::invalid_mesh);
}

TEST(DeformationTransfer, OfAFaceOntoItselfGivesItsExpression) {
    const TriMesh mesh = test::face_like();
    const Points expression = test::bent(mesh.vertices, 4);
    const Points result = DeformationTransfer(mesh, {}).transfer(mesh.vertices, expression, {});
    EXPECT_LT((result - expression).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(DeformationTransfer, NoExpressionLeavesTheTarget) {
    const TriMesh source = test::face_like();
    TriMesh target = source;
    target.vertices = 1.2 * test::bent(source.vertices, 2);
    const Points result =
        DeformationTransfer(target, {}).transfer(source.vertices, source.vertices, {});
    EXPECT_LT((result - target.vertices).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(DeformationTransfer, OfARotationRotatesTheTarget) {
    const TriMesh source = test::face_like();
    TriMesh target = source;
    target.vertices = test::bent(source.vertices, 5);
    const Matrix3 r = turn(0.6);
    const Points expected = target.vertices * r.transpose();
    Points result = DeformationTransfer(target, {})
                        .transfer(source.vertices, source.vertices * r.transpose(), {});
    const Eigen::RowVector3d shift = (expected - result).colwise().mean();
    result.rowwise() += shift;
    EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(DeformationTransfer, SurvivesDegenerateTriangles) {
    TriMesh mesh = test::face_like();
    mesh.vertices.row(70) = mesh.vertices.row(71);
    const Points expression = test::bent(mesh.vertices, 4);
    EXPECT_TRUE(DeformationTransfer(mesh, {}).transfer(mesh.vertices, expression, {}).allFinite());
}

}  // namespace
}  // namespace mien
