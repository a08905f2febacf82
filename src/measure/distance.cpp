#include "measure/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "geometry/normals.hpp"
#include "measure/area.hpp"
#include "measure/border.hpp"
#include "measure/pair_check.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/topology.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

DistanceSummary summarise(const std::string& name, const DistanceReport& report,
                          const Vector& areas, const std::vector<char>& inside) {
    DistanceSummary s;
    s.name = name;
    double weight = 0.0, sum = 0.0, absolute = 0.0, square = 0.0, length = 0.0;
    for (Index v = 0; v < areas.size(); ++v) {
        if (!inside[static_cast<std::size_t>(v)] || !std::isfinite(report.length_mm[v])) continue;
        ++s.num_vertices;
        s.max_length_mm = std::max(s.max_length_mm, report.length_mm[v]);
        weight += areas[v];
        sum += areas[v] * report.signed_mm[v];
        absolute += areas[v] * std::fabs(report.signed_mm[v]);
        square += areas[v] * report.length_mm[v] * report.length_mm[v];
        length += areas[v] * report.length_mm[v];
    }
    if (!(weight > 0)) {
        s.mean_signed_mm = s.sd_signed_mm = s.mean_absolute_mm = s.rms_mm = s.mean_length_mm =
            s.median_length_mm = s.p95_length_mm = s.max_length_mm = kNone;
        return s;
    }
    s.mean_signed_mm = sum / weight;
    s.mean_absolute_mm = absolute / weight;
    s.rms_mm = std::sqrt(square / weight);
    s.mean_length_mm = length / weight;
    double spread = 0.0;
    for (Index v = 0; v < areas.size(); ++v)
        if (inside[static_cast<std::size_t>(v)] && std::isfinite(report.length_mm[v])) {
            const double d = report.signed_mm[v] - s.mean_signed_mm;
            spread += areas[v] * d * d;
        }
    s.sd_signed_mm = std::sqrt(spread / weight);
    s.median_length_mm = weighted_quantile(report.length_mm, areas, inside, 0.5);
    s.p95_length_mm = weighted_quantile(report.length_mm, areas, inside, 0.95);
    return s;
}

void summarise_all(DistanceReport& report, const Vector& areas, const std::vector<Zone>& zones) {
    const std::vector<char> all(static_cast<std::size_t>(areas.size()), 1);
    report.whole = summarise("whole", report, areas, all);
    for (const Zone& zone : zones)
        report.zones.push_back(
            summarise(zone.name, report, areas, membership(zone.vertices, areas.size())));
}

// Lengths and signs from the vertices of one surface to the other.
void measure_one_side(const TriMesh& from, const TriMesh& to, double limit, bool skip_borders,
                      Vector& lengths, Points& vectors, const Context& context) {
    const TriangleTree tree(to.vertices, to.triangles, context);
    std::vector<SurfaceHit> hits;
    tree.closest(from.vertices, limit, hits, context);
    std::vector<std::uint8_t> border;
    if (skip_borders && to.triangles.rows() > 0)
        border = border_vertices(to.triangles, to.vertices.rows(), context);
    lengths = Vector::Constant(from.vertices.rows(), kNone);
    vectors = Points::Zero(from.vertices.rows(), 3);
    for (Index v = 0; v < from.vertices.rows(); ++v) {
        const SurfaceHit& hit = hits[static_cast<std::size_t>(v)];
        if (!hit.valid()) continue;
        if (!border.empty() && on_border(border, to.triangles, hit.triangle, hit.barycentric))
            continue;
        lengths[v] = hit.distance();
        vectors.row(v) = hit.point.transpose() - from.vertices.row(v);
    }
}

}  // namespace

double weighted_quantile(const Vector& values, const Vector& weights,
                         const std::vector<char>& inside, double q) {
    if (!(q >= 0 && q <= 1))
        fail(Status::invalid_argument, "quantile %g; use a number from 0 to 1", q);
    std::vector<std::pair<double, double>> sorted;
    double total = 0.0;
    for (Index v = 0; v < values.size(); ++v)
        if (inside[static_cast<std::size_t>(v)] && std::isfinite(values[v]) && weights[v] > 0) {
            sorted.emplace_back(values[v], weights[v]);
            total += weights[v];
        }
    if (sorted.empty()) return kNone;
    std::sort(sorted.begin(), sorted.end());
    double below = 0.0;
    for (const auto& entry : sorted) {
        below += entry.second;
        if (below >= q * total) return entry.first;
    }
    return sorted.back().first;
}

DistanceReport measure_distance(const PointsRef& before, const PointsRef& after,
                                const TrianglesRef& triangles, const std::vector<Zone>& zones,
                                const Context& context) {
    context.progress(Stage::measuring, 0.0);
    check_faces_in_correspondence(before, after, triangles);
    check_zones(zones, before.rows());
    const Points normals = vertex_normals(before, triangles);
    const Points displacement = after - before;
    DistanceReport report;
    report.length_mm = displacement.rowwise().norm();
    report.signed_mm = displacement.cwiseProduct(normals).rowwise().sum();
    summarise_all(report, vertex_areas(before, triangles), zones);
    report.hausdorff_mm = report.whole.max_length_mm;
    context.progress(Stage::measuring, 1.0);
    return report;
}

namespace {

/// A patch may be measured against a whole head, but then it lies near it.
void check_units(const TriMesh& from, const TriMesh& to, const Vector& length_mm) {
    constexpr double kTooDifferent = 5, kNear_mm = 10, kLeastShare = 0.05;
    const double near = static_cast<double>((length_mm.array() <= kNear_mm).count());
    if (near < kLeastShare * static_cast<double>(length_mm.size()))
        check_same_unit(from.vertices, "the first surface", to.vertices, "the second surface",
                        kTooDifferent);
}

}  // namespace

DistanceReport measure_surface_distance(const TriMesh& from, const TriMesh& to,
                                        const std::vector<Zone>& zones, double max_distance_mm,
                                        bool skip_borders, const Context& context) {
    context.progress(Stage::measuring, 0.0);
    check_surface(from.vertices, from.triangles, "the first surface");
    check_mesh(to, "the second surface");
    check_zones(zones, from.vertices.rows());
    const double limit =
        max_distance_mm > 0 ? max_distance_mm : std::numeric_limits<double>::infinity();
    DistanceReport report;
    Points vectors;
    measure_one_side(from, to, limit, skip_borders, report.length_mm, vectors, context);
    check_units(from, to, report.length_mm);
    context.progress(Stage::measuring, 0.5);
    // The sign says on which side of the first surface the second one lies.
    const Points normals = vertex_normals(from.vertices, from.triangles);
    report.signed_mm = vectors.cwiseProduct(normals).rowwise().sum();
    for (Index v = 0; v < report.length_mm.size(); ++v) {
        if (!std::isfinite(report.length_mm[v]))
            report.signed_mm[v] = kNone;
        else
            report.signed_mm[v] = std::copysign(report.length_mm[v], report.signed_mm[v]);
    }
    summarise_all(report, vertex_areas(from.vertices, from.triangles), zones);
    Vector back_lengths;
    Points back_vectors;
    measure_one_side(to, from, limit, skip_borders, back_lengths, back_vectors, context);
    report.hausdorff_mm = report.whole.max_length_mm;
    for (Index v = 0; v < back_lengths.size(); ++v)
        if (std::isfinite(back_lengths[v]) && !(report.hausdorff_mm >= back_lengths[v]))
            report.hausdorff_mm = back_lengths[v];
    context.progress(Stage::measuring, 1.0);
    return report;
}

}  // namespace mien
