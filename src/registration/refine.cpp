#include "registration/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/parallel.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// out = field - mean of the neighbours.
void umbrella(const VertexRings& rings, const Vector& field, Vector& out) {
    const Index n = field.size();
    out.resize(n);
    for (Index i = 0; i < n; ++i) {
        const std::uint32_t begin = rings.begin[static_cast<std::size_t>(i)];
        const std::uint32_t end = rings.begin[static_cast<std::size_t>(i) + 1];
        double sum = 0;
        for (std::uint32_t k = begin; k < end; ++k) sum += field[rings.neighbours[k]];
        out[i] = end > begin ? field[i] - sum / (end - begin) : 0;
    }
}

// out = L' field for the same L.
void umbrella_transposed(const VertexRings& rings, const Vector& field, Vector& out) {
    const Index n = field.size();
    out = field;
    for (Index i = 0; i < n; ++i) {
        const std::uint32_t begin = rings.begin[static_cast<std::size_t>(i)];
        const std::uint32_t end = rings.begin[static_cast<std::size_t>(i) + 1];
        if (end == begin) out[i] = 0;
        for (std::uint32_t k = begin; k < end; ++k)
            out[rings.neighbours[k]] -= field[i] / (end - begin);
    }
}

}  // namespace

Vector close_gap(const ScanSurface& scan, const Vector& scan_weight, const Triangles& triangles,
                 const VertexRings& rings, const Vector& trust, const CorrespondenceOptions& match,
                 const GapOptions& options, Points& places, const Context& context) {
    const Index n = places.rows();
    CorrespondenceOptions filter = match;
    filter.robust_scale_mm = options.robust_scale_mm;
    filter.max_distance_mm = 4 * options.robust_scale_mm;
    Correspondences found;
    Vector weight(n), gap(n);
    for (int round = 0; round < options.rounds; ++round) {
        context.progress(Stage::refining, static_cast<double>(round) / options.rounds);
        const Points normals = vertex_normals(places, triangles);
        find_correspondences(scan, places, normals, scan_weight, filter, found, context);
        for (Index i = 0; i < n; ++i) {
            weight[i] = found.weight[i] * trust[i];
            // The gap to the plane through the hit, seen along the template's normal.
            const Vector3 to_hit = found.hits[static_cast<std::size_t>(i)].valid()
                                       ? Vector3(found.hits[static_cast<std::size_t>(i)].point -
                                                 places.row(i).transpose())
                                       : Vector3(Vector3::Zero());
            gap[i] = to_hit.dot(normals.row(i).transpose());
        }
        // Conjugate gradients on (W + alpha L'L + epsilon) delta = W gap; well conditioned, tens of
        // steps.
        Vector delta = Vector::Zero(n), residual = weight.cwiseProduct(gap), direction = residual,
               image, scratch;
        double rr = residual.squaredNorm();
        const double limit = 1e-8 * std::max(rr, 1e-30);
        for (int k = 0; k < 80 && rr > limit; ++k) {
            umbrella(rings, direction, scratch);
            umbrella_transposed(rings, scratch, image);
            image = options.smoothness * image + weight.cwiseProduct(direction) + 0.02 * direction;
            const double step = rr / direction.dot(image);
            delta += step * direction;
            residual -= step * image;
            const double next = residual.squaredNorm();
            direction = residual + (next / rr) * direction;
            rr = next;
        }
        for (Index i = 0; i < n; ++i)
            places.row(i) +=
                std::clamp(delta[i], -options.max_step_mm, options.max_step_mm) * normals.row(i);
    }
    context.progress(Stage::refining, 1);
    return weight;
}

Index undo_turns(const Points& before, const Triangles& triangles, const VertexRings& rings,
                 Points& places) {
    constexpr double kLimit = 0.5, kFade = 0.1;  // cosines
    const Points normals_before = triangle_normals(before, triangles);
    Index undone = 0;
    for (int round = 0; round < 6; ++round) {
        const Points normals = triangle_normals(places, triangles);
        Vector back = Vector::Zero(places.rows());
        Index turned = 0;
        for (Index t = 0; t < triangles.rows(); ++t) {
            const double scale = normals.row(t).norm() * normals_before.row(t).norm();
            const double excess =
                kLimit + kFade -
                (scale > 0 ? normals.row(t).dot(normals_before.row(t)) / scale : 1);
            if (!(excess > 0)) continue;
            turned += excess >= kFade;
            const double share = fade(excess / (2 * kFade));
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t v = triangles(t, k);
                back[v] = std::max(back[v], share);
                if (round == 0) continue;
                for (std::uint32_t j = rings.begin[v]; j < rings.begin[v + 1]; ++j)
                    back[rings.neighbours[j]] = std::max(back[rings.neighbours[j]], share);
            }
        }
        undone += turned;
        if (back.maxCoeff() == 0) break;
        for (Index v = 0; v < places.rows(); ++v)
            if (back[v] > 0) places.row(v) += back[v] * (before.row(v) - places.row(v));
    }
    return undone;
}

namespace {

// The vertices within `reach` rings of a triangle's corners.
void gather(const VertexRings& rings, const std::array<std::uint32_t, 3>& corners, int reach,
            std::vector<std::uint32_t>& around) {
    around.assign(corners.begin(), corners.end());
    std::size_t begin = 0;
    for (int ring = 0; ring < reach; ++ring) {
        const std::size_t end = around.size();
        for (std::size_t k = begin; k < end; ++k)
            for (std::uint32_t j = rings.begin[around[k]]; j < rings.begin[around[k] + 1]; ++j)
                if (std::find(around.begin(), around.end(), rings.neighbours[j]) == around.end())
                    around.push_back(rings.neighbours[j]);
        begin = end;
    }
}

// The rotation that brings rest places nearest to places, of the given vertices.
Matrix3 local_rotation(const PointsRef& rest, const PointsRef& places,
                       const std::vector<std::uint32_t>& vertices) {
    Eigen::RowVector3d from = Eigen::RowVector3d::Zero(), to = Eigen::RowVector3d::Zero();
    for (const std::uint32_t v : vertices) from += rest.row(v), to += places.row(v);
    from /= static_cast<double>(vertices.size());
    to /= static_cast<double>(vertices.size());
    Matrix3 covariance = Matrix3::Zero();
    for (const std::uint32_t v : vertices)
        covariance += (places.row(v) - to).transpose() * (rest.row(v) - from);
    const Eigen::JacobiSVD<Matrix3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
    return u * svd.matrixV().transpose();
}

}  // namespace

std::vector<TurnedTriangle> find_turned(const PointsRef& rest, const Triangles& triangles,
                                        const VertexRings& rings, const PointsRef& places,
                                        double max_turn_rad) {
    constexpr int kReach = 3;
    const Points now = triangle_normals(places, triangles),
                 before = triangle_normals(rest, triangles);
    const double least = std::cos(max_turn_rad);
    std::vector<TurnedTriangle> turned;
    std::vector<std::uint32_t> around;
    for (Index t = 0; t < triangles.rows(); ++t) {
        if (!(before.row(t).norm() > 0))
            continue;  // the template's own needle has no side to lie on
        const double scale = now.row(t).norm() * before.row(t).norm();
        // Most triangles are plainly right; the neighbourhood's own turn is asked for the others
        // only.
        if (now.row(t).dot(before.row(t)) > std::max(least, 0.64) * scale) continue;
        gather(rings, {triangles(t, 0), triangles(t, 1), triangles(t, 2)}, kReach, around);
        const Matrix3 rotation = local_rotation(rest, places, around);
        if (now.row(t).dot((rotation * before.row(t).transpose()).transpose()) <= least * scale)
            turned.push_back({static_cast<std::uint32_t>(t), rotation});
    }
    return turned;
}

Index straighten_turned(const PointsRef& rest, const Triangles& triangles, const VertexRings& rings,
                        double max_turn_rad, int rounds, Points& places, Index& turned_before) {
    std::vector<TurnedTriangle> turned = find_turned(rest, triangles, rings, places, max_turn_rad);
    turned_before = static_cast<Index>(turned.size());
    Points best = places;
    std::size_t fewest = turned.size();
    std::vector<std::uint32_t> around;
    std::vector<Matrix3> rotation_of(static_cast<std::size_t>(places.rows()));
    for (int round = 0; round < rounds && !turned.empty(); ++round) {
        std::vector<std::uint8_t> touched(static_cast<std::size_t>(places.rows()), 0);
        for (const TurnedTriangle& one : turned) {
            const Index t = static_cast<Index>(one.triangle);
            gather(rings, {triangles(t, 0), triangles(t, 1), triangles(t, 2)}, round < 4 ? 0 : 1,
                   around);
            for (const std::uint32_t v : around) touched[v] = 1, rotation_of[v] = one.rotation;
        }
        for (int step = 0; step < 6; ++step) {
            Points moved = places;
            for (std::size_t i = 0; i < touched.size(); ++i) {
                if (!touched[i] || rings.begin[i + 1] == rings.begin[i]) continue;
                const Index v = static_cast<Index>(i);
                Vector3 mean = Vector3::Zero();
                for (std::uint32_t k = rings.begin[i]; k < rings.begin[i + 1]; ++k) {
                    const Index j = static_cast<Index>(rings.neighbours[k]);
                    mean += places.row(j).transpose() +
                            rotation_of[i] * (rest.row(v) - rest.row(j)).transpose();
                }
                mean /= static_cast<double>(rings.begin[i + 1] - rings.begin[i]);
                moved.row(v) = 0.3 * places.row(v) + 0.7 * mean.transpose();
            }
            places = moved;
        }
        turned = find_turned(rest, triangles, rings, places, max_turn_rad);
        if (turned.size() < fewest) fewest = turned.size(), best = places;
    }
    places = best;
    return static_cast<Index>(fewest);
}

Index count_self_intersections(const PointsRef& places, const Triangles& triangles,
                               const Context& context) {
    const TriangleTree tree(places, triangles, context);
    const Index count = triangles.rows();
    return parallel_sum<Index>(
        context, static_cast<std::size_t>(count), 512, 0, [&](std::size_t begin, std::size_t end) {
            Index found = 0;
            for (std::size_t s = begin; s < end; ++s)
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t a = triangles(static_cast<Index>(s), k),
                                        b = triangles(static_cast<Index>(s), (k + 1) % 3);
                    if (a > b) continue;  // each inner edge once
                    const Vector3 from = places.row(a).transpose(),
                                  along = places.row(b).transpose() - from;
                    // Shortened, so that the edge's own triangles and their neighbours are not met.
                    const RayHit hit = tree.first_hit(from + 0.01 * along, along, 0.98);
                    if (!hit.valid()) continue;
                    bool shares = false;
                    for (int c = 0; c < 3; ++c) {
                        const std::uint32_t v = triangles(static_cast<Index>(hit.triangle), c);
                        shares = shares || v == a || v == b;
                    }
                    if (!shares) ++found;
                }
            return found;
        });
}

}  // namespace mien
