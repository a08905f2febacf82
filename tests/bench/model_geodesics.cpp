// Geodesics in numbers: model_geodesics TEMPLATE.ply
//
// Prints the error on a sphere of 26,012 vertices and the time of 1,000 sources on the template, in
// blocks and by a plain loop of single heat solves with Eigen's sparse Cholesky.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <Eigen/SparseCholesky>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "geometry/heat_method.hpp"
#include "geometry/intrinsic_mesh.hpp"
#include "mesh/mesh_file.hpp"
#include "unit/geometry/sphere.hpp"

using namespace mien;

namespace {

double seconds() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The heat method as everybody writes it: one right-hand side, two triangular solves.
class PlainHeat {
  public:
    PlainHeat(const PointsRef& vertices, const TrianglesRef& triangles)
        : mesh_(build_intrinsic_mesh(vertices, triangles)) {
        const int n = static_cast<int>(mesh_.num_vertices);
        std::vector<Eigen::Triplet<double>> entries;
        Vector mass = Vector::Zero(n);
        for (Index t = 0; t < mesh_.triangles.rows(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int i = static_cast<int>(mesh_.triangles(t, (k + 1) % 3));
                const int j = static_cast<int>(mesh_.triangles(t, (k + 2) % 3));
                mass[static_cast<Index>(mesh_.triangles(t, k))] +=
                    mesh_.weights[t] * mesh_.double_area(t) / 6;
                const double w = 0.5 * mesh_.weights[t] * mesh_.cotangent(t, k);
                entries.emplace_back(i, j, -w);
                entries.emplace_back(j, i, -w);
                entries.emplace_back(i, i, w);
                entries.emplace_back(j, j, w);
            }
        Eigen::SparseMatrix<double> stiffness(n, n);
        stiffness.setFromTriplets(entries.begin(), entries.end());
        Eigen::SparseMatrix<double> heat =
            HeatOptions().time_factor * mesh_.mean_edge_mm * mesh_.mean_edge_mm * stiffness;
        for (int v = 0; v < n; ++v) heat.coeffRef(v, v) += mass[v];
        stiffness.coeffRef(0, 0) *= 2;
        heat_.compute(heat);
        poisson_.compute(stiffness);
    }

    Vector distances_from(std::uint32_t source) const {
        Vector start = Vector::Zero(mesh_.num_vertices), right = start;
        start[source] = 1;
        const Vector u = heat_.solve(start);
        for (Index t = 0; t < mesh_.triangles.rows(); ++t) {
            const double l2 = mesh_.lengths(t, 2), l1 = mesh_.lengths(t, 1),
                         l0 = mesh_.lengths(t, 0);
            const double x2 = ((l1 - l0) * (l1 + l0) + l2 * l2) / (2 * l2),
                         doubled = mesh_.double_area(t);
            const Eigen::Vector2d g1(doubled / l2 / doubled, -x2 / doubled), g2(0, l2 / doubled);
            const double u0 = u[mesh_.triangles(t, 0)];
            const Eigen::Vector2d gradient =
                (u[mesh_.triangles(t, 1)] - u0) * g1 + (u[mesh_.triangles(t, 2)] - u0) * g2;
            const Eigen::Vector2d flow = -0.5 * doubled * mesh_.weights[t] * gradient.normalized();
            right[mesh_.triangles(t, 1)] += flow.dot(g1);
            right[mesh_.triangles(t, 2)] += flow.dot(g2);
            right[mesh_.triangles(t, 0)] -= flow.dot(g1 + g2);
        }
        const Vector raw = poisson_.solve(right);
        return (raw.array() - raw[source]).max(0.0).matrix();
    }

  private:
    IntrinsicMesh mesh_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> heat_, poisson_;
};

void accuracy(const Context& context) {
    const test::Surface sphere = test::sphere(51);
    const HeatGeodesics heat(sphere.vertices, sphere.triangles, {}, context);
    double worst_mean = 0, worst = 0;
    for (Index source = 0; source < sphere.vertices.rows(); source += 2003) {
        const Vector d = heat.distances_from(static_cast<std::uint32_t>(source));
        double sum = 0;
        for (Index v = 0; v < d.size(); ++v) {
            const double cosine = sphere.vertices.row(v).dot(sphere.vertices.row(source));
            const double error = std::abs(d[v] - std::acos(std::max(-1.0, std::min(1.0, cosine))));
            sum += error;
            worst = std::max(worst, error);
        }
        worst_mean = std::max(worst_mean, sum / static_cast<double>(d.size()));
    }
    std::printf(
        "unit sphere, %lld vertices, 13 sources: largest mean error %.4f, largest error %.4f\n",
        static_cast<long long>(sphere.vertices.rows()), worst_mean, worst);
}

void speed(const TriMesh& mesh, const Context& context) {
    double start = seconds(), cpu = cpu_seconds();
    const HeatGeodesics heat(mesh.vertices, mesh.triangles, {}, context);
    std::printf("factorisation %.3f s (cpu %.3f), %lld vertices\n", seconds() - start,
                cpu_seconds() - cpu, static_cast<long long>(mesh.vertices.rows()));
    std::vector<std::uint32_t> sources;
    for (std::uint64_t k = 0; k < 1000; ++k)
        sources.push_back(static_cast<std::uint32_t>(
            k * static_cast<std::uint64_t>(mesh.vertices.rows()) / 1000));
    Eigen::MatrixXf out = Eigen::MatrixXf::Zero(mesh.vertices.rows(), 1000);
    start = seconds();
    cpu = cpu_seconds();
    heat.distances(sources, out, context);
    const double blocks = seconds() - start, blocks_cpu = cpu_seconds() - cpu;
    const PlainHeat plain(mesh.vertices, mesh.triangles);
    start = seconds();
    cpu = cpu_seconds();
    double difference = 0;
    for (std::size_t k = 0; k < sources.size(); ++k) {
        const Vector d = plain.distances_from(sources[k]);
        difference = std::max(
            difference,
            (d.cast<float>() - out.col(static_cast<Index>(k))).cwiseAbs().maxCoeff() + 0.0);
    }
    const double loop = seconds() - start, loop_cpu = cpu_seconds() - cpu;
    std::printf(
        "1000 sources: blocks %.2f s (cpu %.2f), loop %.2f s (cpu %.2f): %.1f times, %.1f times in "
        "cpu; "
        "largest difference %.1e mm\n",
        blocks, blocks_cpu, loop, loop_cpu, loop / blocks, loop_cpu / blocks_cpu, difference);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: model_geodesics TEMPLATE.ply\n");
        return 2;
    }
    try {
        ThreadPool pool(2);
        Context context;
        context.pool = &pool;
        accuracy(context);
        speed(read_mesh_file(argv[1], context), context);
    } catch (const Error& error) {
        std::fprintf(stderr, "model_geodesics: %s\n", error.what());
        return 1;
    }
    return 0;
}
