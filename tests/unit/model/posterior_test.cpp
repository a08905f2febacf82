#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Cholesky>

#include "base/error.hpp"
#include "model/model_builder.hpp"
#include "model/posterior.hpp"
#include "model/sampling.hpp"
#include "unit/model/support.hpp"

namespace mien {
namespace {

using model_test::bumpy_sheet;

std::shared_ptr<const DeformationModel> prior_of(const TriMesh& mesh,
                                                 const FaceDataset* faces = nullptr) {
    ModelOptions options;
    options.kernels[0] = {KernelKind::euclidean_se, 25.0, 2.0, 2.0};
    options.num_modes = 240;
    options.pca_faces = faces;
    return build_deformation_model(mesh, {}, {}, options, {}).model;
}

std::vector<LandmarkObservation> observations() {
    return {{5, {1.0, -2.0, 0.5}, 0.3},
            {70, {0.2, 0.1, 3.0}, 1.0},
            {71, {0.0, 0.4, 2.0}, 0.05},
            {120, {-4, 0, 0}, 2.0}};
}

/// The full covariance, 3#V x 3#V, and mean of a model.
void dense_prior(const DeformationModel& model, Matrix& covariance, Vector& mean) {
    const Index n = model.num_vertices();
    const Matrix basis = model.basis.map().cast<double>(),
                 modes = model.pca_modes.map().cast<double>();
    covariance.setZero(3 * n, 3 * n);
    const Matrix scalar = basis * basis.transpose();
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            for (int c = 0; c < 3; ++c) covariance(3 * i + c, 3 * j + c) = scalar(i, j);
    if (modes.cols() != 0) covariance += modes * modes.transpose();
    mean.setZero(3 * n);
    if (model.mean_displacement.rows() != 0)
        for (Index i = 0; i < n; ++i)
            for (int c = 0; c < 3; ++c) mean[3 * i + c] = model.mean_displacement(i, c);
}

/// (2.13) and (2.14) as they stand, over the whole template.
void dense_posterior(const DeformationModel& model, const std::vector<LandmarkObservation>& seen,
                     Matrix& covariance, Vector& mean) {
    dense_prior(model, covariance, mean);
    const Index h = 3 * static_cast<Index>(seen.size());
    Matrix across(covariance.rows(), h), inner(h, h);
    Vector y(h);
    for (Index i = 0; i < h; ++i) {
        const auto& o = seen[static_cast<std::size_t>(i / 3)];
        const Index at = 3 * static_cast<Index>(o.vertex) + i % 3;
        across.col(i) = covariance.col(at);
        y[i] = o.displacement_mm[i % 3] - mean[at];
    }
    for (Index i = 0; i < h; ++i)
        for (Index j = 0; j < h; ++j)
            inner(i, j) = across(
                3 * static_cast<Index>(seen[static_cast<std::size_t>(i / 3)].vertex) + i % 3, j);
    for (Index i = 0; i < h; ++i)
        inner(i, i) += std::pow(seen[static_cast<std::size_t>(i / 3)].noise_mm, 2);
    const Eigen::LDLT<Matrix> factor(inner);
    mean += across * factor.solve(y);
    covariance -= (across * factor.solve(across.transpose())).eval();
}

void expect_same(const DeformationModel& prior, const std::vector<LandmarkObservation>& seen) {
    Matrix expected, covariance;
    Vector expected_mean, mean;
    dense_posterior(prior, seen, expected, expected_mean);
    const auto posterior = condition_model(prior, seen, {});
    dense_prior(*posterior, covariance, mean);
    EXPECT_LT((mean - expected_mean).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((covariance - expected).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Posterior, EqualsGaussianProcessRegression) {
    expect_same(*prior_of(bumpy_sheet(11)), observations());
}

TEST(Posterior, EqualsGaussianProcessRegressionWithVectorModesAndMean) {
    const TriMesh mesh = bumpy_sheet(11);
    const FaceDataset faces =
        FaceDataset::open(model_test::write_faces(mesh, mesh.vertices.rows(), 7,
                                                  testing::TempDir() + "posterior.safetensors"),
                          {}, {});
    expect_same(*prior_of(mesh, &faces), observations());
}

TEST(Posterior, VarianceAtLandmarksFallsToTheNoiseAndNowhereRises) {
    const auto prior = prior_of(bumpy_sheet(11));
    const auto posterior = condition_model(*prior, observations(), {});
    const Points before = pointwise_variance(*prior, {}),
                 after = pointwise_variance(*posterior, {});
    EXPECT_LT((after - before).maxCoeff(), 1e-5);
    for (const LandmarkObservation& seen : observations())
        EXPECT_LE(std::sqrt(after(seen.vertex, 0)), seen.noise_mm * 1.001);
}

TEST(Posterior, ConditioningInTwoStepsIsConditioningAtOnce) {
    const auto prior = prior_of(bumpy_sheet(11));
    const auto seen = observations();
    const auto steps =
        condition_model(*condition_model(*prior, {seen[0], seen[1]}, {}), {seen[2], seen[3]}, {});
    const auto once = condition_model(*prior, seen, {});
    EXPECT_LT((steps->mean_displacement - once->mean_displacement).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LT(
        (pointwise_variance(*steps, {}) - pointwise_variance(*once, {})).cwiseAbs().maxCoeff(),
        1e-3);
}

TEST(Posterior, HugeNoiseChangesNothing) {
    const auto prior = prior_of(bumpy_sheet(11));
    const auto posterior = condition_model(*prior, {{3, {1, 1, 1}, 1e6}}, {});
    EXPECT_LT(posterior->mean_displacement.cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(
        (pointwise_variance(*posterior, {}) - pointwise_variance(*prior, {})).cwiseAbs().maxCoeff(),
        1e-5);
}

TEST(Posterior, RefusesWrongObservations) {
    const auto prior = prior_of(bumpy_sheet(11));
    EXPECT_THROW(condition_model(*prior, {}, {}), Error);
    EXPECT_THROW(condition_model(*prior, {{9999, {0, 0, 0}, 1}}, {}), Error);
    EXPECT_THROW(condition_model(*prior, {{1, {0, 0, 0}, 0}}, {}), Error);
    EXPECT_THROW(condition_model(*prior, {{1, {std::nan(""), 0, 0}, 1}}, {}), Error);
}

}  // namespace
}  // namespace mien
