#include "registration/correspondence.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

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
            const double y = x / 3;  // falls to zero at three scales
            return y < 1 ? (1 - y * y) * (1 - y * y) : 0;
        }
    }
    return 1;
}

namespace {

constexpr double kOffBorder =
    0.2;  // share of the way from the border to the next row of scan vertices

}  // namespace

void find_correspondences(const ScanSurface& scan, const PointsRef& places,
                          const PointsRef& place_normals, const Vector& scan_weight,
                          const CorrespondenceOptions& options, Correspondences& result,
                          const Context& context) {
    const Index n = places.rows();
    scan.tree.closest(places, options.max_distance_mm, result.hits, context);
    result.normals.resize(n, 3);
    result.weight.resize(n);
    TriangleTree back;
    if (options.mutual) back = TriangleTree(places, Triangles(0, 3), context);
    constexpr double kDegree = 3.14159265358979323846 / 180, kFade_deg = 5;
    // The filters fade: a vertex on the verge would be taken in one frame and refused in another,
    // by rounding.
    const bool by_angle = options.max_angle_deg < 180;
    const double least_cosine =
        std::cos(std::min(180.0, options.max_angle_deg + kFade_deg) * kDegree);
    const double sure_cosine = std::cos(std::max(0.0, options.max_angle_deg - kFade_deg) * kDegree);
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
                    robust_weight(options.robust, hit.distance(), options.robust_scale_mm);
                if (options.reject_border) weight *= fade(scan.off_border(hit) / kOffBorder);
                if (by_angle)
                    weight *= fade((place_normals.row(i).dot(normal) - least_cosine) /
                                   (sure_cosine - least_cosine));
                if (!(weight > 0)) continue;
                if (scan_weight.size() > 0) {
                    double given = 0;
                    for (int c = 0; c < 3; ++c)
                        given +=
                            hit.barycentric[c] *
                            scan_weight[scan.tree.is_point_cloud()
                                            ? static_cast<Index>(hit.triangle)
                                            : static_cast<Index>(scan.triangles(hit.triangle, c))];
                    weight *= given;
                }
                if (options.mutual) {
                    const SurfaceHit mate = back.closest(hit.point);
                    if ((mate.point - places.row(i).transpose()).norm() >
                        options.mutual_distance_mm)
                        continue;
                }
                result.weight[i] = weight;
            }
        });
}

}  // namespace mien
