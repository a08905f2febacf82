#include "measure/scan_volume.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "measure/area.hpp"
#include "measure/border.hpp"
#include "measure/pair_check.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/topology.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

// The nearer hit of both senses of a ray; false when neither lies within `limit`.
bool shoot(const TriangleTree& tree, const Vector3& from, const Vector3& unit, double limit,
           Vector3& hit) {
    const RayHit ahead = tree.first_hit(from, unit, limit);
    const RayHit behind = tree.first_hit(from, -unit, limit);
    if (!ahead.valid() && !behind.valid()) return false;
    hit = ahead.valid() && (!behind.valid() || ahead.t <= behind.t)
              ? Vector3(from + ahead.t * unit)
              : Vector3(from - behind.t * unit);
    return true;
}

void carry_vertices(const TriMesh& before, const TriMesh& after, const ScanVolumeOptions& options,
                    ScanVolumeReport& report, const Context& context) {
    const TriangleTree tree(after.vertices, after.triangles, context);
    const std::size_t n = static_cast<std::size_t>(before.vertices.rows());
    report.carried = before.vertices;
    report.valid.assign(n, 0);
    if (options.carry == Carry::closest_point) {
        std::vector<SurfaceHit> hits;
        tree.closest(before.vertices, options.max_distance_mm, hits, context);
        const std::vector<std::uint8_t> border =
            border_vertices(after.triangles, after.vertices.rows(), context);
        for (std::size_t v = 0; v < n; ++v)
            if (hits[v].valid() &&
                !on_border(border, after.triangles, hits[v].triangle, hits[v].barycentric)) {
                report.carried.row(static_cast<Index>(v)) = hits[v].point;
                report.valid[v] = 1;
            }
        return;
    }
    const Points normals = vertex_normals(before.vertices, before.triangles);
    const Vector3 fixed = options.direction.normalized();
    parallel_for(context, n, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Index row = static_cast<Index>(v);
            const Vector3 unit =
                options.carry == Carry::direction ? fixed : Vector3(normals.row(row));
            Vector3 hit;
            if (unit.squaredNorm() > 0 &&
                shoot(tree, before.vertices.row(row), unit, options.max_distance_mm, hit)) {
                report.carried.row(row) = hit;
                report.valid[v] = 1;
            }
        }
    });
}

}  // namespace

ScanVolumeReport measure_scan_volume(const TriMesh& before, const TriMesh& after,
                                     const ScanVolumeOptions& options, const Context& context) {
    check_surface(before.vertices, before.triangles, "the before surface");
    check_surface(after.vertices, after.triangles, "the after surface");
    check_patches(options.zones, before.triangles, before.vertices.rows());
    if (!(options.max_distance_mm > 0) || !options.direction.allFinite() ||
        (options.carry == Carry::direction && !(options.direction.norm() > 0)))
        fail(Status::invalid_argument,
             "a largest distance of %g mm must be positive and the direction not zero",
             options.max_distance_mm);
    ScanVolumeReport report;
    carry_vertices(before, after, options, report, context);

    std::vector<Index> kept;
    for (Index t = 0; t < before.triangles.rows(); ++t)
        if (report.valid[before.triangles(t, 0)] && report.valid[before.triangles(t, 1)] &&
            report.valid[before.triangles(t, 2)])
            kept.push_back(t);
    const auto check_unit = [&] {
        constexpr double kTooDifferent = 5;
        check_same_unit(before.vertices, "the before surface", after.vertices, "the after surface",
                        kTooDifferent);
    };
    if (kept.empty()) {
        check_unit();
        fail(Status::no_solution,
             "no triangle of the before surface has a partner within %g mm; align the surfaces "
             "first",
             options.max_distance_mm);
    }
    Triangles triangles(static_cast<Index>(kept.size()), 3);
    for (std::size_t i = 0; i < kept.size(); ++i)
        triangles.row(static_cast<Index>(i)) = before.triangles.row(kept[i]);
    const Vector all = vertex_areas(before.vertices, before.triangles);
    const Vector used = vertex_areas(before.vertices, triangles);
    report.whole_coverage = used.sum() / all.sum();
    constexpr double kLeastCoverage = 0.05;
    if (report.whole_coverage < kLeastCoverage) check_unit();
    report.volume =
        measure_volume(before.vertices, report.carried, triangles, options.zones, context);

    for (const Zone& zone : options.zones) {
        const std::vector<char> inside = membership(zone.vertices, before.vertices.rows());
        double whole = 0.0, part = 0.0;
        for (Index v = 0; v < all.size(); ++v)
            if (inside[static_cast<std::size_t>(v)]) {
                whole += all[v];
                part += used[v];
            }
        report.zone_coverage.push_back(whole > 0 ? part / whole : 0.0);
    }
    return report;
}

RigidZoneResult align_scans_on_zone(const TriMesh& source, const TriMesh& target,
                                    const std::vector<std::uint32_t>& zone, const Similarity& start,
                                    const ScanAlignmentOptions& options, const Context& context) {
    check_surface(source.vertices, source.triangles, "the source surface");
    check_surface(target.vertices, target.triangles, "the target surface");
    if (!(options.max_distance_mm > 0) || options.rounds < 1)
        fail(Status::invalid_argument, "largest distance %g mm, %d rounds; both must be positive",
             options.max_distance_mm, options.rounds);
    std::vector<std::uint32_t> chosen(zone);
    if (chosen.empty()) {
        chosen.resize(static_cast<std::size_t>(target.vertices.rows()));
        for (std::size_t v = 0; v < chosen.size(); ++v) chosen[v] = static_cast<std::uint32_t>(v);
    }
    const std::vector<char> inside = membership(chosen, target.vertices.rows());
    const TriangleTree tree(source.vertices, source.triangles, context);
    const std::vector<std::uint8_t> border =
        border_vertices(source.triangles, source.vertices.rows(), context);
    const Points normals = vertex_normals(target.vertices, target.triangles);
    const Vector areas = vertex_areas(target.vertices, target.triangles);
    Index in_zone = 0;
    for (char c : inside) in_zone += c;
    Points queries(in_zone, 3), zone_normals(in_zone, 3);
    Vector zone_areas_mm2(in_zone);
    for (Index v = 0, i = 0; v < target.vertices.rows(); ++v)
        if (inside[static_cast<std::size_t>(v)]) {
            queries.row(i) = target.vertices.row(v);
            zone_normals.row(i) = normals.row(v);
            zone_areas_mm2[i++] = areas[v];
        }
    RigidZoneResult result;
    result.motion = start;
    result.motion.scale = 1.0;
    double reach = options.max_distance_mm;
    RigidZoneOptions step = options.rigid;
    step.tangential = std::min(step.tangential, 0.01);  // closest points slide freely
    step.iterations = 3;
    std::vector<SurfaceHit> hits;
    for (int round = 0; round < options.rounds; ++round) {
        context.progress(Stage::alignment, static_cast<double>(round) / options.rounds);
        const Points local = result.motion.inverse().apply(PointsRef(queries));
        tree.closest(local, reach, hits, context);
        std::vector<Index> used;
        for (Index i = 0; i < in_zone; ++i) {
            const SurfaceHit& hit = hits[static_cast<std::size_t>(i)];
            if (hit.valid() && !on_border(border, source.triangles, hit.triangle, hit.barycentric))
                used.push_back(i);
        }
        const Index n = static_cast<Index>(used.size());
        Points from(n, 3), to(n, 3), pair_normals(n, 3);
        Vector pair_areas(n);
        for (Index k = 0; k < n; ++k) {
            const Index i = used[static_cast<std::size_t>(k)];
            from.row(k) = hits[static_cast<std::size_t>(i)].point;
            to.row(k) = queries.row(i);
            pair_normals.row(k) = zone_normals.row(i);
            pair_areas[k] = zone_areas_mm2[i];
        }
        const Similarity previous = result.motion;
        result = align_pairs(from, to, pair_normals, pair_areas, previous, step);
        reach = std::max(2.0, std::min(reach, 6.0 * result.rms_mm));
        const double moved =
            (result.motion.apply(PointsRef(from)) - previous.apply(PointsRef(from))).norm() /
            std::sqrt(static_cast<double>(n));
        if (moved < 1e-5) break;
    }
    context.progress(Stage::alignment, 1.0);
    return result;
}

RigidZoneResult align_fits_on_zone(const PointsRef& source, const TriMesh& target,
                                   const std::vector<std::uint32_t>& zone, const Context& context) {
    const RigidZoneResult paired =
        align_on_zone(source, target.vertices, target.triangles, zone, RigidZoneOptions());
    TriMesh moving;
    moving.vertices = source;
    moving.triangles = target.triangles;
    ScanAlignmentOptions options;
    options.max_distance_mm = 5;
    return align_scans_on_zone(moving, target, zone, paired.motion, options, context);
}

}  // namespace mien
