#include "measure/mirror_plane.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

#include "base/decompositions.hpp"
#include "base/error.hpp"
#include "base/scalar_math.hpp"

namespace mien {
namespace {

constexpr double kMedianOfLength = 1.5382;  ///< of a normal error's length in three dimensions
constexpr double kConverged = 1e-12;        ///< change of the normal, relative
constexpr double kFlat = 1e-9;              ///< of the pairs' extent: no plane stands out

class PlaneFit {
  public:
    PlaneFit(const PointsRef& points, const MirrorMap& map, const Vector& weights,
             const MirrorPlaneSettings& settings)
        : points_(points), map_(map), settings_(settings), area_(points.rows()) {
        for (Index v = 0; v < points.rows(); ++v)
            area_[v] = 0.5 * (weights[v] + weights[partner(v)]);
        weights_ = area_;
    }

    MirrorPlane run() {
        solve();
        for (const bool absolute : {true, false})
            for (int round = 0; round < settings_.max_rounds; ++round) {
                const Vector3 before = plane_.normal, centre = plane_.centre;
                weigh(absolute);
                solve();
                if ((plane_.normal - before).norm() < kConverged &&
                    (plane_.centre - centre).norm() < kConverged * (1.0 + extent_))
                    break;
            }
        finish();
        return plane_;
    }

  private:
    Index partner(Index v) const { return map_.partner[static_cast<std::size_t>(v)]; }
    Vector3 point(Index v) const { return points_.row(v).transpose(); }

    void solve() {
        const double sum = weights_.sum();
        Index used = 0;
        for (Index v = 0; v < points_.rows(); ++v)
            if (weights_[v] > 0 && partner(v) >= v) ++used;
        if (!(sum > 0) || used < 3)
            fail(Status::no_solution,
                 "the mirror plane has %lld pairs to stand on; three or more are needed",
                 static_cast<long long>(used));
        const Vector3 centre = points_.transpose() * weights_ / sum;
        Matrix3 products = Matrix3::Zero();
        double extent = 0.0;
        for (Index v = 0; v < points_.rows(); ++v) {
            const Vector3 a = point(v) - centre, b = point(partner(v)) - centre;
            products += weights_[v] * (a * b.transpose());
            extent += weights_[v] * a.squaredNorm();
        }
        const Matrix3 symmetric = 0.5 * (products + products.transpose());
        const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(symmetric);
        if (eigen.info() != Eigen::Success || !(extent > 0) ||
            eigen.eigenvalues()[1] - eigen.eigenvalues()[0] < kFlat * extent)
            fail(Status::no_solution,
                 "the mirror plane is not determined: the pairs lie in a line or in one place");
        extent_ = std::sqrt(extent / sum);
        plane_.centre = centre;
        plane_.normal = eigen.eigenvectors().col(0);
        Vector3 leftward = Vector3::Zero();
        for (Index v = 0; v < points_.rows(); ++v)
            leftward += weights_[v] * map_.side[static_cast<std::size_t>(v)] * point(v);
        if (leftward.dot(plane_.normal) < 0) plane_.normal = -plane_.normal;
        plane_.pairs = used;
    }

    double distance(Index v) const { return (point(v) - plane_.reflect(point(partner(v)))).norm(); }

    void weigh(bool absolute) {
        std::vector<double> sorted;
        Vector distances(points_.rows());
        for (Index v = 0; v < points_.rows(); ++v) {
            distances[v] = distance(v);
            if (area_[v] > 0) sorted.push_back(distances[v]);
        }
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        const double deviation = std::max(*middle / kMedianOfLength, settings_.least_deviation_mm);
        for (Index v = 0; v < points_.rows(); ++v) {
            double say = 0.0;
            if (absolute) {
                say = 1.0 / std::max(distances[v], deviation);
            } else {
                const double x = distances[v] / (settings_.cutoff * kMedianOfLength * deviation);
                if (x < 1) say = (1 - x * x) * (1 - x * x);
            }
            weights_[v] = area_[v] * say;
        }
    }

    void finish() {
        const auto [first, second] = plane_.directions();
        const Vector3& n = plane_.normal;
        Matrix3 normal = Matrix3::Zero();
        double squares = 0.0, sum = 0.0, used_area = 0.0;
        for (Index v = 0; v < points_.rows(); ++v) {
            if (!(weights_[v] > 0)) continue;
            const Vector3 q = point(partner(v)) - plane_.centre;
            Matrix3 slope;  // of H q by (tilt, tilt, offset)
            slope.col(0) = -2 * (first.dot(q) * n + n.dot(q) * first);
            slope.col(1) = -2 * (second.dot(q) * n + n.dot(q) * second);
            slope.col(2) = 2 * n;
            normal += weights_[v] * slope.transpose() * slope;
            const double d = distance(v);
            squares += weights_[v] * d * d;
            sum += weights_[v];
            used_area += area_[v];
        }
        plane_.rms_mm = std::sqrt(squares / sum);
        const double length = settings_.correlation_length_mm;
        const double pairs = static_cast<double>(plane_.pairs) / settings_.pairs_together;
        const double places =
            length > 0 ? std::min(pairs, 0.5 * used_area / (2 * kPi * length * length)) : pairs;
        const Eigen::LDLT<Matrix3> factor(normal / sum);
        if (factor.info() != Eigen::Success || !factor.isPositive())
            fail(Status::no_solution, "the mirror plane's deviation cannot be computed");
        plane_.covariance =
            squares / (3 * sum) / std::max(places, 1.0) * factor.solve(Matrix3::Identity());
    }

    const PointsRef& points_;
    const MirrorMap& map_;
    const MirrorPlaneSettings& settings_;
    Vector area_, weights_;
    double extent_ = 0.0;
    MirrorPlane plane_;
};

}  // namespace

std::array<Vector3, 2> MirrorPlane::directions() const {
    Vector3 off = Vector3::UnitY();
    if (std::fabs(normal.dot(off)) > 0.9) off = Vector3::UnitZ();
    const Vector3 first = (off - normal.dot(off) * normal).normalized();
    return {{first, normal.cross(first)}};
}

Eigen::Matrix<double, 6, 6> MirrorPlane::motion_covariance() const {
    const auto [first, second] = directions();
    Eigen::Matrix<double, 6, 3> slope = Eigen::Matrix<double, 6, 3>::Zero();
    slope.block<3, 1>(0, 0) = 2 * normal.cross(first);
    slope.block<3, 1>(0, 1) = 2 * normal.cross(second);
    slope.block<3, 1>(3, 2) = 2 * normal;
    return slope * covariance * slope.transpose();
}

double MirrorPlane::tilt_sd_rad() const {
    return std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
}

double MirrorPlane::offset_sd_mm() const {
    return std::sqrt(covariance(2, 2));
}

MirrorMap mirror_sides(std::vector<std::uint32_t> partner, const PointsRef& template_vertices) {
    MirrorMap map{std::move(partner), {}};
    map.side.assign(map.partner.size(), 0);
    for (std::size_t v = 0; v < map.partner.size(); ++v)
        if (map.partner[v] != v)
            map.side[v] = template_vertices(static_cast<Index>(v), 0) > 0 ? 1 : -1;
    return map;
}

MirrorPlane find_mirror_plane(const PointsRef& points, const MirrorMap& map, const Vector& weights,
                              const MirrorPlaneSettings& settings) {
    const auto count = static_cast<std::size_t>(points.rows());
    if (map.partner.size() != count || map.side.size() != count || weights.size() != points.rows())
        fail(Status::mismatch, "a mirror map of %zu vertices, %zu sides and %lld weights for %zu",
             map.partner.size(), map.side.size(), static_cast<long long>(weights.size()), count);
    for (std::size_t v = 0; v < count; ++v)
        if (map.partner[v] >= count || map.partner[map.partner[v]] != v)
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(v),
                    "vertex %zu and its partner do not mirror each other", v);
    if (!(settings.cutoff > 0) || !(settings.least_deviation_mm > 0) ||
        !(settings.correlation_length_mm >= 0) || !(settings.pairs_together >= 1) ||
        settings.max_rounds < 1)
        fail(Status::invalid_argument, "a setting of the mirror plane is out of its range");
    return PlaneFit(points, map, weights, settings).run();
}

}  // namespace mien
