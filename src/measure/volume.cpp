#include "measure/volume.hpp"

#include <algorithm>
#include <Eigen/Geometry>

#include "base/parallel.hpp"
#include "measure/area.hpp"
#include "measure/pair_check.hpp"

namespace mien {
namespace {

constexpr std::size_t kChunk = 4096;

// Integrals over a triangle (as means) of hat function i times the positive part of the linear
// function with corner values c. Where one corner p stands alone on its side of zero, the cut
// leaves a triangle at p with corner values (c_p, 0, 0) and area fraction s t; a product of two
// linear functions f, g integrates to (sum f sum g + sum f g) / 12 over a triangle of unit mean.
void integrate_parts(const double c[3], double positive[3], double negative[3]) {
    double full[3];
    const double sum = c[0] + c[1] + c[2];
    for (int i = 0; i < 3; ++i) full[i] = (sum + c[i]) / 12.0;
    const int num_positive = (c[0] > 0) + (c[1] > 0) + (c[2] > 0);
    const int num_negative = (c[0] < 0) + (c[1] < 0) + (c[2] < 0);
    if (num_negative == 0 || num_positive == 0) {
        for (int i = 0; i < 3; ++i) {
            positive[i] = num_negative == 0 ? full[i] : 0.0;
            negative[i] = num_negative == 0 ? 0.0 : full[i];
        }
        return;
    }
    // With signs (+, -, 0) the single positive corner serves: one of s, t is then one.
    const bool lone_is_positive = num_positive == 1;
    int p = 0;
    while (lone_is_positive ? !(c[p] > 0) : !(c[p] < 0)) ++p;
    const int q = (p + 1) % 3, r = (p + 2) % 3;
    const double s = c[p] / (c[p] - c[q]), t = c[p] / (c[p] - c[r]);
    const double scale = s * t * c[p] / 12.0;
    double lone[3];
    lone[p] = scale * (4.0 - s - t);
    lone[q] = scale * s;
    lone[r] = scale * t;
    for (int i = 0; i < 3; ++i) {
        if (lone_is_positive) {
            positive[i] = lone[i];
            negative[i] = std::min(0.0, full[i] - lone[i]);
        } else {
            negative[i] = lone[i];
            positive[i] = std::max(0.0, full[i] - lone[i]);
        }
    }
}

VolumeParts to_millilitres(double positive_mm3, double negative_mm3) {
    VolumeParts parts;
    parts.positive_ml = positive_mm3 * 1e-3;
    parts.negative_ml = negative_mm3 * 1e-3;
    parts.signed_ml = parts.positive_ml + parts.negative_ml;
    parts.absolute_ml = parts.positive_ml - parts.negative_ml;
    return parts;
}

}  // namespace

VertexVolumes volume_per_vertex(const PointsRef& before, const PointsRef& after,
                                const TrianglesRef& triangles, const Context& context) {
    check_faces_in_correspondence(before, after, triangles);
    const std::size_t num_triangles = static_cast<std::size_t>(triangles.rows());
    context.require_memory(num_triangles * 48 + static_cast<std::size_t>(before.rows()) * 16,
                           "volume shares");
    // positive of the three corners, then negative
    Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> corner_parts(triangles.rows(), 6);
    parallel_for(context, num_triangles, kChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const Index row = static_cast<Index>(t);
            Vector3 p[3], d[3];
            for (int k = 0; k < 3; ++k) {
                p[k] = before.row(triangles(row, k));
                d[k] = Vector3(after.row(triangles(row, k))) - p[k];
            }
            const Vector3 e1 = p[1] - p[0], e2 = p[2] - p[0];
            const Vector3 f1 = d[1] - d[0], f2 = d[2] - d[0];
            // Mean over t of (e1 + t f1) x (e2 + t f2) / 2.
            const Vector3 area_vector =
                0.5 * (e1.cross(e2) + 0.5 * (e1.cross(f2) + f1.cross(e2)) + f1.cross(f2) / 3.0);
            double c[3];
            for (int k = 0; k < 3; ++k) c[k] = area_vector.dot(d[k]);
            double* parts = corner_parts.row(row).data();
            integrate_parts(c, parts, parts + 3);
        }
    });
    VertexVolumes shares;
    shares.positive_mm3 = Vector::Zero(before.rows());
    shares.negative_mm3 = Vector::Zero(before.rows());
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            shares.positive_mm3[triangles(t, k)] += corner_parts(t, k);
            shares.negative_mm3[triangles(t, k)] += corner_parts(t, 3 + k);
        }
    return shares;
}

VolumeParts volume_of(const VertexVolumes& shares, const std::vector<std::uint32_t>& vertices) {
    const std::vector<char> inside = membership(vertices, shares.positive_mm3.size());
    double positive = 0.0, negative = 0.0;
    for (Index v = 0; v < shares.positive_mm3.size(); ++v)
        if (inside[static_cast<std::size_t>(v)]) {
            positive += shares.positive_mm3[v];
            negative += shares.negative_mm3[v];
        }
    return to_millilitres(positive, negative);
}

VolumeParts volume_of(const VertexVolumes& shares) {
    return to_millilitres(shares.positive_mm3.sum(), shares.negative_mm3.sum());
}

VolumeReport measure_volume(const PointsRef& before, const PointsRef& after,
                            const TrianglesRef& triangles, const std::vector<Zone>& zones,
                            const Context& context) {
    context.progress(Stage::measuring, 0.0);
    const VertexVolumes shares = volume_per_vertex(before, after, triangles, context);
    check_patches(zones, triangles, before.rows());
    const Vector area_before = vertex_areas(before, triangles);
    const Vector area_after = vertex_areas(after, triangles);
    auto measure_set = [&](const std::string& name, const std::vector<std::uint32_t>& vertices) {
        ZoneVolume zone;
        zone.name = name;
        zone.volume = volume_of(shares, vertices);
        const std::vector<char> inside = membership(vertices, before.rows());
        for (Index v = 0; v < before.rows(); ++v)
            if (inside[static_cast<std::size_t>(v)]) {
                zone.area_before_mm2 += area_before[v];
                zone.area_after_mm2 += area_after[v];
            }
        return zone;
    };
    VolumeReport report;
    report.whole.name = "whole";
    report.whole.volume = volume_of(shares);
    report.whole.area_before_mm2 = area_before.sum();
    report.whole.area_after_mm2 = area_after.sum();
    std::vector<char> covered(static_cast<std::size_t>(before.rows()), 0);
    for (const Zone& zone : zones) {
        report.zones.push_back(measure_set(zone.name, zone.vertices));
        const std::vector<char> inside = membership(zone.vertices, before.rows());
        for (std::size_t v = 0; v < inside.size(); ++v)
            if (inside[v]) {
                if (covered[v]) report.zones_disjoint = false;
                covered[v] = 1;
            }
    }
    std::vector<std::uint32_t> uncovered;
    for (std::size_t v = 0; v < covered.size(); ++v)
        if (!covered[v]) uncovered.push_back(static_cast<std::uint32_t>(v));
    report.rest = measure_set("rest", uncovered);
    context.progress(Stage::measuring, 1.0);
    return report;
}

}  // namespace mien
