#include "geometry/rigid_zone.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

#include "base/error.hpp"
#include "base/median.hpp"
#include "base/scalar_math.hpp"
#include "geometry/alignment.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Matrix3 cross_matrix(const Vector3& v) {
    Matrix3 m;
    m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return m;
}

// Tukey weights of the normal residuals. The scale has a floor, so that an exact fit of most pairs
// does not call the others back.
Vector robust_weights(const Vector& residuals, const Vector& areas, double extent) {
    std::vector<double> sizes(residuals.data(), residuals.data() + residuals.size());
    for (double& r : sizes) r = std::fabs(r);
    const double scale = std::max(4.685 * 1.4826 * median(sizes), 1e-5 * extent);
    Vector weights = areas;
    if (!(scale > 0)) return weights;
    for (Index i = 0; i < residuals.size(); ++i) {
        const double r = residuals[i] / scale;
        weights[i] *= std::fabs(r) < 1 ? (1 - r * r) * (1 - r * r) : 0.0;
    }
    return weights;
}

void check(Index pairs, const RigidZoneOptions& options) {
    if (!(options.tangential > 0 && options.tangential <= 1) ||
        !(options.correlation_length_mm >= 0) || options.iterations < 1)
        fail(Status::invalid_argument,
             "alignment settings: tangential %g (0 .. 1), correlation length %g (>= 0), %d "
             "iterations",
             options.tangential, options.correlation_length_mm, options.iterations);
    if (pairs < 10)
        fail(Status::no_solution,
             "%lld pairs in the stable zone; alignment needs at least 10, give a larger zone",
             static_cast<long long>(pairs));
}

}  // namespace

RigidZoneResult align_pairs(const PointsRef& source, const PointsRef& target,
                            const PointsRef& normals, const Vector& areas, const Similarity& start,
                            const RigidZoneOptions& options) {
    const Index n = source.rows();
    check(n, options);
    if (target.rows() != n || normals.rows() != n || areas.size() != n)
        fail(Status::mismatch, "%lld source points, %lld targets, %lld normals, %lld areas",
             static_cast<long long>(n), static_cast<long long>(target.rows()),
             static_cast<long long>(normals.rows()), static_cast<long long>(areas.size()));
    RigidZoneResult result;
    result.centre = target.colwise().mean();
    result.motion = start;
    result.motion.scale = 1.0;
    const double extent = (target.rowwise() - result.centre.transpose()).norm() / std::sqrt(n);
    Matrix6 system = Matrix6::Zero();
    double total = 0.0, squares = 0.0;
    for (int iteration = 0; iteration < options.iterations; ++iteration) {
        const Points moved = result.motion.apply(source);
        const Points residual = moved - target;
        const Vector along = residual.cwiseProduct(normals).rowwise().sum();
        const Vector weights = robust_weights(along, areas, extent);
        system.setZero();
        Vector6 gradient = Vector6::Zero();
        total = squares = 0.0;
        double normal_squares = 0.0;
        result.pairs = 0;
        for (Index i = 0; i < n; ++i) {
            if (!(weights[i] > 0)) continue;
            ++result.pairs;
            const Vector3 normal = normals.row(i), r = residual.row(i);
            const Matrix3 metric = (1 - options.tangential) * normal * normal.transpose() +
                                   options.tangential * Matrix3::Identity();
            Eigen::Matrix<double, 3, 6> jacobian;
            jacobian.leftCols<3>() = -cross_matrix(Vector3(moved.row(i)) - result.centre);
            jacobian.rightCols<3>().setIdentity();
            system += weights[i] * jacobian.transpose() * metric * jacobian;
            gradient += weights[i] * jacobian.transpose() * (metric * r);
            total += weights[i];
            squares += weights[i] * r.dot(metric * r);
            normal_squares += weights[i] * along[i] * along[i];
        }
        result.rms_mm = total > 0 ? std::sqrt(normal_squares / total) : 0.0;
        const Eigen::LDLT<Matrix6> solver(system);
        const Vector6 pivots = solver.vectorD();
        if (solver.info() != Eigen::Success ||
            !(pivots.minCoeff() > 1e-10 * pivots.maxCoeff() / std::max(1.0, extent * extent)))
            fail(Status::no_solution,
                 "the stable zone does not fix the motion (%lld pairs counted); give a larger or "
                 "more "
                 "curved zone",
                 static_cast<long long>(result.pairs));
        const Vector6 step = -solver.solve(gradient);
        const Vector3 turn = step.head<3>();
        const double angle = turn.norm();
        Matrix3 rotation = Matrix3::Identity();
        if (angle > 0) rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
        // x -> rotation (x - centre) + centre + t, after the motion so far.
        result.motion.translation =
            rotation * (result.motion.translation - result.centre) + result.centre + step.tail<3>();
        result.motion.rotation = rotation * result.motion.rotation;
        if (angle * extent + step.tail<3>().norm() < 1e-9 * std::max(extent, 1e-300)) break;
    }
    // Back to a rotation to rounding.
    const Eigen::JacobiSVD<Matrix3> svd(result.motion.rotation,
                                        Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (svd.info() != Eigen::Success)
        fail(Status::no_solution, "the motion of the stable zone is not finite");
    result.motion.rotation = svd.matrixU() * svd.matrixV().transpose();
    const double l = options.correlation_length_mm;
    const double area = areas.sum();
    const double independent =
        l > 0 ? std::clamp(area / (2 * kPi * l * l), 4.0, static_cast<double>(n))
              : static_cast<double>(n);
    const double variance = squares / (total * (1.0 + 2.0 * options.tangential));
    // `system` sums areas; one independent place stands for total / independent of them.
    result.covariance = variance * (total / independent) * system.inverse();
    result.covariance = 0.5 * (result.covariance + result.covariance.transpose()).eval();
    return result;
}

RigidZoneResult align_on_zone(const PointsRef& source, const PointsRef& target,
                              const TrianglesRef& triangles, const std::vector<std::uint32_t>& zone,
                              const RigidZoneOptions& options) {
    if (source.rows() != target.rows())
        fail(Status::mismatch,
             "%lld source vertices, %lld of the target; both must be fitted with the "
             "same template",
             static_cast<long long>(source.rows()), static_cast<long long>(target.rows()));
    std::vector<std::uint32_t> chosen(zone);
    if (chosen.empty()) {
        chosen.resize(static_cast<std::size_t>(source.rows()));
        for (std::size_t v = 0; v < chosen.size(); ++v) chosen[v] = static_cast<std::uint32_t>(v);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    if (!chosen.empty() && static_cast<Index>(chosen.back()) >= source.rows())
        fail_at(Status::mismatch, chosen.back(), "the stable zone names vertex %u of %lld",
                chosen.back(), static_cast<long long>(source.rows()));
    const Index n = static_cast<Index>(chosen.size());
    check(n, options);
    const Points all_normals = vertex_normals(target, triangles);
    const Points scaled = triangle_normals(target, triangles);
    Vector all_areas = Vector::Zero(target.rows());
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) all_areas[triangles(t, k)] += scaled.row(t).norm() / 6.0;
    Points from(n, 3), to(n, 3), normals(n, 3);
    Vector areas(n);
    for (Index i = 0; i < n; ++i) {
        const Index v = chosen[static_cast<std::size_t>(i)];
        from.row(i) = source.row(v);
        to.row(i) = target.row(v);
        normals.row(i) = all_normals.row(v);
        areas[i] = all_areas[v];
    }
    return align_pairs(from, to, normals, areas, align_points(from, to, areas, false), options);
}

}  // namespace mien
