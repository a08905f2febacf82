#include "measure/score_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/thread_pool.hpp"
#include "measure/random.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

// Faces that differ by smooth random modes, much more than the score moves them.
struct People {
    Points mean = 80.0 * test::sphere(1, 4).vertices;
    Vector areas = Vector::Ones(mean.rows());
    Vector grades;
    Matrix displacements;

    People(const Points& hidden, int count, int seed) {
        SplitMix random(static_cast<std::uint64_t>(seed));
        const Index n = mean.rows();
        Matrix modes(3 * n, 30);
        for (Index m = 0; m < modes.cols(); ++m) {
            const Vector3 wave = 0.02 * Vector3(random.normal(), random.normal(), random.normal());
            const Vector3 way(random.normal(), random.normal(), random.normal());
            for (Index v = 0; v < n; ++v)
                modes.col(m).segment<3>(3 * v) =
                    0.8 * way * std::sin(mean.row(v).dot(wave) + static_cast<double>(m));
        }
        grades.resize(count);
        displacements.resize(3 * n, count);
        const Vector change = Eigen::Map<const Vector>(hidden.data(), hidden.size());
        for (int k = 0; k < count; ++k) {
            grades[k] = 4.0 * random.uniform();
            displacements.col(k) = grades[k] * change;
            for (Index m = 0; m < modes.cols(); ++m)
                displacements.col(k) += random.normal() * modes.col(m);
        }
        displacements.colwise() -= displacements.rowwise().mean().eval();
    }
};

Points on_sphere(const std::function<Vector3(const Vector3&)>& change) {
    Points points = 80.0 * test::sphere(1, 4).vertices;
    for (Index v = 0; v < points.rows(); ++v)
        points.row(v) = change(points.row(v).transpose()).transpose();
    return points;
}

Points jowl() {
    return on_sphere([](const Vector3& p) {
        return Vector3(Vector3(0.3, -1, 0.2) * 1.5 *
                       std::exp(-(p - Vector3(30, -50, 55)).squaredNorm() / 500));
    });
}

double correlation(const Vector& a, const Points& b) {
    return a.dot(Eigen::Map<const Vector>(b.data(), b.size())) / (a.norm() * b.norm());
}

Vector regression(const People& people) {
    const Vector centred = people.grades.array() - people.grades.mean();
    return people.displacements * centred / centred.squaredNorm();
}

TEST(ScoreDirection, FindsALocalChangeThatChanceHides) {
    for (const int seed : {2, 3, 4}) {
        const People people(jowl(), 200, seed);
        const ScoreDirection found =
            score_direction(people.mean, people.displacements, people.areas, people.grades, {});
        EXPECT_GT(found.places, 0);
        EXPECT_GT(correlation(found.displacement, jowl()), 0.9);
        EXPECT_LT(correlation(regression(people), jowl()), 0.7);
    }
}

// An alignment on the whole face moves all of it a little against what the score does in one place.
TEST(ScoreDirection, UndoesWhatTheAlignmentShared) {
    Points shared = jowl();
    shared.rowwise() -= Eigen::RowVector3d(0.1, -0.3, 0.1);
    const People people(shared, 200, 4);
    const Vector found =
        score_direction(people.mean, people.displacements, people.areas, people.grades, {})
            .displacement;
    EXPECT_GT(correlation(found, jowl()), 0.9);
}

TEST(ScoreDirection, KeepsAChangeOfTheWholeFace) {
    const Points wider = on_sphere([](const Vector3& p) { return Vector3(0.04 * p.x(), 0, 0); });
    for (const int seed : {1, 2, 3}) {
        const People people(wider, 200, seed);
        const Vector found =
            score_direction(people.mean, people.displacements, people.areas, people.grades, {})
                .displacement;
        EXPECT_GT(correlation(found, wider), correlation(regression(people), wider) - 0.02);
    }
}

TEST(ScoreDirection, OfFacesThatDifferByTheScoreAloneIsTheirDifference) {
    Points change = jowl();
    People people(change, 10, 5);
    for (Index k = 0; k < people.grades.size(); ++k)
        people.displacements.col(k) =
            people.grades[k] * Eigen::Map<const Vector>(change.data(), change.size());
    const Vector found =
        score_direction(people.mean, people.displacements, people.areas, people.grades, {})
            .displacement;
    EXPECT_LT(
        (Eigen::Map<const Points>(found.data(), change.rows(), 3) - change).cwiseAbs().maxCoeff(),
        1e-9);
}

TEST(ScoreDirection, HasTheSameBitsForAnyThreadCount) {
    const People people(jowl(), 60, 6);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    const ScoreDirection one =
        score_direction(people.mean, people.displacements, people.areas, people.grades, {});
    const ScoreDirection many =
        score_direction(people.mean, people.displacements, people.areas, people.grades, context);
    EXPECT_TRUE((one.displacement.array() == many.displacement.array()).all());
}

TEST(Focus, IsTheLengthOverTheLongestAndNeverNothing) {
    ScoreDirection direction;
    direction.displacement.resize(9);
    direction.displacement << 3, 0, 4, 0, 0, 0, 0, 2.5, 0;
    EXPECT_TRUE(focus_of(direction).isApprox(Vector::Ones(3)));  // the regression stands
    direction.places = 30;
    EXPECT_TRUE(focus_of(direction).isApprox(Vector3(1, 0.01, 0.5)));
    direction.displacement.setZero();
    EXPECT_TRUE(focus_of(direction).isApprox(Vector::Ones(3)));
}

}  // namespace
}  // namespace mien
