#include "registration/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/parallel.hpp"
#include "base/scalar_math.hpp"

namespace mien {
double robust_weight(RobustWeight kind, double residual, double scale) {
    const double x = residual / scale;
    switch (kind) {
        case RobustWeight::none:
            return 1;
        case RobustWeight::welsch:
            return std::exp(-0.5 * x * x);
        case RobustWeight::huber:
            return x <= 1 ? 1 : 1 / x;
        case RobustWeight::tukey: {
            constexpr double kZero = 3;  // scales at which the weight is zero
            const double y = x / kZero;
            return y < 1 ? (1 - y * y) * (1 - y * y) : 0;
        }
    }
    return 1;
}

namespace {

// The Gaussian mean of the scan around a vertex, by seven places of its tangent plane whose weights
// integrate polynomials up to the fifth degree; those that find the scan farther off count less, as
// in a Gaussian of all three axes.
class SoftAssignment {
  public:
    SoftAssignment(const ScanView& scan, const CorrespondenceSettings& settings)
        : scan_(scan), settings_(settings) {}

    // Moves `hit` and `normal` of a vertex to the mean.
    void soften(const Vector3& place, const Vector3& place_normal, SurfaceHit& hit,
                Vector3& normal) const {
        constexpr int kAround = 6;
        constexpr double kRing = 2, kCentreShare = 0.5, kRingShare = 0.5 / kAround;
        Vector3 across = place_normal.unitOrthogonal();
        const Eigen::AngleAxisd turn(2 * kPi / kAround, place_normal);
        Mean mean;
        const double nearest = hit.squared_distance;
        add(hit, normal, kCentreShare * border_share(hit), mean);
        for (int k = 0; k < kAround; ++k, across = turn * across) {
            const SurfaceHit around =
                scan_.tree().closest(place + kRing * settings_.soft_mm * across,
                                     settings_.max_distance_mm, hit.triangle);
            if (!around.valid()) continue;
            const double farther = std::max(0.0, around.squared_distance - nearest) /
                                   (settings_.soft_mm * settings_.soft_mm);
            add(around, scan_.normal_at(around),
                kRingShare * border_share(around) * std::exp(-0.5 * farther), mean);
        }
        if (!(mean.weight > 0) || !(mean.normal.norm() > 0)) return;
        hit.point = mean.point / mean.weight;
        hit.squared_distance = (hit.point - place).squaredNorm();
        normal = mean.normal.normalized();
    }

  private:
    struct Mean {
        Vector3 point = Vector3::Zero(), normal = Vector3::Zero();
        double weight = 0;
    };

    double border_share(const SurfaceHit& hit) const {
        if (!settings_.reject_border) return 1;
        return fade(scan_.surface().off_border(hit) / settings_.border_ramp);
    }

    static void add(const SurfaceHit& hit, const Vector3& normal, double weight, Mean& mean) {
        mean.point += weight * hit.point;
        mean.normal += weight * normal;
        mean.weight += weight;
    }

    const ScanView& scan_;
    const CorrespondenceSettings& settings_;
};

// Takes the weight of hits that another place, too far from theirs, is nearest to.
void keep_mutual(const PointsRef& places, double mutual_mm, Correspondences& found,
                 const Context& context) {
    const TriangleTree tree(places, Triangles(0, 3), context);
    parallel_for(context, found.hits.size(), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index i = static_cast<Index>(k);
            if (!(found.weight[i] > 0)) continue;
            const SurfaceHit back = tree.closest(found.hits[k].point);
            const double away_mm = (back.point - places.row(i).transpose()).norm();
            found.weight[i] *= fade(2 * (1 - away_mm / mutual_mm));
        }
    });
}

}  // namespace

void find_correspondences(const ScanView& scan, const PointsRef& places,
                          const PointsRef& place_normals, const CorrespondenceSettings& settings,
                          Correspondences& result, const Context& context,
                          const std::vector<std::uint8_t>& left_out) {
    const Index n = places.rows();
    const ScanSurface& surface = scan.surface();
    surface.tree.closest(places, settings.max_distance_mm, left_out, result.hits, context);
    result.normals.resize(n, 3);
    result.weight.resize(n);
    const bool by_angle = settings.max_angle_deg < 180;
    const double least_cosine = std::cos(
        std::min(180.0, settings.max_angle_deg + settings.angle_ramp_deg) * kRadiansPerDegree);
    const double sure_cosine = std::cos(
        std::max(0.0, settings.max_angle_deg - settings.angle_ramp_deg) * kRadiansPerDegree);
    const SoftAssignment soft(scan, settings);
    parallel_for(
        context, static_cast<std::size_t>(n), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Index i = static_cast<Index>(k);
                SurfaceHit& hit = result.hits[k];
                result.weight[i] = 0;
                result.normals.row(i).setZero();
                if (!hit.valid()) continue;
                Vector3 normal = scan.normal_at(hit);
                const Vector3 own_normal = place_normals.row(i).transpose();
                if (settings.soft_mm > 0 && !own_normal.isZero(0))
                    soft.soften(places.row(i).transpose(), own_normal, hit, normal);
                result.normals.row(i) = normal.transpose();
                if (normal.isZero(0)) continue;
                double weight =
                    robust_weight(settings.robust, hit.distance(), settings.robust_scale_mm);
                if (std::isfinite(settings.limit_mm))
                    weight *= fade((1 - hit.distance() / settings.limit_mm) / settings.limit_ramp);
                if (settings.reject_border)
                    weight *= fade(surface.off_border(hit) / settings.border_ramp);
                if (by_angle)
                    weight *= fade((place_normals.row(i).dot(normal) - least_cosine) /
                                   (sure_cosine - least_cosine));
                if (!(weight > 0)) continue;
                result.weight[i] = weight * surface.weight_at(hit);
            }
        });
    if (std::isfinite(settings.mutual_mm)) keep_mutual(places, settings.mutual_mm, result, context);
}

}  // namespace mien
