#include "geometry/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/normals.hpp"
#include "mesh/adjacency.hpp"

namespace mien {
namespace {

constexpr std::size_t kEnough = 12;  // 10 coefficients and some to spare
constexpr std::size_t kMost = 200;   // dense scans: the nearest rings suffice

// Vertices reached over edges without leaving the ball; the ball grows while there are too few.
class Gatherer {
  public:
    Gatherer(const PointsRef& vertices, const VertexRings& rings)
        : vertices_(vertices), rings_(rings), seen_(static_cast<std::size_t>(vertices.rows()), 0) {}

    const std::vector<std::uint32_t>& gather(std::uint32_t centre, double radius) {
        for (int attempt = 0; attempt < 6; ++attempt, radius *= 1.5) {
            radius_ = radius;
            collect(centre, radius);
            if (found_.size() >= kEnough) break;
        }
        return found_;
    }
    double radius() const { return radius_; }

  private:
    void collect(std::uint32_t centre, double radius) {
        found_.clear();
        ++stamp_;
        seen_[centre] = stamp_;
        found_.push_back(centre);
        for (std::size_t next = 0; next < found_.size() && found_.size() < kMost; ++next)
            for (const std::uint32_t v : rings_.of(found_[next])) {
                if (seen_[v] == stamp_) continue;
                seen_[v] = stamp_;
                if ((vertices_.row(v) - vertices_.row(centre)).squaredNorm() <= radius * radius)
                    found_.push_back(v);
            }
    }

    const PointsRef& vertices_;
    const VertexRings& rings_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> found_;
    double radius_ = 0.0;
};

struct Frame {
    Vector3 x, y, z;
};

Frame frame_of(const Vector3& normal) {
    Frame frame;
    frame.z = normal;
    // Any fixed rule will do; the smallest component keeps it well away from the normal.
    Index smallest;
    normal.cwiseAbs().minCoeff(&smallest);
    frame.x = normal.cross(Vector3::Unit(smallest)).normalized();
    frame.y = frame.z.cross(frame.x);
    return frame;
}

struct Local {
    double maximal = 0, minimal = 0;
    Vector3 direction = Vector3::Zero(), normal = Vector3::Zero();
};

Local fit_vertex(const PointsRef& vertices, const std::vector<std::uint32_t>& near,
                 const Vector3& normal, double radius, bool robust) {
    Local result;
    result.normal = normal;
    const Index n = static_cast<Index>(near.size());
    const Index terms = n >= static_cast<Index>(kEnough) ? 10 : 6;
    if (n < 7 || !(normal.squaredNorm() > 0)) return result;
    const Frame frame = frame_of(normal);
    const Vector3 origin = vertices.row(near.front());
    Matrix design(n, terms);
    Vector height(n), weight(n);
    for (Index i = 0; i < n; ++i) {
        const Vector3 d = Vector3(vertices.row(near[static_cast<std::size_t>(i)])) - origin;
        const double u = d.dot(frame.x) / radius, v = d.dot(frame.y) / radius;
        height[i] = d.dot(frame.z) / radius;
        weight[i] = std::exp(-2.0 * d.squaredNorm() / (radius * radius));
        design.row(i).head<6>() << 1, u, v, 0.5 * u * u, u * v, 0.5 * v * v;
        if (terms == 10) design.row(i).tail<4>() << u * u * u, u * u * v, u * v * v, v * v * v;
    }
    Vector fitted;
    const Vector spatial = weight;
    for (int pass = 0; pass < (robust ? 3 : 1); ++pass) {
        if (pass > 0) {
            Vector residual = (height - design * fitted).cwiseAbs();
            std::vector<double> sorted(residual.data(), residual.data() + n);
            std::nth_element(sorted.begin(), sorted.begin() + n / 2, sorted.end());
            const double scale = 4.685 * 1.4826 * sorted[static_cast<std::size_t>(n / 2)];
            if (!(scale > 1e-12)) break;
            for (Index i = 0; i < n; ++i) {
                const double r = residual[i] / scale;
                weight[i] = r < 1 ? spatial[i] * (1 - r * r) * (1 - r * r) : 0.0;
            }
        }
        Matrix normal_matrix = design.transpose() * weight.asDiagonal() * design;
        // A trace of ridge: a fan that lies on one line still has an answer.
        normal_matrix.diagonal().array() +=
            1e-9 * normal_matrix.trace() / static_cast<double>(terms);
        const Eigen::LDLT<Matrix> solver(normal_matrix);
        if (solver.info() != Eigen::Success) return result;
        fitted = solver.solve(design.transpose() * (weight.asDiagonal() * height));
        if (!fitted.allFinite()) return result;
    }
    const double p = fitted[1], q = fitted[2];
    const double a = fitted[3] / radius, b = fitted[4] / radius, c = fitted[5] / radius;
    // Graph of h over the tangent plane: first form (1 + p^2, pq, 1 + q^2), second (a, b, c) / s.
    const double s = std::sqrt(1 + p * p + q * q);
    // second t = curvature first t, by the Cholesky factor (l, m; 0, n) of the first form: an
    // ordinary eigenproblem of L^-1 second L^-T. Bulging outwards is positive.
    const double l = std::sqrt(1 + p * p), per_l = 1 / l, m = p * q / l;
    const double per_n = 1 / std::sqrt(1 + q * q - m * m);
    const double uu = a * (-1.0 / s) * per_l, uv = b * (-1.0 / s) * per_l;
    const double vu = (b * (-1.0 / s) - uu * m) * per_n, vv = (c * (-1.0 / s) - uv * m) * per_n;
    Eigen::Matrix2d form;
    form << uu * per_l, 0, vu * per_l, (vv - vu * per_l * m) * per_n;  // the lower half is read
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(form);
    if (solver.info() != Eigen::Success) return result;
    result.minimal = solver.eigenvalues()[0];
    result.maximal = solver.eigenvalues()[1];
    Eigen::Vector2d t = solver.eigenvectors().col(1);
    t[1] *= per_n;
    t[0] = (t[0] - m * t[1]) * per_l;
    const Vector3 tangent_u = frame.x + p * frame.z, tangent_v = frame.y + q * frame.z;
    Vector3 direction = (t[0] * tangent_u + t[1] * tangent_v).normalized();
    Index largest;
    direction.cwiseAbs().maxCoeff(&largest);
    if (direction[largest] < 0) direction = -direction;
    result.direction = direction;
    result.normal = (frame.z - p * frame.x - q * frame.y) / s;
    return result;
}

}  // namespace

CurvatureField estimate_curvature(const PointsRef& vertices, const TrianglesRef& triangles,
                                  const CurvatureOptions& options, const Context& context,
                                  const std::function<void(double)>& progress) {
    if (!(options.radius_mm > 0) || !std::isfinite(options.radius_mm))
        fail(Status::invalid_argument, "a curvature radius of %g mm; give a positive one",
             options.radius_mm);
    const Index num_vertices = vertices.rows();
    const VertexRings rings = build_rings(num_vertices, triangles);
    const Points start_normals = vertex_normals(vertices, triangles);
    CurvatureField field;
    field.maximal = field.minimal = Vector::Zero(num_vertices);
    field.direction = field.normals = Points::Zero(num_vertices, 3);
    // A part at a time, so that the host sees progress.
    constexpr std::size_t kPart = 16384, kChunk = 2048, kCancelEvery = 128;
    const auto all = static_cast<std::size_t>(num_vertices);
    for (std::size_t first = 0; first < all; first += kPart) {
        if (progress) progress(static_cast<double>(first) / static_cast<double>(all));
        parallel_for(context, std::min(kPart, all - first), kChunk,
                     [&](std::size_t begin, std::size_t end) {
                         Gatherer gatherer(vertices, rings);
                         for (std::size_t i = first + begin; i < first + end; ++i) {
                             if (i % kCancelEvery == 0) context.check_cancelled();
                             const Index v = static_cast<Index>(i);
                             const auto& near =
                                 gatherer.gather(static_cast<std::uint32_t>(i), options.radius_mm);
                             const Local local = fit_vertex(vertices, near, start_normals.row(v),
                                                            gatherer.radius(), options.robust);
                             field.maximal[v] = local.maximal;
                             field.minimal[v] = local.minimal;
                             field.direction.row(v) = local.direction;
                             field.normals.row(v) = local.normal;
                         }
                     });
    }
    if (progress) progress(1);
    field.mean = 0.5 * (field.maximal + field.minimal);
    field.gaussian = field.maximal.cwiseProduct(field.minimal);
    return field;
}

}  // namespace mien
