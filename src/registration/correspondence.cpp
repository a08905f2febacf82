#include "registration/correspondence.hpp"

#include <cmath>

#include "base/parallel.hpp"

namespace mien {

double robust_weight(RobustWeight kind, double residual, double scale) {
    const double x = residual / scale;
    switch (kind) {
        case RobustWeight::none: return 1;
        case RobustWeight::welsch: return std::exp(-0.5 * x * x);
        case RobustWeight::huber: return x <= 1 ? 1 : 1 / x;
        case RobustWeight::tukey: {
            const double y = x / 3;  // falls to zero at three scales
            return y < 1 ? (1 - y * y) * (1 - y * y) : 0;
        }
    }
    return 1;
}

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
    const double min_cosine = std::cos(options.max_angle_deg * 3.14159265358979323846 / 180);
    parallel_for(context, static_cast<std::size_t>(n), 512, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Index i = static_cast<Index>(k);
            const SurfaceHit& hit = result.hits[k];
            result.weight[i] = 0;
            result.normals.row(i).setZero();
            if (!hit.valid()) continue;
            const Vector3 normal = scan.normal_at(hit);
            result.normals.row(i) = normal.transpose();
            if (normal.isZero(0) || (options.reject_border && scan.at_border(hit))) continue;
            if (place_normals.row(i).dot(normal) < min_cosine) continue;
            double weight = robust_weight(options.robust, hit.distance(), options.robust_scale_mm);
            if (scan_weight.size() > 0) {
                double given = 0;
                for (int c = 0; c < 3; ++c)
                    given += hit.barycentric[c] *
                             scan_weight[scan.tree.is_point_cloud()
                                             ? static_cast<Index>(hit.triangle)
                                             : static_cast<Index>(scan.triangles(hit.triangle, c))];
                weight *= given;
            }
            if (options.mutual) {
                const SurfaceHit mate = back.closest(hit.point);
                if ((mate.point - places.row(i).transpose()).norm() > options.mutual_distance_mm)
                    continue;
            }
            result.weight[i] = weight;
        }
    });
}

}  // namespace mien
