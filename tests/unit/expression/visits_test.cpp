#include "expression/visits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <limits>

#include "base/error.hpp"
#include "expression/neutralize.hpp"
#include "geometry/normals.hpp"
#include "trained_study.hpp"

namespace mien {
namespace {

using test::study;
using test::trained_model;

/// Where a fit may slide to: the same surface, other places on it, by a smooth field of about
/// `size` mm.
Points slid(const Points& face, double size, double phase) {
    const Points normals = vertex_normals(face, study().triangles);
    Points moved = face;
    for (Index v = 0; v < face.rows(); ++v) {
        const Vector3 normal = normals.row(v);
        Vector3 step(size * std::sin(0.05 * face(v, 1) + phase),
                     size * std::cos(0.04 * face(v, 0) + phase), 0);
        step -= normal * normal.dot(step);
        moved.row(v) += step;
    }
    return moved;
}

/// Signed distance of corresponding faces along the first one's normals.
Vector between(const Points& first, const Points& second) {
    return (second - first).cwiseProduct(vertex_normals(first, study().triangles)).rowwise().sum();
}

double rms(const Vector& values) {
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

std::vector<std::uint32_t> changed(const Points& change) {
    std::vector<std::uint32_t> zone;
    for (Index v = 0; v < change.rows(); ++v)
        if (change.row(v).norm() > 0.2) zone.push_back(static_cast<std::uint32_t>(v));
    return zone;
}

TEST(Visits, ASlideAlongTheSkinIsNotTakenForAChange) {
    // A face has fifty times as many vertices as this sheet: each of these speaks for fifty.
    VisitsOptions options;
    options.normal_noise_mm2 /= 50;
    options.tangential_noise_mm2 /= 50;
    double joint = 0, single = 0;
    for (int subject = 60; subject < 66; ++subject) {
        const Points before = slid(study().neutral(subject), 3, 0.3),
                     after = slid(study().face(subject, 3), 3, 2.1);
        const VisitsResult visits = neutralize_visits(
            Context(), trained_model<8>(), {{before, Vector()}, {after, Vector()}}, options);
        joint += rms(between(visits.neutral_vertices[0], visits.neutral_vertices[1]));
        // By the same model: that of single faces has a prior of its own.
        const ExpressionModel& people = people_of(trained_model<8>());
        single += rms(between(neutralize(Context(), people, before, Vector(), {}).neutral_vertices,
                              neutralize(Context(), people, after, Vector(), {}).neutral_vertices));
        EXPECT_TRUE(visits.components[0] == "neutral" || visits.components[0] == "any")
            << visits.components[0];
        EXPECT_EQ(visits.components[1], "frown");
    }
    EXPECT_LT(joint, 0.6 * single);
}

TEST(Visits, ASwellingInTheTreatedZoneIsKept) {
    // It lies where the smile moves the face.
    const Points swelling = study().bump(30, 40, 14, Vector3(0, 0, 3));
    const Points before = study().neutral(62), after = study().face(62, 2) + swelling;
    VisitsOptions options;
    options.treated = changed(swelling);
    const VisitsResult visits = neutralize_visits(Context(), trained_model<8>(),
                                                  {{before, Vector()}, {after, Vector()}}, options);
    const Vector truth = between(before, before + swelling);
    EXPECT_LT(rms(between(visits.neutral_vertices[0], visits.neutral_vertices[1]) - truth),
              0.25 * rms(truth));
}

TEST(Visits, TheRemovedVolumeIsThatOfTheExpression) {
    const Points neutral = study().neutral(63), smiling = study().face(63, 2);
    const VisitsResult visits =
        neutralize_visits(Context(), trained_model<8>(),
                          {{neutral, Vector()}, {smiling, Vector()}, {neutral, Vector()}}, {});
    std::vector<std::uint32_t> zone = changed(smiling - neutral);
    const Points normals = triangle_normals(neutral, study().triangles);
    double truth = 0;
    std::vector<char> inside(static_cast<std::size_t>(neutral.rows()), 0);
    for (const std::uint32_t v : zone) inside[v] = 1;
    for (Index t = 0; t < study().triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Index v = study().triangles(t, k);
            if (inside[static_cast<std::size_t>(v)])
                truth += 1e-3 / 6 * normals.row(t).dot(smiling.row(v) - neutral.row(v));
        }
    const RemovedVolume removed = removed_volume(Context(), trained_model<8>(), visits, 0, 1, zone);
    EXPECT_NEAR(removed.removed_ml, truth, 0.1 * std::fabs(truth) + 3 * removed.sd_ml);
    EXPECT_GT(removed.sd_ml, 0);
    EXPECT_NEAR(removed_volume(Context(), trained_model<8>(), visits, 1, 0, zone).removed_ml,
                -removed.removed_ml, 0.1 * std::fabs(removed.removed_ml));
    // Two neutral visits: nothing was taken off, and that is known better.
    const RemovedVolume none = removed_volume(Context(), trained_model<8>(), visits, 0, 2, zone);
    EXPECT_LT(std::fabs(none.removed_ml), 0.05 * std::fabs(truth));
    EXPECT_LT(none.sd_ml, removed.sd_ml);
    EXPECT_EQ(removed_volume(Context(), trained_model<8>(), visits, 1, 1, zone).sd_ml, 0);
}

TEST(Visits, StayInTheFrameOfTheirFaces) {
    const Points before = study().neutral(64), after = study().face(64, 1);
    VisitsOptions options;
    options.pose = Pose::rigid;
    const VisitsResult here = neutralize_visits(Context(), trained_model<8>(),
                                                {{before, Vector()}, {after, Vector()}}, options);
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(0.4, Vector3(1, -2, 3).normalized()).toRotationMatrix();
    motion.translation = Vector3(200, -50, 30);
    const VisitsResult there =
        neutralize_visits(Context(), trained_model<8>(),
                          {{before, Vector()}, {motion.apply(after), Vector()}}, options);
    EXPECT_LT(
        test::mean_distance(there.neutral_vertices[1], motion.apply(here.neutral_vertices[1])),
        0.05);
    EXPECT_LT(test::mean_distance(there.neutral_vertices[0], here.neutral_vertices[0]), 0.05);
}

TEST(Visits, APlaceWithoutDataSaysNothing) {
    const Points before = study().neutral(65), after = study().face(65, 2);
    Points damaged = after;
    Vector weights = Vector::Ones(after.rows());
    for (Index v = 0; v < 3 * study().side; ++v) {
        damaged.row(v) += Vector3(0, 0, 30).transpose();
        weights[v] = 0;
    }
    const VisitsResult clean = neutralize_visits(Context(), trained_model<8>(),
                                                 {{before, Vector()}, {after, weights}}, {});
    const VisitsResult dirty = neutralize_visits(Context(), trained_model<8>(),
                                                 {{before, Vector()}, {damaged, weights}}, {});
    EXPECT_LT((clean.expressions[1] - dirty.expressions[1]).norm(),
              0.02 * clean.expressions[1].norm());
}

TEST(Visits, RefuseWhatTheyCannotUse) {
    const auto status = [](const std::vector<VisitFace>& faces, const VisitsOptions& options) {
        try {
            neutralize_visits(Context(), trained_model<8>(), faces, options);
        } catch (const Error& error) {
            return error.status();
        }
        return Status::ok;
    };
    const VisitFace face{study().neutral(60), Vector()};
    EXPECT_EQ(status({}, {}), Status::invalid_argument);
    VisitsOptions options;
    options.normal_noise_mm2 = 0;
    EXPECT_EQ(status({face}, options), Status::invalid_argument);
    options = {};
    options.treated = {100000};
    EXPECT_EQ(status({face}, options), Status::mismatch);
    VisitFace broken = face;
    broken.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(status({face, broken}, {}), Status::invalid_mesh);
    EXPECT_EQ(status({face, {study().neutral(60).topRows(50), Vector()}}, {}), Status::mismatch);
}

}  // namespace
}  // namespace mien
