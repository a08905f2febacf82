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
// means nothing, have no roughness but keep their area; vertices that carry no shape (centroids of
// split triangles, middles of split sides) are taken out first (flat_vertices.hpp). Their defect is
// zero by construction, so they halve or more their neighbours' mean, and the power of 0.15 makes
// much of it: the same surface, split at the centroids, was as far as one with 0.11 mm of noise.
#include "spectral/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/scalar_math.hpp"
#include "geometry/laplacian.hpp"
#include "geometry/normals.hpp"
#include "mesh/topology.hpp"
#include "spatial/triangle_tree.hpp"
#include "spectral/flat_vertices.hpp"

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

/// Local roughness r_i of a surface whose vertices all carry shape.
Vector roughness_of_reduced(const TriMesh& mesh, const Context& context) {
    const Index n = mesh.vertices.rows();
    const EdgeTable table = build_edge_table(mesh.triangles, n, context);
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

struct Roughness {
    Vector local, area;               ///< of the kept vertices; areas sum to 1
    std::vector<std::uint32_t> into;  ///< #V: the kept vertex that stands for each
    double mean = 0;
};

Roughness roughness_of(const TriMesh& mesh, const Context& context) {
    check_surface(mesh, "the mesh");
    ReducedSurface reduced = without_flat_vertices(mesh, context);
    Roughness result;
    result.into = std::move(reduced.into);
    result.local = roughness_of_reduced(reduced.mesh, context);
    result.area = Vector::Zero(reduced.mesh.vertices.rows());
    const Triangles& triangles = reduced.mesh.triangles;
    const Points normals = triangle_normals(reduced.mesh.vertices, triangles);
    for (Index f = 0; f < triangles.rows(); ++f)
        for (int c = 0; c < 3; ++c) result.area[triangles(f, c)] += normals.row(f).norm() / 6;
    const double total = result.area.sum();
    if (!(total > 0)) fail(Status::invalid_mesh, "a surface without area has no roughness");
    result.area /= total;
    result.mean = result.local.dot(result.area);
    return result;
}

/// What an eye makes of a local roughness, beside a mesh of mean roughness `smaller`.
class Perception {
  public:
    explicit Perception(double smaller)
        : highest_(std::max(0.20, 5.0 * smaller)),
          offset_(std::pow(kLowest, kPower)),
          turn_(std::pow(std::max(smaller, kLowest), kPower) - offset_) {}
    double of(double local) const {
        const double value =
            std::pow(std::min(highest_, std::max(kLowest, local)), kPower) - offset_;
        return value > turn_ ? turn_ + kMasked * (value - turn_) : value;
    }
    double global(const Roughness& r) const {
        double sum = 0;
        for (Index v = 0; v < r.local.size(); ++v) sum += of(r.local[v]) * r.area[v];
        return sum;
    }

  private:
    static constexpr double kLowest = 5e-4, kPower = 0.15, kMasked = 0.5;
    double highest_, offset_, turn_;
};

/// What one inner edge adds to DAME: the masked change of its angle, and its weight.
struct EdgeChange {
    Index ends[2];
    double change = 0, area = 0;
};

/// Compares the dihedral angles of two meshes of the same triangles.
class AngleChanges {
  public:
    AngleChanges(const TriMesh& reference, const TriMesh& other, const Context& context)
        : reference_(reference), other_(other) {
        check_surface(reference, "the reference mesh");
        check_surface(other, "the other mesh");
        check_pair(reference.vertices, other.vertices);
        if (reference.triangles.rows() != other.triangles.rows() ||
            !(reference.triangles.array() == other.triangles.array()).all())
            fail(Status::mismatch, "DAME needs two meshes of the same triangles");
        table_ = build_edge_table(reference.triangles, reference.vertices.rows(), context);
        before_ = triangle_normals(reference.vertices, reference.triangles);
        after_ = triangle_normals(other.vertices, reference.triangles);
    }
    std::size_t num_edges() const { return table_.num_edges(); }
    /// False for edges at borders, non-manifold ones and between opposite orientations.
    bool at(std::size_t e, EdgeChange& out) const {
        if (table_.num_sides(e) != 2) return false;
        const std::uint32_t s = table_.sides[table_.first_side[e]];
        const std::uint32_t t = table_.sides[table_.first_side[e] + 1];
        const auto ends = side_ends(reference_.triangles, s);
        if (side_ends(reference_.triangles, t) == ends) return false;
        const Index i = ends[0], j = ends[1], first = s / 3, second = t / 3;
        const double d = dihedral(reference_.vertices.row(i), reference_.vertices.row(j),
                                  before_.row(first), before_.row(second));
        const double d_other = dihedral(other_.vertices.row(i), other_.vertices.row(j),
                                        after_.row(first), after_.row(second));
        out.ends[0] = i;
        out.ends[1] = j;
        out.change = std::abs(d - d_other) * std::exp(-d * d);
        out.area = (before_.row(first).norm() + before_.row(second).norm()) / 2;
        return true;
    }

  private:
    const TriMesh &reference_, &other_;
    EdgeTable table_;
    Points before_, after_;
};

}  // namespace

double l1_distance(const PointsRef& a, const PointsRef& b) {
    check_pair(a, b);
    return (a - b).cwiseAbs().sum() / static_cast<double>(a.rows());
}

double l2_distance(const PointsRef& a, const PointsRef& b) {
    check_pair(a, b);
    return (a - b).rowwise().norm().sum() / static_cast<double>(a.rows());
}

Vector vertex_distances(const PointsRef& a, const PointsRef& b, bool sum_of_axes) {
    check_pair(a, b);
    const Points away = a - b;
    if (sum_of_axes) return away.cwiseAbs().rowwise().sum();
    return away.rowwise().norm();
}

Vector surface_distances(const TriMesh& from, const TriMesh& to, const Context& context) {
    check_mesh(from, "the first mesh");
    check_mesh(to, "the second mesh");
    const TriangleTree tree(to.vertices, to.triangles, context);
    std::vector<SurfaceHit> hits;
    tree.closest(from.vertices, std::numeric_limits<double>::infinity(), hits, context);
    Vector distances(from.vertices.rows());
    for (Index v = 0; v < distances.size(); ++v)
        distances[v] = hits[static_cast<std::size_t>(v)].distance();
    return distances;
}

double hausdorff_distance(const TriMesh& a, const TriMesh& b, const Context& context) {
    const auto one_way = [&](const TriMesh& from, const TriMesh& to) {
        const Vector distances = surface_distances(from, to, context);
        return distances.size() == 0 ? 0.0 : distances.maxCoeff();
    };
    return std::max(one_way(a, b), one_way(b, a));
}

double dame(const TriMesh& reference, const TriMesh& other, const Context& context) {
    const AngleChanges changes(reference, other, context);
    using Sums = Eigen::Vector2d;
    const Sums sums = parallel_sum(context, changes.num_edges(), kEdgeChunk, Sums(Sums::Zero()),
                                   [&](std::size_t begin, std::size_t end) {
                                       Sums part = Sums::Zero();
                                       EdgeChange edge;
                                       for (std::size_t e = begin; e < end; ++e)
                                           if (changes.at(e, edge))
                                               part += Sums(edge.change * edge.area, edge.area);
                                       return part;
                                   });
    return sums[1] > 0 ? sums[0] / sums[1] : 0.0;
}

Vector dame_field(const TriMesh& reference, const TriMesh& other, const Context& context) {
    const AngleChanges changes(reference, other, context);
    Vector sum = Vector::Zero(reference.vertices.rows()), area = sum;
    EdgeChange edge;
    for (std::size_t e = 0; e < changes.num_edges(); ++e) {
        if (!changes.at(e, edge)) continue;
        for (const Index v : edge.ends) {
            sum[v] += edge.change * edge.area;
            area[v] += edge.area;
        }
    }
    for (Index v = 0; v < sum.size(); ++v) sum[v] = area[v] > 0 ? sum[v] / area[v] : 0.0;
    return sum;
}

Vector local_roughness(const TriMesh& mesh, const Context& context) {
    const Roughness roughness = roughness_of(mesh, context);
    Vector field(mesh.vertices.rows());
    for (Index v = 0; v < field.size(); ++v)
        field[v] = roughness.local[roughness.into[static_cast<std::size_t>(v)]];
    return field;
}

double fmpd(const TriMesh& a, const TriMesh& b, const Context& context) {
    context.check_cancelled();
    constexpr double kToUnit = 8.0;
    const Roughness first = roughness_of(a, context), second = roughness_of(b, context);
    const Perception eye(std::min(first.mean, second.mean));
    return std::min(1.0, kToUnit * std::abs(eye.global(first) - eye.global(second)));
}

Vector fmpd_field(const TriMesh& reference, const TriMesh& other, const Context& context) {
    check_surface(reference, "the reference mesh");
    check_surface(other, "the other mesh");
    check_pair(reference.vertices, other.vertices);
    const Roughness first = roughness_of(reference, context), second = roughness_of(other, context);
    const Perception eye(std::min(first.mean, second.mean));
    Vector field(reference.vertices.rows());
    for (Index v = 0; v < field.size(); ++v) {
        const auto at = static_cast<std::size_t>(v);
        field[v] = eye.of(second.local[second.into[at]]) - eye.of(first.local[first.into[at]]);
    }
    return field;
}

}  // namespace mien
