#include "registration/scan_surface.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// Border vertices: ends of edges that one triangle alone uses. Edges are found per lower vertex in
// a compressed list, because a scan's edges may be used by any number of triangles.
std::vector<std::uint8_t> find_border(Index num_vertices, const Triangles& triangles) {
    const std::size_t n = static_cast<std::size_t>(num_vertices);
    std::vector<std::uint32_t> begin(n + 1, 0),
        other(static_cast<std::size_t>(3 * triangles.rows()));
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            ++begin[std::min(triangles(t, k), triangles(t, (k + 1) % 3)) + 1];
    for (std::size_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            other[next[std::min(a, b)]++] = std::max(a, b);
        }
    std::vector<std::uint8_t> border(n, 0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::uint32_t e = begin[i]; e < begin[i + 1]; ++e) {
            std::size_t uses = 0;
            for (std::uint32_t f = begin[i]; f < begin[i + 1]; ++f) uses += other[f] == other[e];
            if (uses == 1) border[i] = border[other[e]] = 1;
        }
    return border;
}

// Mean distance to the nearest other point, from a sample.
double cloud_spacing(const Points& points) {
    const Index n = points.rows(), stride = std::max<Index>(1, n / 150);
    std::vector<double> nearest;
    for (Index i = 0; i < n; i += stride) {
        double best = 1e300;
        for (Index j = 0; j < n; ++j)
            if (j != i) best = std::min(best, (points.row(i) - points.row(j)).squaredNorm());
        nearest.push_back(std::sqrt(best));
    }
    std::nth_element(nearest.begin(),
                     nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2),
                     nearest.end());
    return nearest[nearest.size() / 2];
}

// Normals of a cloud: smallest direction of the points within a radius, turned away from the
// cloud's middle, which lies behind a face.
Points cloud_normals(const Points& points, double radius, const Context& context) {
    const Index n = points.rows();
    const Eigen::RowVector3d low = points.colwise().minCoeff(), middle = points.colwise().mean();
    struct Entry {
        std::int64_t key;
        std::uint32_t point;
    };
    const auto key_of = [&](double x, double y, double z) {
        const auto cell = [&](double v) {
            return static_cast<std::int64_t>(std::floor(v / radius)) & 0x1fffff;
        };
        return cell(x) << 42 | cell(y) << 21 | cell(z);
    };
    std::vector<Entry> cells(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i)
        cells[static_cast<std::size_t>(i)] = {
            key_of(points(i, 0) - low[0], points(i, 1) - low[1], points(i, 2) - low[2]),
            static_cast<std::uint32_t>(i)};
    std::sort(cells.begin(), cells.end(), [](const Entry& a, const Entry& b) {
        return a.key < b.key || (a.key == b.key && a.point < b.point);
    });
    Points normals = Points::Zero(n, 3);
    parallel_for(
        context, static_cast<std::size_t>(n), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const Eigen::RowVector3d centre = points.row(static_cast<Index>(k));
                Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
                Matrix3 squares = Matrix3::Zero();
                int count = 0;
                for (int a = -1; a <= 1; ++a)
                    for (int b = -1; b <= 1; ++b)
                        for (int c = -1; c <= 1; ++c) {
                            const Eigen::RowVector3d at =
                                centre - low + radius * Eigen::RowVector3d(a, b, c);
                            const std::int64_t key = key_of(at[0], at[1], at[2]);
                            auto entry = std::lower_bound(
                                cells.begin(), cells.end(), key,
                                [](const Entry& e, std::int64_t v) { return e.key < v; });
                            for (; entry != cells.end() && entry->key == key && count < 200;
                                 ++entry) {
                                const Eigen::RowVector3d d = points.row(entry->point) - centre;
                                if (d.squaredNorm() > radius * radius) continue;
                                sum += d;
                                squares += d.transpose() * d;
                                ++count;
                            }
                        }
                if (count < 4) continue;
                Eigen::SelfAdjointEigenSolver<Matrix3> eigen;
                eigen.computeDirect(
                    Matrix3(squares / count - sum.transpose() * sum / (count * count)));
                Vector3 normal = eigen.eigenvectors().col(0);
                if (normal.dot((centre - middle).transpose()) < 0) normal = -normal;
                normals.row(static_cast<Index>(k)) = normal.transpose();
            }
        });
    return normals;
}

// One round of averaging a field with one row per vertex over the triangles around it.
template <typename Rows>
void average_over_triangles(const Triangles& triangles, const std::vector<float>& share,
                            Rows& field) {
    Rows sum = Rows::Zero(field.rows(), field.cols());
    for (Index t = 0; t < triangles.rows(); ++t) {
        const auto mean =
            (field.row(triangles(t, 0)) + field.row(triangles(t, 1)) + field.row(triangles(t, 2)))
                .eval();
        for (int k = 0; k < 3; ++k) sum.row(triangles(t, k)) += mean;
    }
    for (Index i = 0; i < field.rows(); ++i)
        if (share[static_cast<std::size_t>(i)] > 0)
            field.row(i) = sum.row(i) * (share[static_cast<std::size_t>(i)] / 3);
}

// S from the gradient of the vertex normals over each triangle: n(x) is linear there, S = grad n in
// the plane of the triangle, made symmetric; area-weighted means go to the vertices.
void find_bending(ScanSurface& scan, double smoothing_mm) {
    using Packed = Eigen::Matrix<float, Eigen::Dynamic, 6, Eigen::RowMajor>;
    const Index n = scan.vertices.rows(), count = scan.triangles.rows();
    Packed field = Packed::Zero(n, 6);
    std::vector<float> area(static_cast<std::size_t>(n), 0.0f),
        uses(static_cast<std::size_t>(n), 0.0f);
    for (Index t = 0; t < count; ++t) {
        Vector3 x[3], m[3];
        for (int k = 0; k < 3; ++k) {
            x[k] = scan.vertices.row(scan.triangles(t, k)).transpose();
            m[k] = scan.normals.row(scan.triangles(t, k)).transpose();
            uses[scan.triangles(t, k)] += 1;
        }
        const Vector3 cross = (x[1] - x[0]).cross(x[2] - x[0]);
        const double twice = cross.norm();
        if (!(twice > 1e-9)) continue;
        const Vector3 normal = cross / twice;
        Matrix3 gradient = Matrix3::Zero();  // sum of n_k (grad of the hat function k)'
        for (int k = 0; k < 3; ++k)
            gradient += m[k] * normal.cross(x[(k + 2) % 3] - x[(k + 1) % 3]).transpose();
        gradient /= twice;
        const Matrix3 flat = Matrix3::Identity() - normal * normal.transpose();
        gradient = flat * gradient;
        const Matrix3 s = 0.5 * (gradient + gradient.transpose());
        const Eigen::Matrix<float, 1, 6> packed =
            (Eigen::Matrix<double, 1, 6>() << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2))
                .finished()
                .cast<float>();
        for (int k = 0; k < 3; ++k) {
            field.row(scan.triangles(t, k)) += static_cast<float>(twice) * packed;
            area[scan.triangles(t, k)] += static_cast<float>(twice);
        }
    }
    for (Index i = 0; i < n; ++i) {
        if (area[static_cast<std::size_t>(i)] > 0)
            field.row(i) /= area[static_cast<std::size_t>(i)];
        uses[static_cast<std::size_t>(i)] =
            uses[static_cast<std::size_t>(i)] > 0 ? 1 / uses[static_cast<std::size_t>(i)] : 0;
    }
    const double ratio = smoothing_mm / std::max(1e-9, scan.spacing_mm);
    const int rounds = static_cast<int>(std::min(24.0, std::ceil(ratio * ratio)));
    for (int round = 0; round < rounds; ++round)
        average_over_triangles(scan.triangles, uses, field);
    scan.bending = std::move(field);
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

void ScanSurface::turn_over() {
    normals = -normals;
    bending = -bending;
}

Vector3 ScanSurface::normal_at(const SurfaceHit& hit) const {
    if (tree.is_point_cloud()) return normals.row(static_cast<Index>(hit.triangle)).transpose();
    Vector3 normal = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
        normal += hit.barycentric[k] *
                  normals.row(static_cast<Index>(triangles(static_cast<Index>(hit.triangle), k)))
                      .transpose();
    const double length = normal.norm();
    return length > 1e-12 ? Vector3(normal / length) : Vector3(Vector3::Zero());
}

bool ScanSurface::at_border(const SurfaceHit& hit) const {
    if (tree.is_point_cloud()) return false;
    // A place strictly inside a triangle is off the border, even when two of its corners are on it.
    bool inside = true, all_border = true;
    for (int k = 0; k < 3; ++k) {
        if (hit.barycentric[k] > 1e-9)
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

ScanSurface prepare_scan(const TriMesh& mesh, double smoothing_mm, const Context& context) {
    ScanSurface scan;
    scan.vertices = mesh.vertices;
    scan.triangles = mesh.triangles;
    scan.tree = TriangleTree(scan.vertices, scan.triangles, context);
    if (scan.tree.is_point_cloud()) {
        scan.on_border.assign(static_cast<std::size_t>(scan.vertices.rows()), 0);
        scan.spacing_mm = scan.vertices.rows() > 1 ? cloud_spacing(scan.vertices) : 1;
        scan.normals =
            cloud_normals(scan.vertices, std::max(2 * scan.spacing_mm, smoothing_mm), context);
        return scan;
    }
    scan.on_border = find_border(scan.vertices.rows(), scan.triangles);
    scan.normals = vertex_normals(scan.vertices, scan.triangles);

    const Index num_triangles = scan.triangles.rows();
    double total = 0;
    for (Index t = 0; t < num_triangles; ++t)
        for (int k = 0; k < 3; ++k)
            total += (scan.vertices.row(scan.triangles(t, k)) -
                      scan.vertices.row(scan.triangles(t, (k + 1) % 3)))
                         .norm();
    scan.spacing_mm = num_triangles > 0 ? total / static_cast<double>(3 * num_triangles) : 0;

    // k rounds of averaging over the triangles spread a normal over about sqrt(k) edge lengths.
    if (scan.spacing_mm > 0 && smoothing_mm > 0) {
        const double ratio = smoothing_mm / scan.spacing_mm;
        const int rounds = static_cast<int>(std::min(16.0, std::ceil(ratio * ratio)));
        Points sum(scan.normals.rows(), 3);
        for (int round = 0; round < rounds; ++round) {
            context.check_cancelled();
            sum.setZero();
            for (Index t = 0; t < num_triangles; ++t) {
                const Eigen::RowVector3d mean = scan.normals.row(scan.triangles(t, 0)) +
                                                scan.normals.row(scan.triangles(t, 1)) +
                                                scan.normals.row(scan.triangles(t, 2));
                for (int k = 0; k < 3; ++k) sum.row(scan.triangles(t, k)) += mean;
            }
            for (Index i = 0; i < sum.rows(); ++i) {
                const double length = sum.row(i).norm();
                if (length > 1e-12) scan.normals.row(i) = sum.row(i) / length;
            }
        }
    }
    find_bending(scan, smoothing_mm);
    return scan;
}

}  // namespace mien
