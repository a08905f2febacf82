#include "measure/curvature_summary.hpp"

#include <algorithm>
#include <cmath>

#include "measure/area.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

CurvatureSummary summary_of(const CurvatureField& field, const Vector& areas,
                            const std::vector<char>& inside, const std::string& name) {
    CurvatureSummary summary;
    summary.name = name;
    double area = 0.0, squares = 0.0, bending = 0.0;
    for (Index v = 0; v < areas.size(); ++v) {
        if (!inside[static_cast<std::size_t>(v)]) continue;
        const double a = areas[v], k1 = field.maximal[v], k2 = field.minimal[v];
        area += a;
        summary.mean_mean_per_mm += a * field.mean[v];
        summary.mean_gaussian_per_mm2 += a * field.gaussian[v];
        summary.mean_maximal_per_mm += a * k1;
        summary.mean_minimal_per_mm += a * k2;
        squares += a * field.mean[v] * field.mean[v];
        bending += a * 0.5 * (k1 * k1 + k2 * k2);
    }
    if (!(area > 0)) return summary;
    for (double* value : {&summary.mean_mean_per_mm, &summary.mean_gaussian_per_mm2,
                          &summary.mean_maximal_per_mm, &summary.mean_minimal_per_mm})
        *value /= area;
    summary.sd_mean_per_mm = std::sqrt(
        std::max(0.0, squares / area - summary.mean_mean_per_mm * summary.mean_mean_per_mm));
    summary.bending_per_mm = std::sqrt(bending / area);
    return summary;
}

}  // namespace

CurvatureReport measure_curvature(const PointsRef& vertices, const TrianglesRef& triangles,
                                  const std::vector<Zone>& zones, const CurvatureOptions& options,
                                  const Context& context) {
    check_surface(vertices, triangles, "the surface");
    check_zones(zones, vertices.rows());
    CurvatureReport report;
    report.field = estimate_curvature(vertices, triangles, options, context, [&](double share) {
        context.progress(Stage::measuring, share);
    });
    const Vector areas = vertex_areas(vertices, triangles);
    const std::vector<char> all(static_cast<std::size_t>(vertices.rows()), 1);
    report.whole = summary_of(report.field, areas, all, "whole");
    for (const Zone& zone : zones)
        report.zones.push_back(
            summary_of(report.field, areas, membership(zone.vertices, vertices.rows()), zone.name));
    return report;
}

}  // namespace mien
