#include "registration/refine.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

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

VertexRings build_rings(Index num_vertices, const Triangles& triangles) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    pairs.reserve(static_cast<std::size_t>(6 * triangles.rows()));
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            pairs.push_back({a, b});
            pairs.push_back({b, a});
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    VertexRings rings;
    rings.begin.assign(static_cast<std::size_t>(num_vertices) + 1, 0);
    rings.neighbours.reserve(pairs.size());
    for (const auto& [a, b] : pairs) {
        ++rings.begin[a + 1];
        rings.neighbours.push_back(b);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(num_vertices); ++i) rings.begin[i + 1] += rings.begin[i];
    return rings;
}

void close_gap(const ScanSurface& scan, const Triangles& triangles, const VertexRings& rings, const Vector& trust,
               const CorrespondenceOptions& match, const GapOptions& options, Points& places,
               const Context& context) {
    const Index n = places.rows();
    CorrespondenceOptions filter = match;
    filter.robust_scale_mm = options.robust_scale_mm;
    filter.max_distance_mm = 4 * options.robust_scale_mm;
    Correspondences found;
    for (int round = 0; round < options.rounds; ++round) {
        context.progress(Stage::refining, static_cast<double>(round) / options.rounds);
        const Points normals = vertex_normals(places, triangles);
        find_correspondences(scan, places, normals, Vector(), filter, found, context);
        Vector weight(n), gap(n);
        for (Index i = 0; i < n; ++i) {
            weight[i] = found.weight[i] * trust[i];
            // The gap to the plane through the hit, seen along the template's normal.
            const Vector3 to_hit = found.hits[static_cast<std::size_t>(i)].valid()
                                       ? Vector3(found.hits[static_cast<std::size_t>(i)].point - places.row(i).transpose())
                                       : Vector3(Vector3::Zero());
            gap[i] = to_hit.dot(normals.row(i).transpose());
        }
        // Conjugate gradients on (W + alpha L'L + epsilon) delta = W gap; well conditioned, tens of steps.
        Vector delta = Vector::Zero(n), residual = weight.cwiseProduct(gap), direction = residual, image, scratch;
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
            places.row(i) += std::clamp(delta[i], -options.max_step_mm, options.max_step_mm) * normals.row(i);
    }
    context.progress(Stage::refining, 1);
}

std::vector<std::uint32_t> find_folds(const PointsRef& places, const PointsRef& rest, const Triangles& triangles,
                                      double folded_below, double flat_above) {
    const auto unit = [&](const PointsRef& points) {
        Points normals = triangle_normals(points, triangles);
        for (Index t = 0; t < normals.rows(); ++t) {
            const double length = normals.row(t).norm();
            if (length > 0) normals.row(t) /= length;
        }
        return normals;
    };
    const Points now = unit(places), before = unit(rest);
    // Triangles over shared edges.
    std::vector<std::array<std::uint32_t, 3>> sides;
    sides.reserve(static_cast<std::size_t>(3 * triangles.rows()));
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(t)});
        }
    std::sort(sides.begin(), sides.end());
    std::vector<std::uint8_t> folded(static_cast<std::size_t>(triangles.rows()), 0);
    for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
        if (sides[k][0] != sides[k + 1][0] || sides[k][1] != sides[k + 1][1]) continue;
        const Index s = sides[k][2], t = sides[k + 1][2];
        if (now.row(s).dot(now.row(t)) < folded_below && before.row(s).dot(before.row(t)) > flat_above)
            folded[static_cast<std::size_t>(s)] = folded[static_cast<std::size_t>(t)] = 1;
    }
    std::vector<std::uint32_t> folds;
    for (std::size_t t = 0; t < folded.size(); ++t)
        if (folded[t]) folds.push_back(static_cast<std::uint32_t>(t));
    return folds;
}

Index repair_folds(const PointsRef& rest, const Triangles& triangles, const VertexRings& rings, int rounds,
                   Points& places, Index& repaired) {
    std::vector<std::uint32_t> folds = find_folds(places, rest, triangles);
    repaired = static_cast<Index>(folds.size());
    for (int round = 0; round < rounds && !folds.empty(); ++round) {
        std::vector<std::uint8_t> touched(static_cast<std::size_t>(places.rows()), 0);
        for (const std::uint32_t t : folds)
            for (int k = 0; k < 3; ++k) touched[triangles(static_cast<Index>(t), k)] = 1;
        for (int ring = 0; ring < 1 + round / 4; ++ring) {
            std::vector<std::uint8_t> wider = touched;
            for (std::size_t i = 0; i < touched.size(); ++i)
                if (touched[i])
                    for (std::uint32_t k = rings.begin[i]; k < rings.begin[i + 1]; ++k) wider[rings.neighbours[k]] = 1;
            touched = std::move(wider);
        }
        // Displacements from the rest shape are averaged, so the template's own form is kept.
        for (int step = 0; step < 4; ++step) {
            Points moved = places;
            for (std::size_t i = 0; i < touched.size(); ++i) {
                if (!touched[i] || rings.begin[i + 1] == rings.begin[i]) continue;
                Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
                for (std::uint32_t k = rings.begin[i]; k < rings.begin[i + 1]; ++k) {
                    const Index j = static_cast<Index>(rings.neighbours[k]);
                    mean += places.row(j) - rest.row(j);
                }
                mean /= static_cast<double>(rings.begin[i + 1] - rings.begin[i]);
                const Index v = static_cast<Index>(i);
                moved.row(v) = 0.4 * places.row(v) + 0.6 * (rest.row(v) + mean);
            }
            places = moved;
        }
        folds = find_folds(places, rest, triangles);
    }
    return static_cast<Index>(folds.size());
}

Index count_self_intersections(const PointsRef& places, const Triangles& triangles, const Context& context) {
    const TriangleTree tree(places, triangles, context);
    const Index count = triangles.rows();
    return parallel_sum<Index>(context, static_cast<std::size_t>(count), 512, 0, [&](std::size_t begin, std::size_t end) {
        Index found = 0;
        for (std::size_t s = begin; s < end; ++s)
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = triangles(static_cast<Index>(s), k), b = triangles(static_cast<Index>(s), (k + 1) % 3);
                if (a > b) continue;  // each inner edge once
                const Vector3 from = places.row(a).transpose(), along = places.row(b).transpose() - from;
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
