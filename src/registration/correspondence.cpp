#include "registration/correspondence.hpp"

#include <algorithm>
#include <cmath>

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

void find_correspondences(const ScanView& scan, const PointsRef& places,
                          const PointsRef& place_normals, const CorrespondenceSettings& settings,
                          Correspondences& result, const Context& context) {
    const Index n = places.rows();
    const ScanSurface& surface = scan.surface();
    surface.tree.closest(places, settings.max_distance_mm, result.hits, context);
    result.normals.resize(n, 3);
    result.weight.resize(n);
    const bool by_angle = settings.max_angle_deg < 180;
    const double least_cosine = std::cos(
        std::min(180.0, settings.max_angle_deg + settings.angle_ramp_deg) * kRadiansPerDegree);
    const double sure_cosine = std::cos(
        std::max(0.0, settings.max_angle_deg - settings.angle_ramp_deg) * kRadiansPerDegree);
    parallel_for(
        context, static_cast<std::size_t>(n), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Index i = static_cast<Index>(k);
                const SurfaceHit& hit = result.hits[k];
                result.weight[i] = 0;
                result.normals.row(i).setZero();
                if (!hit.valid()) continue;
                const Vector3 normal = scan.normal_at(hit);
                result.normals.row(i) = normal.transpose();
                if (normal.isZero(0)) continue;
                double weight =
                    robust_weight(settings.robust, hit.distance(), settings.robust_scale_mm);
                if (settings.reject_border)
                    weight *= fade(surface.off_border(hit) / settings.border_ramp);
                if (by_angle)
                    weight *= fade((place_normals.row(i).dot(normal) - least_cosine) /
                                   (sure_cosine - least_cosine));
                if (!(weight > 0)) continue;
                result.weight[i] = weight * surface.weight_at(hit);
            }
        });
}

}  // namespace mien
