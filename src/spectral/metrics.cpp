// DAME = sum_e |D_e - D'_e| m_e (A_s + A_t) / sum_e (A_s + A_t) over inner edges e between
// triangles s, t; D is the angle between the normals, positive where the surface is convex; A are
// the reference's areas, which replace the camera-dependent visibility as the thesis says. The
// masking m_e = exp(-D_e^2) weakens changes at edges that were sharp before; its constant (1 per
// rad^2) is ours. Edges at borders and non-manifold edges are ignored.
//
// FMPD: G_i = |2 pi - sum of angles|, r_i = |G_i - weighted mean of the neighbours' G| with
// cotangent weights, clamped to [5e-4, max(0.2, 5 mean)] and compressed to r^0.15 - (5e-4)^0.15;
// what exceeds the average roughness counts half; the result is 8 |difference of the area means|.
// Departures: cotangents are clamped at zero so that the mean is one; border vertices, whose defect
// means nothing, have no roughness but keep their area.
#include "spectral/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/laplacian.hpp"
#include "geometry/normals.hpp"
#include "mesh/topology.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr std::size_t kEdgeChunk = 4096;

void check_pair(const PointsRef& a, const PointsRef& b) {
    if (a.rows() != b.rows())
        fail(Status::mismatch, "faces with %lld and %lld vertices have no vertex-wise distance",
             static_cast<long long>(a.rows()), static_cast<long long>(b.rows()));
    if (a.rows() == 0) fail(Status::invalid_mesh, "a face without vertices");
    if (!a.allFinite() || !b.allFinite())
        fail(Status::invalid_mesh, "a face with a vertex that is not finite");
}

void check_surface(const TriMesh& mesh, const char* what) {
    check_mesh(mesh, what);
    if (mesh.triangles.rows() == 0) fail(Status::invalid_mesh, "%s has no triangles", what);
}

/// Oriented angle between the normals over the side from `from` to `to` of the first triangle.
double dihedral(const Vector3& from, const Vector3& to, const Vector3& first,
                const Vector3& second) {
    const double scale = first.norm() * second.norm();
    if (!(scale > 0)) return 0;
    const Vector3 axis = (to - from).normalized();
    // atan2 is exact for small angles, where acos of the cosine loses half of the digits.
    return std::atan2(axis.dot(first.cross(second)) / scale, first.dot(second) / scale);
}

/// Angle at p between q and r; 0 for degenerate corners.
double corner_angle(const Vector3& p, const Vector3& q, const Vector3& r) {
    const Vector3 u = q - p, v = r - p;
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

struct Roughness {
    Vector local, area;
    double mean = 0;
};

Roughness roughness_of(const TriMesh& mesh) {
    Roughness result;
    result.local = local_roughness(mesh);
    result.area = Vector::Zero(mesh.vertices.rows());
    const Points normals = triangle_normals(mesh.vertices, mesh.triangles);
    for (Index f = 0; f < mesh.triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c) result.area[mesh.triangles(f, c)] += normals.row(f).norm() / 6;
    const double total = result.area.sum();
    if (!(total > 0)) fail(Status::invalid_mesh, "a surface without area has no roughness");
    result.area /= total;
    result.mean = result.local.dot(result.area);
    return result;
}

}  // namespace

double l1_distance(const PointsRef& a, const PointsRef& b) {
    check_pair(a, b);
    return (a - b).cwiseAbs().sum() / static_cast<double>(a.rows());
}

double l2_distance(const PointsRef& a, const PointsRef& b) {
    check_pair(a, b);
    return (a - b).rowwise().norm().sum() / static_cast<double>(a.rows());
}

double hausdorff_distance(const TriMesh& a, const TriMesh& b, const Context& context) {
    check_mesh(a, "the first mesh");
    check_mesh(b, "the second mesh");
    const auto one_way = [&](const TriMesh& from, const TriMesh& to) {
        const TriangleTree tree(to.vertices, to.triangles, context);
        std::vector<SurfaceHit> hits;
        tree.closest(from.vertices, std::numeric_limits<double>::infinity(), hits, context);
        double farthest = 0;
        for (const SurfaceHit& hit : hits) farthest = std::max(farthest, hit.distance());
        return farthest;
    };
    return std::max(one_way(a, b), one_way(b, a));
}

double dame(const TriMesh& reference, const TriMesh& other, const Context& context) {
    check_surface(reference, "the reference mesh");
    check_surface(other, "the other mesh");
    check_pair(reference.vertices, other.vertices);
    if (reference.triangles.rows() != other.triangles.rows() ||
        !(reference.triangles.array() == other.triangles.array()).all())
        fail(Status::mismatch, "DAME needs two meshes of the same triangles");
    const Triangles& triangles = reference.triangles;
    const EdgeTable table = build_edge_table(triangles, reference.vertices.rows(), context);
    const Points before = triangle_normals(reference.vertices, triangles);
    const Points after = triangle_normals(other.vertices, triangles);

    using Sums = Eigen::Vector2d;
    const Sums sums = parallel_sum(
        context, table.num_edges(), kEdgeChunk, Sums(Sums::Zero()),
        [&](std::size_t begin, std::size_t end) {
            Sums part = Sums::Zero();
            for (std::size_t e = begin; e < end; ++e) {
                if (table.num_sides(e) != 2) continue;
                const std::uint32_t s = table.sides[table.first_side[e]];
                const std::uint32_t t = table.sides[table.first_side[e] + 1];
                const auto ends = side_ends(triangles, s);
                if (side_ends(triangles, t) == ends) continue;  // opposite orientations
                const Index i = ends[0], j = ends[1], first = s / 3, second = t / 3;
                const double d = dihedral(reference.vertices.row(i), reference.vertices.row(j),
                                          before.row(first), before.row(second));
                const double d_other = dihedral(other.vertices.row(i), other.vertices.row(j),
                                                after.row(first), after.row(second));
                const double area = (before.row(first).norm() + before.row(second).norm()) / 2;
                part += Sums(std::abs(d - d_other) * std::exp(-d * d) * area, area);
            }
            return part;
        });
    return sums[1] > 0 ? sums[0] / sums[1] : 0.0;
}

Vector local_roughness(const TriMesh& mesh) {
    check_surface(mesh, "the mesh");
    const Index n = mesh.vertices.rows();
    const EdgeTable table = build_edge_table(mesh.triangles, n, Context());
    const std::vector<std::uint8_t> border = border_vertices(table, n);
    Vector defect = Vector::Zero(n);
    for (Index f = 0; f < mesh.triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c)
            defect[mesh.triangles(f, c)] +=
                corner_angle(mesh.vertices.row(mesh.triangles(f, c)),
                             mesh.vertices.row(mesh.triangles(f, (c + 1) % 3)),
                             mesh.vertices.row(mesh.triangles(f, (c + 2) % 3)));
    for (Index v = 0; v < n; ++v)
        defect[v] = border[static_cast<std::size_t>(v)] || defect[v] == 0
                        ? 0.0
                        : std::abs(2 * kPi - defect[v]);
    LaplacianOptions options;
    options.negative = NegativeCotangents::clamp;
    const SparseMatrix stiffness =
        build_laplacian(mesh.vertices, mesh.triangles, options).stiffness;
    Vector roughness = Vector::Zero(n);
    for (Index v = 0; v < n; ++v) {
        if (border[static_cast<std::size_t>(v)]) continue;
        double sum = 0, diagonal = 0;
        for (SparseMatrix::InnerIterator it(stiffness, v); it; ++it) {
            if (it.row() == v)
                diagonal = it.value();
            else if (!border[static_cast<std::size_t>(it.row())])
                sum += it.value() * (defect[it.row()] - defect[v]);  // weights are negative here
        }
        if (diagonal > 0) roughness[v] = std::abs(sum) / diagonal;
    }
    return roughness;
}

double fmpd(const TriMesh& a, const TriMesh& b, const Context& context) {
    context.check_cancelled();
    const Roughness first = roughness_of(a), second = roughness_of(b);
    constexpr double kLowest = 5e-4, kPower = 0.15, kMasked = 0.5, kToUnit = 8.0;
    const double smaller = std::min(first.mean, second.mean);
    const double highest = std::max(0.20, 5.0 * smaller);
    const double offset = std::pow(kLowest, kPower);
    const double turn = std::pow(std::max(smaller, kLowest), kPower) - offset;
    const auto global = [&](const Roughness& r) {
        double sum = 0;
        for (Index v = 0; v < r.local.size(); ++v) {
            double value =
                std::pow(std::min(highest, std::max(kLowest, r.local[v])), kPower) - offset;
            if (value > turn) value = turn + kMasked * (value - turn);
            sum += value * r.area[v];
        }
        return sum;
    };
    return std::min(1.0, kToUnit * std::abs(global(first) - global(second)));
}

}  // namespace mien
