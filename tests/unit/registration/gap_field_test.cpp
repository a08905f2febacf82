// The field that closes the gap solves its equations, whatever rings the template has.
#include "registration/gap_field.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "base/thread_pool.hpp"
#include "small_face.hpp"

namespace mien {
namespace {

using namespace test;

struct Problem {
    VertexRings rings;
    Vector weight, gap;
};

/// A sheet, a fan with eleven triangles at its middle, and a vertex that nothing holds.
Problem make_problem() {
    TriMesh mesh = face_sheet(10);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.rows());
    constexpr std::uint32_t kRim = 11;
    const Index old = mesh.triangles.rows();
    mesh.triangles.conservativeResize(old + kRim, 3);
    for (std::uint32_t k = 0; k < kRim; ++k)
        mesh.triangles.row(old + k) << first, first + 1 + k, first + 1 + (k + 1) % kRim;
    const Index n = static_cast<Index>(first + 1 + kRim + 1);
    std::mt19937 random(11);
    Problem problem{build_rings(n, mesh.triangles), Vector(n), Vector(n)};
    for (Index i = 0; i < n; ++i) {
        problem.weight[i] = i % 4 == 0 ? 0 : random() / 4294967296.0;
        problem.gap[i] = 2 * (random() / 4294967296.0) - 1;
    }
    return problem;
}

Vector solve_densely(const Problem& problem, const GapFieldSettings& settings) {
    const Index n = problem.weight.size();
    Matrix bend = Matrix::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
        const VertexSpan ring = problem.rings.of(static_cast<std::size_t>(i));
        if (ring.size() == 0) continue;
        bend(i, i) = 1;
        for (const std::uint32_t j : ring) bend(i, j) -= 1 / static_cast<double>(ring.size());
    }
    Matrix system = settings.smoothness * bend.transpose() * bend;
    system.diagonal() += problem.weight;
    system.diagonal().array() += settings.ground;
    return system.llt().solve(problem.weight.cwiseProduct(problem.gap));
}

TEST(GapField, SolvesItsEquations) {
    const Problem problem = make_problem();
    GapFieldSettings settings;
    settings.most_iterations = 500;
    settings.tolerance = 1e-10;
    GapField field(problem.rings);
    const Vector expected = solve_densely(problem, settings);
    EXPECT_LT((field.solve(problem.weight, problem.gap, settings, {}) - expected).norm(),
              1e-4 * expected.norm());
    // The workspace of a solve before does not matter.
    EXPECT_LT((field.solve(problem.weight, problem.gap, settings, {}) - expected).norm(),
              1e-4 * expected.norm());
}

TEST(GapField, IsZeroWithoutAnyGap) {
    const Problem problem = make_problem();
    GapField field(problem.rings);
    EXPECT_TRUE(field.solve(problem.weight, Vector::Zero(problem.gap.size()), {}, {}).isZero(0));
}

TEST(GapField, HasTheSameBitsForAnyNumberOfThreads) {
    const Problem problem = make_problem();
    GapFieldSettings settings;
    settings.threads_from = 0;
    GapField field(problem.rings);
    const Vector alone = field.solve(problem.weight, problem.gap, settings, {});
    for (const int threads : {2, 3}) {
        ThreadPool pool(threads);
        Context context;
        context.pool = &pool;
        EXPECT_EQ(field.solve(problem.weight, problem.gap, settings, context), alone);
    }
}

}  // namespace
}  // namespace mien
