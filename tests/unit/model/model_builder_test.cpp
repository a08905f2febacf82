#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <random>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "model/mirror.hpp"
#include "model/model_builder.hpp"
#include "model/model_json.hpp"
#include "model/sampling.hpp"
#include "unit/model/support.hpp"

namespace mien {
namespace {

using model_test::bumpy_sheet;
using model_test::write_faces;

ModelOptions options_of(KernelKind kind, double sigma = 25, Index modes = 180) {
    ModelOptions options;
    options.kernels[0].kind = kind;
    options.kernels[0].sigma_mm = sigma;
    options.num_modes = modes;
    return options;
}

BuiltModel build(const TriMesh& mesh, const ModelOptions& options, const Context& context = {}) {
    return build_deformation_model(mesh, {}, {}, options, context);
}

class EveryKernel : public testing::TestWithParam<KernelKind> {};

TEST_P(EveryKernel, BasisIsOrderedOrthogonalAndExplainsTheVariance) {
    const TriMesh mesh = bumpy_sheet(20);
    // Sigma is the whole width of a spline.
    const double sigma = GetParam() == KernelKind::bspline ? 80 : 25;
    const BuiltModel built = build(mesh, options_of(GetParam(), sigma));
    const Matrix basis = built.model->basis.map().cast<double>();
    ASSERT_EQ(basis.rows(), 441);
    EXPECT_LE(basis.cols(), 60);
    EXPECT_EQ(built.report.rank, basis.cols());
    EXPECT_TRUE(basis.allFinite());
    const Matrix gram = basis.transpose() * basis / 441;
    EXPECT_LT((gram - Matrix(built.model->eigenvalues.asDiagonal())).cwiseAbs().maxCoeff(),
              1e-5 * built.model->eigenvalues[0]);
    for (Index j = 1; j < basis.cols(); ++j)
        EXPECT_LE(built.model->eigenvalues[j], built.model->eigenvalues[j - 1]);
    EXPECT_GT(built.report.variance_explained, 0.9);
    EXPECT_LE(built.report.variance_explained, 1.0 + 1e-6);
    EXPECT_LT(built.report.max_variance_error, 0.6);
    if (GetParam() != KernelKind::geodesic_se) {
        EXPECT_EQ(built.report.num_negative, 0);
    }
}

TEST_P(EveryKernel, SameBitsForAnyNumberOfThreads) {
    const TriMesh mesh = bumpy_sheet(16);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const BuiltModel one = build(mesh, options_of(GetParam())),
                     three = build(mesh, options_of(GetParam()), context);
    EXPECT_EQ(one.model->basis.map(), three.model->basis.map());
    EXPECT_EQ(one.model->eigenvalues, three.model->eigenvalues);
}

TEST_P(EveryKernel, MovingTheTemplateRigidlyKeepsThePriorCovariance) {
    if (GetParam() == KernelKind::bspline) GTEST_SKIP() << "its lattice lies fixed in space";
    TriMesh mesh = bumpy_sheet(12);
    const auto covariance = [&] {
        const Matrix basis = build(mesh, options_of(GetParam())).model->basis.map().cast<double>();
        return Matrix(basis * basis.transpose());
    };
    const Matrix before = covariance();
    mesh.vertices =
        (mesh.vertices * Eigen::AngleAxisd(0.4, Vector3(1, 1, 0).normalized()).toRotationMatrix())
            .eval();
    mesh.vertices.rowwise() += Eigen::RowVector3d(10, 20, 30);
    EXPECT_LT((covariance() - before).cwiseAbs().maxCoeff(), 2e-3);
}

// Nothing of a model may be NaN, and the vertices far from a defect keep the prior they have
// without it.
void expect_sound(const TriMesh& whole, const TriMesh& defective, KernelKind kind) {
    const BuiltModel before = build(whole, options_of(kind)),
                     built = build(defective, options_of(kind));
    ASSERT_TRUE(built.model->basis.map().allFinite());
    EXPECT_TRUE(std::isfinite(built.report.variance_explained));
    EXPECT_TRUE(std::isfinite(built.report.max_variance_error));
    const auto variance = [](const BuiltModel& model, Index i) {
        return model.model->basis.map().row(i).squaredNorm();
    };
    const Index far = whole.vertices.rows() - 1;
    EXPECT_NEAR(variance(built, far), variance(before, far), 0.2 * variance(before, far));
}

TEST_P(EveryKernel, NeedlesAreBorne) {
    TriMesh mesh = bumpy_sheet(14);
    mesh.vertices.row(50) = mesh.vertices.row(51) + Eigen::RowVector3d(1e-9, 0, 0);
    expect_sound(bumpy_sheet(14), mesh, GetParam());
}

TEST_P(EveryKernel, DuplicateVerticesMoveTogether) {
    TriMesh mesh = bumpy_sheet(14);
    mesh.vertices.row(50) = mesh.vertices.row(51);
    expect_sound(bumpy_sheet(14), mesh, GetParam());
    const BuiltModel built = build(mesh, options_of(GetParam()));
    const auto basis = built.model->basis.map();
    // Heat distances about a collapsed edge of so coarse a sheet are wrong by a part of the edges
    // around it.
    const double apart = GetParam() == KernelKind::geodesic_se ? 0.3 : 0.05;
    EXPECT_LT((basis.row(50) - basis.row(51)).norm(), apart * basis.row(50).norm());
}

TEST_P(EveryKernel, NonManifoldEdgesAreBorne) {
    TriMesh mesh = bumpy_sheet(14);
    const Index n = mesh.vertices.rows(), t = mesh.triangles.rows();
    mesh.vertices.conservativeResize(n + 1, 3);
    mesh.vertices.row(n) = mesh.vertices.row(mesh.triangles(40, 0)) + Eigen::RowVector3d(0, 0, 8);
    mesh.triangles.conservativeResize(t + 1, 3);
    mesh.triangles.row(t) << mesh.triangles(40, 0), mesh.triangles(40, 1),
        static_cast<std::uint32_t>(n);
    expect_sound(bumpy_sheet(14), mesh, GetParam());
}

TEST_P(EveryKernel, ComponentsThatLieApartAreIndependent) {
    TriMesh mesh = bumpy_sheet(14);
    const TriMesh other = bumpy_sheet(6);
    const Index n = mesh.vertices.rows(), t = mesh.triangles.rows();
    mesh.vertices.conservativeResize(n + other.vertices.rows(), 3);
    mesh.vertices.bottomRows(other.vertices.rows()) =
        other.vertices.rowwise() + Eigen::RowVector3d(400, 0, 0);
    mesh.triangles.conservativeResize(t + other.triangles.rows(), 3);
    mesh.triangles.bottomRows(other.triangles.rows()) =
        other.triangles.array() + static_cast<std::uint32_t>(n);
    expect_sound(bumpy_sheet(14), mesh, GetParam());
    const Matrix basis = build(mesh, options_of(GetParam())).model->basis.map().cast<double>();
    const Matrix across = basis.topRows(n) * basis.bottomRows(other.vertices.rows()).transpose();
    EXPECT_LT(across.cwiseAbs().maxCoeff(), 0.02 * basis.rowwise().squaredNorm().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(All, EveryKernel,
                         testing::Values(KernelKind::euclidean_se, KernelKind::geodesic_se,
                                         KernelKind::bspline, KernelKind::surface_matern));

TEST(ModelBuilder, EnoughModesReproduceThePositiveDefiniteKernel) {
    const TriMesh mesh = bumpy_sheet(12);
    ModelOptions options = options_of(KernelKind::euclidean_se, 30, 3 * 169);
    options.eigenvalue_threshold = 1e-10;
    const Matrix basis = build(mesh, options).model->basis.map().cast<double>();
    double worst = 0;
    for (Index i = 0; i < 169; i += 7)
        for (Index j = 0; j < 169; ++j) {
            const double k =
                std::exp(-(mesh.vertices.row(i) - mesh.vertices.row(j)).squaredNorm() / 1800);
            worst = std::max(worst, std::abs(basis.row(i).dot(basis.row(j)) - k));
        }
    EXPECT_LT(worst, 1e-5);
}

TEST(ModelBuilder, ToleranceStopsAtTheShareAsked) {
    const TriMesh mesh = bumpy_sheet(16);
    ModelOptions options = options_of(KernelKind::euclidean_se);
    const Index full = build(mesh, options).report.rank;
    options.tolerance = 0.05;
    const LowRankReport report = build(mesh, options).report;
    EXPECT_LT(report.rank, full);
    EXPECT_GE(report.variance_explained, 0.95);
    EXPECT_LT(report.variance_explained, 0.97);
}

TEST(ModelBuilder, ScalePerVertexHoldsVerticesStill) {
    const TriMesh mesh = bumpy_sheet(12);
    ModelOptions options = options_of(KernelKind::geodesic_se);
    options.scale_per_vertex = Vector::Ones(169);
    options.scale_per_vertex.head(30).setZero();
    options.scale_per_vertex.tail(30).setConstant(2);
    const BuiltModel built = build(mesh, options);
    const Points variance = pointwise_variance(*built.model, {});
    EXPECT_LT(variance.topRows(30).maxCoeff(), 1e-10);
    EXPECT_NEAR(variance.bottomRows(30).mean() / variance.middleRows(70, 30).mean(), 4, 0.6);
    options.scale_per_vertex[3] = -1;
    EXPECT_THROW(build(mesh, options), Error);
    options.scale_per_vertex = Vector::Ones(5);
    EXPECT_THROW(build(mesh, options), Error);
}

TEST(ModelBuilder, MirrorModesAreEvenOrOddAndCorrelateTheSides) {
    const TriMesh mesh = bumpy_sheet(12);
    const auto mirror = mirror_map(mesh, {});
    ModelOptions options = options_of(KernelKind::euclidean_se, 20, 120);
    options.mirror_symmetric = true;
    options.mirror_correlation = 1;
    const BuiltModel built = build(mesh, options);
    const Matrix basis = built.model->basis.map().cast<double>();
    int odd = 0;
    for (Index j = 0; j < basis.cols(); ++j) {
        double even_error = 0, odd_error = 0;
        for (Index v = 0; v < basis.rows(); ++v) {
            const double image = basis(static_cast<Index>(mirror[static_cast<std::size_t>(v)]), j);
            even_error += std::abs(basis(v, j) - image);
            odd_error += std::abs(basis(v, j) + image);
        }
        EXPECT_LT(std::min(even_error, odd_error), 1e-3);
        odd += odd_error < even_error;
    }
    EXPECT_GT(odd, 10);
    // With full correlation every sample is its own mirror image.
    const TriMesh face = sample_face(*built.model, 3, 0, 1.0, {});
    for (Index v = 0; v < 169; ++v) {
        const Index image = static_cast<Index>(mirror[static_cast<std::size_t>(v)]);
        EXPECT_NEAR(face.vertices(v, 0), -face.vertices(image, 0), 1e-4);
        EXPECT_NEAR(face.vertices(v, 1), face.vertices(image, 1), 1e-4);
    }
    TriMesh lopsided = mesh;
    lopsided.vertices.col(0).array() += 30;
    EXPECT_THROW(build(lopsided, options), Error);
}

TEST(ModelBuilder, SumOfKernelsAddsVariances) {
    const TriMesh mesh = bumpy_sheet(12);
    ModelOptions options = options_of(KernelKind::euclidean_se, 30, 507);
    options.kernels.push_back({KernelKind::surface_matern, 12, 2, 2});
    const BuiltModel built = build(mesh, options);
    EXPECT_NEAR(pointwise_variance(*built.model, {}).mean(), 5, 0.5);
    EXPECT_EQ(built.model->info.at("kernel"), "euclidean-se,surface-matern");
}

TEST(ModelBuilder, OptionsOutOfRangeAreTypedErrors) {
    const TriMesh mesh = bumpy_sheet(6);
    const auto status = [&](auto&& change) {
        ModelOptions options = options_of(KernelKind::geodesic_se);
        TriMesh copy = mesh;
        change(options, copy);
        try {
            build(copy, options);
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    EXPECT_EQ(status([](ModelOptions& o, TriMesh&) { o.kernels[0].sigma_mm = 0; }),
              Status::invalid_argument);
    EXPECT_EQ(status([](ModelOptions& o, TriMesh&) { o.kernels[0].scale_mm = std::nan(""); }),
              Status::invalid_argument);
    EXPECT_EQ(status([](ModelOptions& o, TriMesh&) { o.kernels.clear(); }),
              Status::invalid_argument);
    EXPECT_EQ(status([](ModelOptions& o, TriMesh&) { o.num_modes = 2; }), Status::invalid_argument);
    EXPECT_EQ(status([](ModelOptions& o, TriMesh&) { o.tolerance = 1; }), Status::invalid_argument);
    EXPECT_EQ(status([](ModelOptions&, TriMesh& m) { m.triangles.resize(0, 3); }),
              Status::invalid_mesh);
    EXPECT_EQ(status([](ModelOptions&, TriMesh& m) { m.vertices(3, 2) = INFINITY; }),
              Status::invalid_mesh);
    EXPECT_EQ(status([](ModelOptions&, TriMesh&) {}), Status::ok);
    EXPECT_THROW(
        build_deformation_model(mesh, {{"nose", 49}}, {}, options_of(KernelKind::bspline), {}),
        Error);
}

TEST(ModelBuilder, CancelsAndReportsProgressInOrder) {
    const TriMesh mesh = bumpy_sheet(16);
    struct Seen {
        int calls = 0, stop_at = 1 << 30, stage = 0;
        double fraction = 0;
        bool fell = false;
    } seen;
    Context context;
    context.progress_user = &seen;
    context.progress_function = [](void* user, std::int32_t stage,
                                   double fraction) -> std::int32_t {
        Seen& s = *static_cast<Seen*>(user);
        if (stage == s.stage && fraction < s.fraction) s.fell = true;
        s.stage = stage;
        s.fraction = fraction;
        return ++s.calls >= s.stop_at;
    };
    build(mesh, options_of(KernelKind::geodesic_se), context);
    EXPECT_FALSE(seen.fell);
    const int all = seen.calls;
    EXPECT_GE(all, 5);
    for (int stop = 1; stop <= all; ++stop) {
        seen = Seen();
        seen.stop_at = stop;
        try {
            build(mesh, options_of(KernelKind::geodesic_se), context);
            FAIL() << "went on after call " << stop;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::cancelled);
        }
    }
}

TEST(ModelBuilder, BudgetIsHeldBeforeMemoryIsTaken) {
    Context context;
    context.max_bytes = 10000;
    try {
        build(bumpy_sheet(16), options_of(KernelKind::euclidean_se), context);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::memory_budget);
    }
}

TEST(PointDistribution, RecoversTheShapesThatMadeTheFaces) {
    const TriMesh mesh = bumpy_sheet(14);
    const FaceDataset faces = FaceDataset::open(
        write_faces(mesh, mesh.vertices.rows(), 9, testing::TempDir() + "pca_full.safetensors"), {},
        {});
    PcaOptions options;
    options.variance = 0.9999;
    options.all_expressions = false;
    const PointDistribution pca = train_point_distribution(faces, mesh, options, {});
    EXPECT_EQ(pca.modes.cols(), 2);
    EXPECT_EQ(pca.num_faces, 9);
    // Every neutral face is the mean plus a combination of the two modes.
    Points face;
    faces.face(8, face);
    Vector y(3 * mesh.vertices.rows());
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        for (int c = 0; c < 3; ++c)
            y[3 * v + c] = face(v, c) - mesh.vertices(v, c) - pca.mean(v, c);
    const Matrix modes = pca.modes.cast<double>();
    const Vector c = (modes.transpose() * modes).ldlt().solve(modes.transpose() * y);
    EXPECT_LT((y - modes * c).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT(c.cwiseAbs().maxCoeff(), 3);
    EXPECT_NEAR(modes.col(0).squaredNorm(), pca.variances[0], 1e-3 * pca.variances[0]);
    options.all_expressions = true;
    EXPECT_GE(train_point_distribution(faces, mesh, options, {}).modes.cols(), 3);
}

// Faces of six people, two each, off the template by random steps of 1 mm on top of a smooth shape;
// of the people `only` when it is not empty.
FaceDataset noisy_people(const TriMesh& mesh, const std::vector<int>& only, const char* name) {
    FaceDatasetWriter writer(mesh.triangles, mesh.vertices.rows(), {"neutral", "smile"});
    std::mt19937 random(5);
    for (int person = 0; person < 6; ++person)
        for (int expression = 0; expression < 2; ++expression) {
            Points face = mesh.vertices;
            face.col(2) += (person - 2.0) * (mesh.vertices.col(0) / 20).array().sin().matrix();
            for (Index i = 0; i < face.size(); ++i)
                face.data()[i] += random() / 4294967296.0 < 0.5 ? -1 : 1;
            if (only.empty() || std::find(only.begin(), only.end(), person) != only.end())
                writer.add(face, person, expression);
        }
    const std::string path = testing::TempDir() + name;
    writer.save(path, {});
    return FaceDataset::open(path, {}, {});
}

// What the modes of the others, trained alone, leave of these people's faces.
double left_by_others(const TriMesh& mesh, const FaceDataset& all, const std::vector<int>& people,
                      const PcaOptions& options) {
    const auto chosen = [&](int person) {
        return std::find(people.begin(), people.end(), person) != people.end();
    };
    std::vector<int> others;
    for (int k = 0; k < 6; ++k)
        if (!chosen(k)) others.push_back(k);
    const PointDistribution pca = train_point_distribution(
        noisy_people(mesh, others, "others.safetensors"), mesh, options, {});
    const Matrix modes = pca.modes.cast<double>();
    double squares = 0;
    Points face;
    for (Index k = 0; k < all.num_faces(); ++k) {
        if (!chosen(all.subject(k))) continue;
        all.face(k, face);
        const Points off = face - mesh.vertices - pca.mean;
        const Vector y = Eigen::Map<const Vector>(off.data(), off.size());
        squares += (y - modes * (modes.transpose() * modes).ldlt().solve(modes.transpose() * y))
                       .squaredNorm();
    }
    return squares;
}

TEST(PointDistribution, LeftOutIsWhatModesOfTheOtherPeopleLeave) {
    const TriMesh mesh = bumpy_sheet(14);
    const FaceDataset faces = noisy_people(mesh, {}, "people.safetensors");
    PcaOptions options;
    options.num_modes = 3;
    double squares = 0;
    for (const std::vector<int>& people : {std::vector{0, 5}, {1}, {2}, {3}, {4}})  // five folds
        squares += left_by_others(mesh, faces, people, options);
    const double coordinates = static_cast<double>(3 * mesh.vertices.rows());
    const double left_mm = train_point_distribution(faces, mesh, options, {}).left_out_mm;
    EXPECT_NEAR(left_mm, std::sqrt(squares / (12 * coordinates)), 1e-4);
    // The steps of a millimetre, which nobody foretells.
    EXPECT_GT(left_mm, 0.95);
    EXPECT_LT(left_mm, 1.3);
    // Within what they were trained on the modes leave less: it is people who are left out.
    options.num_modes = 11;
    EXPECT_GT(train_point_distribution(faces, mesh, options, {}).left_out_mm, 0.95);
}

TEST(PointDistribution, OfTwoPeopleNobodyCanBeLeftOut) {
    const TriMesh mesh = bumpy_sheet(10);
    const FaceDataset faces = noisy_people(mesh, {0, 4}, "two.safetensors");
    EXPECT_EQ(train_point_distribution(faces, mesh, {}, {}).left_out_mm, 0);
    ModelOptions options = options_of(KernelKind::geodesic_se, 20, 90);
    options.pca_faces = &faces;
    EXPECT_EQ(build(mesh, options).model->info.count("pca_left_out_mm"), 0u);
}

TEST(PointDistribution, PartialFacesAreContinuedSmoothly) {
    const TriMesh mesh = bumpy_sheet(14);
    const Index covered = 15 * 11;
    const FaceDataset faces = FaceDataset::open(
        write_faces(mesh, covered, 9, testing::TempDir() + "pca_part.safetensors"), {}, {});
    ModelOptions options = options_of(KernelKind::geodesic_se, 20, 90);
    options.pca_faces = &faces;
    const BuiltModel built = build(mesh, options);
    const auto modes = built.model->pca_modes.map();
    ASSERT_EQ(modes.rows(), 3 * mesh.vertices.rows());
    EXPECT_GE(modes.cols(), 1);
    EXPECT_EQ(built.model->info.at("pca_vertices"), std::to_string(covered));
    // No jump across the edge of what was covered, no runaway beyond it.
    const double inside = modes.topRows(3 * covered).cwiseAbs().maxCoeff();
    EXPECT_LT(modes.bottomRows(3 * (mesh.vertices.rows() - covered)).cwiseAbs().maxCoeff(),
              2 * inside);
    for (Index x = 0; x < 15; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_LT(
                std::abs(modes(3 * (covered + x) + c, 0) - modes(3 * (covered - 15 + x) + c, 0)),
                0.4 * inside);
}

TEST(PointDistribution, ModesAloneMakeAModelAndForeignFacesAreRefused) {
    const TriMesh mesh = bumpy_sheet(10);
    const FaceDataset faces = FaceDataset::open(
        write_faces(mesh, mesh.vertices.rows(), 4, testing::TempDir() + "pca_alone.safetensors"),
        {}, {});
    ModelOptions options;
    options.kernels.clear();
    options.pca_faces = &faces;
    const BuiltModel built = build(mesh, options);
    EXPECT_EQ(built.model->basis.cols, 0);
    EXPECT_GE(built.model->pca_modes.cols, 1);
    EXPECT_TRUE(sample_face(*built.model, 1, 1, 1.0, {}).vertices.allFinite());
    EXPECT_THROW(build(bumpy_sheet(8), options), Error);
    EXPECT_THROW(build(bumpy_sheet(11), options), Error);
}

TEST(Sampling, DrawsDependOnSeedAndIndexAndHaveThePriorsVariance) {
    const TriMesh mesh = bumpy_sheet(10);
    const BuiltModel built = build(mesh, options_of(KernelKind::euclidean_se, 30, 90));
    const TriMesh face = sample_face(*built.model, 7, 3, 1.0, {});
    EXPECT_EQ(face.vertices, sample_face(*built.model, 7, 3, 1.0, {}).vertices);
    EXPECT_NE(face.vertices, sample_face(*built.model, 7, 4, 1.0, {}).vertices);
    EXPECT_NE(face.vertices, sample_face(*built.model, 8, 3, 1.0, {}).vertices);
    EXPECT_EQ(sample_face(*built.model, 7, 3, 0.0, {}).vertices, mesh.vertices);
    const Points variance = pointwise_variance(*built.model, {});
    Points squares = Points::Zero(mesh.vertices.rows(), 3);
    const int count = 400;
    for (int k = 0; k < count; ++k)
        squares += (sample_face(*built.model, 1, static_cast<std::uint64_t>(k), 1.0, {}).vertices -
                    mesh.vertices)
                       .cwiseAbs2() /
                   count;
    EXPECT_NEAR(squares.mean() / variance.mean(), 1, 0.1);
    EXPECT_NEAR(squares.row(5).mean() / variance.row(5).mean(), 1, 0.25);
    EXPECT_THROW(sample_face(*built.model, 1, 1, -1.0, {}), Error);
}

TEST(ModelJson, IsOneObjectWithNumbersAndNames) {
    const TriMesh mesh = bumpy_sheet(6);
    const BuiltModel built = build_deformation_model(mesh, {{"no\"se", 4}}, {{"brow", {1, 2}}},
                                                     options_of(KernelKind::bspline, 40, 30), {});
    const std::string json = model_json(*built.model);
    EXPECT_NE(json.find("\"no\\\"se\":4"), std::string::npos) << json;
    EXPECT_NE(json.find("\"brow\":2"), std::string::npos);
    EXPECT_NE(json.find("\"kernel\":\"bspline\""), std::string::npos);
    EXPECT_NE(json.find("\"sigma_mm\":40"), std::string::npos);
}

}  // namespace
}  // namespace mien
