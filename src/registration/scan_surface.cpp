#include "registration/scan_surface.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "mesh/triangle_fans.hpp"
#include "registration/scan_cloud.hpp"

namespace mien {
namespace {

// Lengths in mm below which a distance, and of a sum of unit normals below which a direction,
// counts as nothing: far under any scanner's resolution, far above rounding.
constexpr double kTiny_mm = 1e-9, kShortest = 1e-12;
// Barycentric share below which a hit lies on the opposite edge.
constexpr double kOnEdge = 1e-9;

// Rounds of averaging that spread a value over `smoothing_mm`.
int rounds_for(double smoothing_mm, double spacing_mm, int most) {
    const double ratio = smoothing_mm / spacing_mm;
    return static_cast<int>(std::min(static_cast<double>(most), std::ceil(ratio * ratio)));
}

constexpr std::size_t kChunk = 8192;  // vertices or triangles at a time

double mean_edge_mm(const Points& vertices, const Triangles& triangles, const Context& context) {
    const Index count = triangles.rows();
    const double total = parallel_sum<double>(
        context, static_cast<std::size_t>(count), kChunk, 0,
        [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (Index t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
                for (int k = 0; k < 3; ++k)
                    sum += (vertices.row(triangles(t, k)) - vertices.row(triangles(t, (k + 1) % 3)))
                               .norm();
            return sum;
        });
    return count > 0 ? total / static_cast<double>(3 * count) : 0;
}

// A vertex' values, filled up to what one instruction loads.
using PackedNormals = Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor>;
using PackedBending = Eigen::Matrix<float, Eigen::Dynamic, 8, Eigen::RowMajor>;

void smooth_normals(ScanSurface& scan, const TriangleFans& fans,
                    const ScanSurfaceSettings& settings, const Context& context) {
    if (!(scan.spacing_mm > 0 && settings.smoothing_mm > 0)) return;
    const int rounds =
        rounds_for(settings.smoothing_mm, scan.spacing_mm, settings.most_normal_rounds);
    const Index n = scan.normals.rows();
    PackedNormals normals = PackedNormals::Zero(n, 4), sums(n, 4);
    normals.leftCols<3>() = scan.normals.cast<float>();
    for (int round = 0; round < rounds; ++round) {
        parallel_for(
            context, static_cast<std::size_t>(n), kChunk, [&](std::size_t begin, std::size_t end) {
                fans.add_up(normals, begin, end, sums);
                for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
                    const float length = sums.row(i).norm();
                    if (length > kShortest)
                        sums.row(i) /= length;
                    else
                        sums.row(i) = normals.row(i);
                }
            });
        normals.swap(sums);
    }
    parallel_for(
        context, static_cast<std::size_t>(n), kChunk, [&](std::size_t begin, std::size_t end) {
            for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
                const Eigen::RowVector3d normal = normals.row(i).head<3>().cast<double>();
                const double length = normal.norm();
                scan.normals.row(i) = length > 0 ? Eigen::RowVector3d(normal / length) : normal;
            }
        });
}

// S from the gradient of the vertex normals over each triangle: n(x) is linear there, S = grad n in
// the plane of the triangle, made symmetric. S and twice the area, 0 where there is no direction.
Eigen::Matrix<float, 1, 8> triangle_bending(const ScanSurface& scan, Index t) {
    Vector3 x[3], m[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = scan.vertices.row(scan.triangles(t, k)).transpose();
        m[k] = scan.normals.row(scan.triangles(t, k)).transpose();
    }
    Eigen::Matrix<float, 1, 8> packed = Eigen::Matrix<float, 1, 8>::Zero();
    const Vector3 cross = (x[1] - x[0]).cross(x[2] - x[0]);
    const double twice = cross.norm();
    if (!(twice > kTiny_mm)) return packed;
    const Vector3 normal = cross / twice;
    Matrix3 gradient = Matrix3::Zero();  // sum of n_k (grad of the hat function k)'
    for (int k = 0; k < 3; ++k)
        gradient += m[k] * normal.cross(x[(k + 2) % 3] - x[(k + 1) % 3]).transpose();
    gradient /= twice;
    const Matrix3 flat = Matrix3::Identity() - normal * normal.transpose();
    gradient = flat * gradient;
    const Matrix3 s = 0.5 * (gradient + gradient.transpose());
    packed.head<7>() = (Eigen::Matrix<double, 1, 7>() << s(0, 0), s(1, 1), s(2, 2), s(0, 1),
                        s(0, 2), s(1, 2), twice)
                           .finished()
                           .cast<float>();
    return packed;
}

// Area-weighted means go to the vertices, then averages over smoothing_mm.
void find_bending(ScanSurface& scan, const TriangleFans& fans, const ScanSurfaceSettings& settings,
                  const Context& context) {
    // Triangles are looked at by all threads, and added in their order by one: so many at a time.
    constexpr Index kWindow = 1 << 16;
    const Index n = scan.vertices.rows(), count = scan.triangles.rows();
    PackedBending field = PackedBending::Zero(n, 8), sums(std::min(count, kWindow), 8);
    std::vector<float> area(static_cast<std::size_t>(n), 0.0f);
    for (Index first = 0; first < count; first += kWindow) {
        const Index many = std::min(kWindow, count - first);
        parallel_for(context, static_cast<std::size_t>(many), kChunk,
                     [&](std::size_t begin, std::size_t end) {
                         for (Index t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
                             sums.row(t) = triangle_bending(scan, first + t);
                     });
        for (Index t = 0; t < many; ++t) {
            const float twice = sums(t, 6);
            if (!(twice > 0)) continue;
            Eigen::Matrix<float, 1, 8> packed = sums.row(t);
            packed[6] = 0;
            for (int k = 0; k < 3; ++k) {
                field.row(scan.triangles(first + t, k)) += twice * packed;
                area[scan.triangles(first + t, k)] += twice;
            }
        }
    }
    sums.resize(n, 8);
    for (Index i = 0; i < n; ++i)
        if (area[static_cast<std::size_t>(i)] > 0)
            field.row(i) /= area[static_cast<std::size_t>(i)];
    const int rounds = rounds_for(settings.smoothing_mm, std::max(kTiny_mm, scan.spacing_mm),
                                  settings.most_bending_rounds);
    for (int round = 0; round < rounds; ++round) {
        parallel_for(
            context, static_cast<std::size_t>(n), kChunk, [&](std::size_t begin, std::size_t end) {
                fans.add_up(field, begin, end, sums);
                for (std::size_t v = begin; v < end; ++v)
                    if (fans.count(v) > 0)
                        sums.row(static_cast<Index>(v)) /= static_cast<float>(3 * fans.count(v));
            });
        field.swap(sums);
    }
    sums.resize(0, 8);
    scan.bending = field.leftCols<6>();
}

}  // namespace

Matrix3 ScanSurface::bending_at(const SurfaceHit& hit) const {
    Matrix3 s = Matrix3::Zero();
    if (bending.rows() == 0) return s;
    Eigen::Matrix<double, 1, 6> packed = Eigen::Matrix<double, 1, 6>::Zero();
    for (int k = 0; k < 3; ++k)
        packed += hit.barycentric[k] *
                  bending.row(triangles(static_cast<Index>(hit.triangle), k)).cast<double>();
    s << packed[0], packed[3], packed[4], packed[3], packed[1], packed[5], packed[4], packed[5],
        packed[2];
    return s;
}

Vector3 ScanSurface::normal_at(const SurfaceHit& hit) const {
    if (tree.is_point_cloud()) return normals.row(static_cast<Index>(hit.triangle)).transpose();
    Vector3 normal = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        normal += hit.barycentric[k] *
                  normals.row(static_cast<Index>(triangles(static_cast<Index>(hit.triangle), k)))
                      .transpose();
    const double length = normal.norm();
    return length > kShortest ? Vector3(normal / length) : Vector3(Vector3::Zero());
}

namespace {

/// Between the vertices of a triangle; 1 without values.
double interpolated(const ScanSurface& scan, const Vector& values, const SurfaceHit& hit) {
    if (values.size() == 0) return 1;
    double sum = 0;
    for (int c = 0; c < 3; ++c)
        sum +=
            hit.barycentric[c] * values[scan.tree.is_point_cloud()
                                            ? static_cast<Index>(hit.triangle)
                                            : static_cast<Index>(scan.triangles(hit.triangle, c))];
    return sum;
}

}  // namespace

double ScanSurface::weight_at(const SurfaceHit& hit) const {
    if (!images.weighs_skin || !images.cover(hit)) return interpolated(*this, weight, hit);
    const Vector3 color = images.sampler.color(hit.triangle, hit.barycentric, images.radius_mm);
    return interpolated(*this, images.given_weight, hit) * skin_weight(color, images.skin);
}

Eigen::Vector2d ScanSurface::colors_at(const SurfaceHit& hit) const {
    const Index t = static_cast<Index>(hit.triangle);
    if (images.cover(hit))
        return color_signal(images.sampler.color(hit.triangle, hit.barycentric, images.radius_mm),
                            images.signals);
    if (tree.is_point_cloud()) return colors.row(t).transpose().cast<double>();
    Eigen::Vector2d signals = Eigen::Vector2d::Zero();
    for (int c = 0; c < 3; ++c)
        signals += hit.barycentric[c] * colors.row(triangles(t, c)).transpose().cast<double>();
    return signals;
}

bool ScanSurface::at_border(const SurfaceHit& hit) const {
    if (tree.is_point_cloud()) return false;
    // A place strictly inside a triangle is off the border, even when two of its corners are on it.
    bool inside = true, all_border = true;
    for (int k = 0; k < 3; ++k) {
        if (hit.barycentric[k] > kOnEdge)
            all_border =
                all_border && on_border[triangles(static_cast<Index>(hit.triangle), k)] != 0;
        else
            inside = false;
    }
    return !inside && all_border;
}

double ScanSurface::off_border(const SurfaceHit& hit) const {
    if (tree.is_point_cloud()) return 1;
    double off = 0;
    for (int k = 0; k < 3; ++k)
        if (on_border[triangles(static_cast<Index>(hit.triangle), k)] == 0)
            off += hit.barycentric[k];
    return off;
}

ScanSurface build_scan_surface(const TriMesh& mesh, const ScanSurfaceSettings& settings,
                               const Context& context) {
    return build_scan_surface(Points(mesh.vertices), Triangles(mesh.triangles),
                              TriangleFans(mesh.vertices.rows(), mesh.triangles, context), settings,
                              context);
}

ScanSurface build_scan_surface(Points&& vertices, Triangles&& triangles, const TriangleFans& fans,
                               const ScanSurfaceSettings& settings, const Context& context) {
    ScanSurface scan;
    scan.vertices = std::move(vertices);
    scan.triangles = std::move(triangles);
    scan.tree = TriangleTree(scan.vertices, scan.triangles, context);
    if (scan.tree.is_point_cloud()) {
        scan.on_border.assign(static_cast<std::size_t>(scan.vertices.rows()), 0);
        scan.spacing_mm = scan.vertices.rows() > 1 ? cloud_spacing(scan.vertices, settings) : 1;
        const double radius_mm =
            std::max(settings.normal_spacings * scan.spacing_mm, settings.smoothing_mm);
        scan.normals = cloud_normals(scan.vertices, radius_mm, settings, context);
        return scan;
    }
    scan.on_border = fans.border(context);
    scan.normals = vertex_normals(scan.vertices, scan.triangles);
    scan.spacing_mm = mean_edge_mm(scan.vertices, scan.triangles, context);
    smooth_normals(scan, fans, settings, context);
    find_bending(scan, fans, settings, context);
    return scan;
}

}  // namespace mien
