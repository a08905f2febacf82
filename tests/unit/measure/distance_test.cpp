#include "measure/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>

#include "base/thread_pool.hpp"
#include "measure/random.hpp"
#include "measure/uncertainty.hpp"
#include "measure/volume.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

TEST(Distance, BetweenConcentricSpheresIsTheGap) {
    const TriMesh inner = test::sphere(50, 4), outer = test::sphere(51.5, 4);
    const DistanceReport r =
        measure_distance(inner.vertices, outer.vertices, inner.triangles, {{"z", {0, 1, 2}}}, {});
    EXPECT_NEAR(r.whole.mean_signed_mm, 1.5, 1e-3);
    EXPECT_NEAR(r.whole.rms_mm, 1.5, 1e-9);
    EXPECT_NEAR(r.hausdorff_mm, 1.5, 1e-9);
    EXPECT_NEAR(r.zones[0].median_length_mm, 1.5, 1e-9);
    const DistanceReport back =
        measure_distance(outer.vertices, inner.vertices, inner.triangles, {}, {});
    EXPECT_NEAR(back.whole.mean_signed_mm, -1.5, 1e-3);
}

TEST(Distance, ToAnotherMeshOfTheSameSphereIsSmall) {
    const TriMesh from = test::sphere(50, 3), to = test::sphere(50.8, 5);
    const DistanceReport r = measure_surface_distance(from, to, {}, 0, true, {});
    EXPECT_NEAR(r.whole.mean_signed_mm, 0.8, 0.02);
    EXPECT_GT(r.hausdorff_mm, 0.8);  // the coarse mesh cuts corners of the fine one
    EXPECT_LT(r.hausdorff_mm, 1.6);
    const DistanceReport inside = measure_surface_distance(to, from, {}, 0, true, {});
    EXPECT_LT(inside.whole.mean_signed_mm, 0);
}

TEST(Distance, LeavesOutWhatHasNothingOppositeIt) {
    const TriMesh wide = test::grid(40, 20, 40, 20);
    TriMesh narrow = test::grid(20, 20, 20, 20);
    narrow.vertices.col(2).array() += 0.5;
    const DistanceReport r = measure_surface_distance(wide, narrow, {}, 0, true, {});
    EXPECT_NEAR(r.whole.max_length_mm, 0.5, 1e-9);
    EXPECT_LT(r.whole.num_vertices, 21 * 21);
    EXPECT_GT(r.whole.num_vertices, 17 * 17);
    const DistanceReport all = measure_surface_distance(wide, narrow, {}, 0, false, {});
    EXPECT_NEAR(all.whole.max_length_mm, std::hypot(20, 0.5), 1e-9);
    EXPECT_NEAR(measure_surface_distance(wide, narrow, {}, 3, false, {}).whole.max_length_mm,
                std::hypot(2, 0.5), 1e-9);
}

TEST(Distance, QuantilesAreWeightedWithAreas) {
    Vector values(4), weights(4);
    values << 1, 2, 3, std::nan("");
    weights << 1, 1, 8, 100;
    const std::vector<char> all(4, 1);
    EXPECT_EQ(weighted_quantile(values, weights, all, 0.15), 2.0);
    EXPECT_EQ(weighted_quantile(values, weights, all, 0.5), 3.0);
    EXPECT_TRUE(std::isnan(weighted_quantile(values, weights, {0, 0, 0, 1}, 0.5)));
}

TEST(VolumeUncertainty, OfOneCommonErrorIsAreaTimesDeviation) {
    const TriMesh mesh = test::grid(60, 40, 30, 20);
    VolumeErrorModel model;
    model.sd_after_mm = Vector::Constant(mesh.vertices.rows(), 0.1);
    model.correlation_length_mm = 1e6;  // everything moves together
    const std::vector<char> all(static_cast<std::size_t>(mesh.vertices.rows()), 1);
    const VolumePropagation p(mesh.vertices, mesh.vertices, mesh.triangles, model);
    EXPECT_NEAR(p.of(all, {}).sd_ml, 60 * 40 * 0.1 * 1e-3, 1e-6);
    model.sd_before_mm = model.sd_after_mm;  // two independent faces
    EXPECT_NEAR(
        VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model).of(all, {}).sd_ml,
        std::sqrt(2.0) * 0.24, 1e-6);
    model.correlation_length_mm = 0;
    EXPECT_LT(
        VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model).of(all, {}).sd_ml,
        0.02);
}

TEST(VolumeUncertainty, MatchesSimulatedCorrelatedErrors) {
    // Noise made by smoothing white noise: correlation exp(-d^2 / (2 l^2)) for kernels exp(-d^2 /
    // l^2).
    const TriMesh mesh = test::grid(60, 60, 30, 30);
    const Index n = mesh.vertices.rows();
    const double length = 6.0, sd = 0.2;
    Matrix kernel(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            kernel(i, j) = std::exp(-(mesh.vertices.row(i) - mesh.vertices.row(j)).squaredNorm() /
                                    (length * length));
    for (Index i = 0; i < n; ++i) kernel.row(i) *= sd / kernel.row(i).norm();
    VolumeErrorModel model;
    model.sd_before_mm = model.sd_after_mm = Vector::Constant(n, sd);
    model.correlation_length_mm = length;
    std::vector<char> inside(static_cast<std::size_t>(n), 0);
    std::vector<std::uint32_t> zone;
    for (Index v = 0; v < n; ++v)
        if ((mesh.vertices.row(v) - Eigen::RowVector3d(30, 30, 0)).norm() < 20) {
            inside[static_cast<std::size_t>(v)] = 1;
            zone.push_back(static_cast<std::uint32_t>(v));
        }
    const double predicted =
        VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model).of(inside, {}).sd_ml;
    SplitMix random(5);
    double square = 0;
    const int rounds = 300;
    for (int r = 0; r < rounds; ++r) {
        Points faces[2] = {mesh.vertices, mesh.vertices};
        for (Points& face : faces) {
            Vector white(n);
            for (Index v = 0; v < n; ++v) white[v] = random.normal();
            face.col(2) += kernel * white;
        }
        const double ml =
            volume_of(volume_per_vertex(faces[0], faces[1], mesh.triangles, {}), zone).signed_ml;
        square += ml * ml / rounds;
    }
    EXPECT_NEAR(predicted / std::sqrt(square), 1.0,
                0.12);  // 300 rounds: 4 % error of the deviation
}

TEST(VolumeUncertainty, OfAnUncertainAlignmentMatchesMovedFaces) {
    const TriMesh mesh = test::sphere(80, 4);
    std::vector<char> inside(static_cast<std::size_t>(mesh.vertices.rows()), 0);
    std::vector<std::uint32_t> zone;
    for (Index v = 0; v < mesh.vertices.rows(); ++v)
        if (mesh.vertices(v, 0) > 50) {
            inside[static_cast<std::size_t>(v)] = 1;
            zone.push_back(static_cast<std::uint32_t>(v));
        }
    VolumeErrorModel model;
    model.alignment_centre = Vector3(0, 60, 40);
    model.alignment_covariance.diagonal() << 1e-5, 2e-5, 1e-5, 0.02, 0.01, 0.03;
    const double predicted = VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model)
                                 .of(inside, {})
                                 .alignment_ml;
    SplitMix random(6);
    double square = 0;
    for (int r = 0; r < 400; ++r) {
        Eigen::Matrix<double, 6, 1> s;
        for (int k = 0; k < 6; ++k)
            s[k] = random.normal() * std::sqrt(model.alignment_covariance(k, k));
        const Vector3 w = s.head<3>();
        Points moved = mesh.vertices;
        for (Index v = 0; v < moved.rows(); ++v) {
            const Vector3 arm = Vector3(mesh.vertices.row(v)) - model.alignment_centre;
            moved.row(v) += (w.cross(arm) + s.tail<3>()).transpose();
        }
        const double ml =
            volume_of(volume_per_vertex(mesh.vertices, moved, mesh.triangles, {}), zone).signed_ml;
        square += ml * ml / 400;
    }
    EXPECT_NEAR(predicted / std::sqrt(square), 1.0, 0.12);
}

TEST(VolumeUncertainty, TakesTheSameBitsFromAnyThreadCountAndRefusesNonsense) {
    const TriMesh mesh = test::sphere(80, 4);
    const std::vector<char> all(static_cast<std::size_t>(mesh.vertices.rows()), 1);
    VolumeErrorModel model;
    model.sd_before_mm = Vector::LinSpaced(mesh.vertices.rows(), 0, 1);
    const VolumePropagation p(mesh.vertices, mesh.vertices, mesh.triangles, model);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    EXPECT_EQ(p.of(all, {}).sd_ml, p.of(all, context).sd_ml);
    model.sd_before_mm[3] = -1;
    EXPECT_EQ(test::status_of(
                  [&] { VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model); }),
              Status::invalid_argument);
    model.sd_before_mm.resize(5);
    EXPECT_EQ(test::status_of(
                  [&] { VolumePropagation(mesh.vertices, mesh.vertices, mesh.triangles, model); }),
              Status::mismatch);
}

}  // namespace
}  // namespace mien
