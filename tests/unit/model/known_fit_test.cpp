#include "model/known_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "model/model_builder.hpp"
#include "unit/model/support.hpp"

namespace mien {
namespace {

using model_test::bumpy_sheet;

std::shared_ptr<const DeformationModel> model_of(const TriMesh& mesh,
                                                 const FaceDataset* faces = nullptr,
                                                 double mirror = 0) {
    ModelOptions options;
    options.kernels[0] = {KernelKind::euclidean_se, 25.0, 2.0, 2.0};
    options.num_modes = 90;
    options.pca_faces = faces;
    options.mirror_symmetric = mirror > 0;
    options.mirror_correlation = mirror;
    return build_deformation_model(mesh, {}, {}, options, {}).model;
}

FaceDataset faces_of(const TriMesh& mesh) {
    const std::string path = ::testing::TempDir() + "known_fit_faces.safetensors";
    model_test::write_faces(mesh, mesh.vertices.rows(), 6, path);
    return FaceDataset::open(path, {}, {});
}

/// (2.34) as it stands, with the whole 3n x l matrix A.
Vector dense_fit(const DeformationModel& model, const Points& target, const Vector& weights,
                 double rho) {
    const Index n = target.rows(), r = model.basis.cols, p = model.pca_modes.cols;
    Matrix a = Matrix::Zero(3 * n, 3 * r + p);
    Vector y(3 * n), w(3 * n), ridge = Vector::Constant(3 * r + p, rho);
    for (Index v = 0; v < n; ++v)
        for (int c = 0; c < 3; ++c) {
            for (Index j = 0; j < r; ++j) a(3 * v + c, 3 * j + c) = model.basis.map()(v, j);
            for (Index j = 0; j < p; ++j)
                a(3 * v + c, 3 * r + j) = model.pca_modes.map()(3 * v + c, j);
            y[3 * v + c] =
                target(v, c) - model.template_mesh.vertices(v, c) -
                (model.mean_displacement.rows() != 0 ? model.mean_displacement(v, c) : 0);
            w[3 * v + c] = weights[v] * weights[v];
        }
    if (model.prior_variance.rows() != 0)
        for (Index j = 0; j < r; ++j)
            for (int c = 0; c < 3; ++c) ridge[3 * j + c] /= model.prior_variance(j, c);
    Matrix system = a.transpose() * w.asDiagonal() * a;
    system.diagonal() += ridge;
    return Eigen::LDLT<Matrix>(system).solve(a.transpose() * w.asDiagonal() * y);
}

Vector flat(const ModelCoefficients& c) {
    Vector values(3 * c.kernel.rows() + c.pca.size());
    for (Index j = 0; j < c.kernel.rows(); ++j)
        for (int k = 0; k < 3; ++k) values[3 * j + k] = c.kernel(j, k);
    values.tail(c.pca.size()) = c.pca;
    return values;
}

Points bulged(const TriMesh& mesh, Index rows) {
    Points target = mesh.vertices.topRows(rows);
    for (Index v = 0; v < rows; ++v) {
        target(v, 2) += 4 * std::exp(-target.row(v).squaredNorm() / 500);
        target(v, 0) += 0.7 * std::sin(target(v, 1) / 9);
    }
    return target;
}

TEST(KnownFit, IsTheEquationOfTheThesis) {
    const TriMesh mesh = bumpy_sheet(10);
    const FaceDataset faces = faces_of(mesh);
    for (const bool trained : {false, true})
        for (const double mirror : {0.0, 0.8})
            for (const Index rows : {mesh.vertices.rows(), Index(70)}) {
                const auto model = model_of(mesh, trained ? &faces : nullptr, mirror);
                const Points target = bulged(mesh, rows);
                KnownFitOptions options;
                options.ridge_mm2 = 0.7;
                options.weights.resize(rows);
                for (Index v = 0; v < rows; ++v)
                    options.weights[v] = v % 5 == 0 ? 0.0 : 0.3 * (v % 4);
                const KnownFit fit = fit_known(*model, target, options, {});
                const Vector expected = dense_fit(*model, target, options.weights, 0.7);
                EXPECT_LT((flat(fit.coefficients) - expected).norm(), 1e-6 * expected.norm())
                    << trained << mirror << rows;
            }
}

TEST(KnownFit, RecoversTheCoefficientsOfAFaceOfTheModel) {
    const TriMesh mesh = bumpy_sheet(10);
    const FaceDataset faces = faces_of(mesh);
    const auto model = model_of(mesh, &faces);
    ModelCoefficients truth;
    truth.kernel = Matrix::Random(model->basis.cols, 3);
    truth.pca = Vector::Random(model->pca_modes.cols);
    const Points target = mesh.vertices + displacement(*model, truth, {});
    KnownFitOptions options;
    options.ridge_mm2 = 0;
    const KnownFit fit = fit_known(*model, target, options, {});
    EXPECT_LT(fit.residual_rms_mm, 1e-4);
    const Points again = mesh.vertices + displacement(*model, fit.coefficients, {});
    EXPECT_LT((again - target).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(KnownFit, RidgeShrinksAndWeightsOfZeroExclude) {
    const TriMesh mesh = bumpy_sheet(10);
    const auto model = model_of(mesh);
    Points target = bulged(mesh, mesh.vertices.rows());
    KnownFitOptions options;
    options.ridge_mm2 = 0.1;
    const double loose = fit_known(*model, target, options, {}).coefficients.kernel.norm();
    options.ridge_mm2 = 100;
    EXPECT_LT(fit_known(*model, target, options, {}).coefficients.kernel.norm(), loose);
    options.weights = Vector::Ones(mesh.vertices.rows());
    options.weights[17] = 0;
    const Matrix before = fit_known(*model, target, options, {}).coefficients.kernel;
    target.row(17) << 500, -300, 200;
    EXPECT_EQ(before, fit_known(*model, target, options, {}).coefficients.kernel);
}

TEST(KnownFit, AlignsATargetFromElsewhereWhenAsked) {
    const TriMesh mesh = bumpy_sheet(10);
    const auto model = model_of(mesh);
    const Points target = bulged(mesh, mesh.vertices.rows());
    Similarity away;
    away.rotation = Eigen::AngleAxisd(0.9, Vector3(1, 2, -1).normalized()).toRotationMatrix();
    away.translation << 300, -20, 5;
    KnownFitOptions options;
    options.align = true;
    const KnownFit here = fit_known(*model, target, options, {});
    const KnownFit there = fit_known(*model, away.apply(target), options, {});
    EXPECT_LT((here.coefficients.kernel - there.coefficients.kernel).norm(), 1e-6);
    EXPECT_LT(there.residual_rms_mm, 1.0);
}

TEST(KnownFit, DoesNotDependOnThreadsAndNamesWhatDoesNotFit) {
    const TriMesh mesh = bumpy_sheet(10);
    const auto model = model_of(mesh);
    const Points target = bulged(mesh, mesh.vertices.rows());
    ThreadPool pool(4);
    Context threads;
    threads.pool = &pool;
    EXPECT_EQ(fit_known(*model, target, {}, {}).coefficients.kernel,
              fit_known(*model, target, {}, threads).coefficients.kernel);
    const auto status = [&](const Points& points, const KnownFitOptions& options) {
        try {
            fit_known(*model, points, options, {});
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    Points broken = target;
    broken(3, 1) = std::nan("");
    KnownFitOptions options;
    EXPECT_EQ(status(broken, options), Status::invalid_mesh);
    EXPECT_EQ(status(Points::Zero(mesh.vertices.rows() + 1, 3), options), Status::mismatch);
    options.weights = Vector::Zero(mesh.vertices.rows());
    EXPECT_EQ(status(target, options), Status::invalid_argument);
    options.weights = Vector::Ones(3);
    EXPECT_EQ(status(target, options), Status::mismatch);
    options = {};
    options.ridge_mm2 = -1;
    EXPECT_EQ(status(target, options), Status::invalid_argument);
}

}  // namespace
}  // namespace mien
