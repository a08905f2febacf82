#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "base/random.hpp"
#include "model/kernel_blocks.hpp"
#include "unit/model/support.hpp"

namespace mien {
namespace {

using model_test::bumpy_sheet;

std::vector<std::uint32_t> every(Index n) {
    std::vector<std::uint32_t> all;
    for (Index v = 0; v < n; ++v) all.push_back(static_cast<std::uint32_t>(v));
    return all;
}

TEST(Kernel, NamesAreReadBackAndUnknownOnesRefused) {
    for (const KernelKind kind : {KernelKind::euclidean_se, KernelKind::geodesic_se,
                                  KernelKind::bspline, KernelKind::surface_matern})
        EXPECT_EQ(kernel_from_name(kernel_name(kind)), kind);
    EXPECT_THROW(kernel_from_name("gaussian"), Error);
}

TEST(Kernel, MultiscaleKeepsTheVarianceAndDoublesSigmaAndWeight) {
    KernelTerm term;
    term.sigma_mm = 5;
    term.scale_mm = 3;
    const auto terms = multiscale(term, 4);
    double variance = 0;
    for (std::size_t l = 0; l < 4; ++l) {
        variance += std::pow(terms[l].scale_mm, 2);
        EXPECT_DOUBLE_EQ(terms[l].sigma_mm, 5 * std::pow(2.0, l));
        if (l > 0) {
            EXPECT_NEAR(std::pow(terms[l].scale_mm / terms[l - 1].scale_mm, 2), 2, 1e-12);
        }
    }
    EXPECT_NEAR(variance, 9, 1e-12);
    EXPECT_THROW(multiscale(term, 0), Error);
}

TEST(Kernel, CubicSplinesSumToOneAndVanishOutside) {
    for (double x = -0.5; x < 0.5; x += 0.037) {
        double sum = 0;
        for (int k = -3; k <= 3; ++k) sum += cubic_bspline(x - k);
        EXPECT_NEAR(sum, 1, 1e-14);
    }
    EXPECT_EQ(cubic_bspline(2.0), 0.0);
    EXPECT_NEAR(cubic_bspline(0), 2.0 / 3.0, 1e-15);
}

TEST(Kernel, EuclideanKernelMatchesItsFormula) {
    const TriMesh mesh = bumpy_sheet(6);
    KernelTerm term{KernelKind::euclidean_se, 7.0, 2.0, 2.0};
    const KernelBlocks blocks(mesh, {3, 20}, {term}, 1, {}, {});
    Matrix k;
    blocks.evaluate({term}, k, {});
    const double squared = (mesh.vertices.row(11) - mesh.vertices.row(20)).squaredNorm();
    EXPECT_NEAR(k(11, 1), 4 * std::exp(-squared / 98), 1e-13);
    EXPECT_NEAR(k(3, 0), 4, 1e-14);
}

TEST(Kernel, SplineKernelIsPositiveAndNearItsScaleEverywhere) {
    const TriMesh mesh = bumpy_sheet(8);
    KernelTerm term{KernelKind::bspline, 30.0, 1.5, 2.0};
    const KernelBlocks blocks(mesh, every(mesh.vertices.rows()), {term}, 1, {}, {});
    Matrix k;
    blocks.evaluate({term}, k, {});
    EXPECT_LT((k - k.transpose()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((k.diagonal() - blocks.diagonal({term})).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(k.diagonal().mean(), 2.25, 0.2);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(k);
    EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-10);
    // Compact support: one width apart, nothing is shared.
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        if (std::abs(mesh.vertices(v, 0) - mesh.vertices(0, 0)) >= 30) {
            EXPECT_EQ(k(v, 0), 0.0);
        }
}

TEST(Kernel, MaternVarianceIsTheScaleSquaredOnAverageAndNeverNegative) {
    const TriMesh mesh = bumpy_sheet(20);
    for (const double nu : {0.5, 2.0, 5.0}) {
        KernelTerm term{KernelKind::surface_matern, 15.0, 3.0, nu};
        const KernelBlocks blocks(mesh, {}, {term}, 150, {}, {});
        const MaternSpectrum spectrum =
            matern_spectrum(blocks.eigenpairs().values, blocks.area_mm2(), term);
        EXPECT_GE(spectrum.variances.minCoeff(), 0);
        for (Index j = 1; j < spectrum.variances.size(); ++j)
            EXPECT_LE(spectrum.variances[j], spectrum.variances[j - 1] * (1 + 1e-9));
        const LaplaceOperator laplace = build_laplacian(mesh.vertices, mesh.triangles, {});
        const double average = laplace.mass.dot(blocks.diagonal({term})) / laplace.mass.sum();
        EXPECT_NEAR(average + 9 * spectrum.tail, 9, 0.05) << nu;
    }
}

TEST(Kernel, MaternOfTwoLengthScalesFallsAsStatisticsExpect) {
    const TriMesh mesh = bumpy_sheet(40, 0.0);
    KernelTerm term{KernelKind::surface_matern, 20.0, 1.0, 2.0};
    const Index centre = 20 * 41 + 20;
    const KernelBlocks blocks(mesh, {static_cast<std::uint32_t>(centre)}, {term}, 300, {}, {});
    Matrix k;
    blocks.evaluate({term}, k, {});
    // In the plane: 2^(1 - nu) / Gamma(nu) z^nu K_nu(z) with z = kappa sigma = 2 and nu = 2.
    const double step = mesh.vertices(1, 0) - mesh.vertices(0, 0);
    const Index apart = static_cast<Index>(std::lround(20.0 / step));
    EXPECT_NEAR(k(centre + apart, 0) / k(centre, 0), 0.5075, 0.03);
}

TEST(FarthestPoints, SpreadsEvenlyAndDeterministically) {
    const TriMesh mesh = bumpy_sheet(20);
    const auto chosen = farthest_points(mesh.vertices, mesh.triangles, 40);
    ASSERT_EQ(chosen.size(), 40u);
    EXPECT_EQ(chosen, farthest_points(mesh.vertices, mesh.triangles, 40));
    double least = 1e9, farthest = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least,
                             (mesh.vertices.row(chosen[i]) - mesh.vertices.row(chosen[j])).norm());
    for (Index v = 0; v < mesh.vertices.rows(); ++v) {
        double nearest = 1e9;
        for (const std::uint32_t c : chosen)
            nearest = std::min(nearest, (mesh.vertices.row(v) - mesh.vertices.row(c)).norm());
        farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(farthest, 1.5 * least);
    EXPECT_EQ(farthest_points(mesh.vertices, mesh.triangles, 100000).size(),
              static_cast<std::size_t>(mesh.vertices.rows()));
}

TEST(Random, NumbersDependOnSeedStreamAndPlaceAlone) {
    const CounterRandom a(1, 2);
    EXPECT_EQ(a.normal(77), CounterRandom(1, 2).normal(77));
    EXPECT_NE(a.normal(77), CounterRandom(1, 3).normal(77));
    EXPECT_NE(a.normal(77), CounterRandom(2, 2).normal(77));
    double sum = 0, squares = 0, fourth = 0, lag = 0;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        const double x = a.normal(static_cast<std::uint64_t>(i));
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
        lag += x * a.normal(static_cast<std::uint64_t>(i) + 1);
    }
    EXPECT_NEAR(sum / count, 0, 0.01);
    EXPECT_NEAR(squares / count, 1, 0.015);
    EXPECT_NEAR(fourth / count, 3, 0.1);
    EXPECT_NEAR(lag / count, 0, 0.01);
}

}  // namespace
}  // namespace mien
