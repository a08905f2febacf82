#include "expression/scan_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/SparseCholesky>
#include <vector>

#include "base/error.hpp"
#include "geometry/alignment.hpp"
#include "geometry/laplacian.hpp"
#include "mesh/adjacency.hpp"
#include "spatial/triangle_tree.hpp"

namespace mien {
namespace {

constexpr double kFarWeight = 0.05;  ///< pull of the rigid motion on far pieces
constexpr Index kMaxAnchors = 4000;  ///< confident neighbours that a rigid motion is fitted to

/// Rigid motion of the anchors, or their mean translation where they do not determine a rotation.
Similarity motion_of(const Points& anchors, const Points& moved) {
    try {
        return align_points(anchors, moved, Vector(), false);
    } catch (const Error& error) {
        if (error.status() != Status::no_solution) throw;
        Similarity shift;
        if (anchors.rows() != 0) shift.translation = (moved - anchors).colwise().mean();
        return shift;
    }
}

/// Gives every connected set of far vertices the rigid motion of the confident ones around it.
void move_far_pieces(const Points& vertices, const Triangles& triangles,
                     const std::vector<char>& far, Points& displacement) {
    const Index n = vertices.rows();
    const VertexRings rings = build_rings(n, triangles);
    std::vector<int> ring(static_cast<std::size_t>(n), 0);
    std::vector<char> done(static_cast<std::size_t>(n), 0);
    int stamp = 0;
    for (Index seed = 0; seed < n; ++seed) {
        if (!far[static_cast<std::size_t>(seed)] || done[static_cast<std::size_t>(seed)]) continue;
        std::vector<std::uint32_t> piece{static_cast<std::uint32_t>(seed)}, anchors;
        done[static_cast<std::size_t>(seed)] = 1;
        ++stamp;
        for (std::size_t k = 0; k < piece.size(); ++k)
            for (const std::uint32_t other : rings.of(piece[k])) {
                if (far[other]) {
                    if (!done[other]) piece.push_back(other);
                    done[other] = 1;
                } else if (ring[other] != stamp &&
                           static_cast<Index>(anchors.size()) < kMaxAnchors) {
                    ring[other] = stamp;
                    anchors.push_back(other);
                }
            }
        if (anchors.empty()) continue;  // a piece of its own: nothing tells how it should move
        Points from(static_cast<Index>(anchors.size()), 3), to(from.rows(), 3);
        for (Index k = 0; k < from.rows(); ++k) {
            from.row(k) = vertices.row(anchors[static_cast<std::size_t>(k)]);
            to.row(k) = from.row(k) + displacement.row(anchors[static_cast<std::size_t>(k)]);
        }
        const Similarity motion = motion_of(from, to);
        for (std::uint32_t vertex : piece) {
            const Vector3 point = vertices.row(vertex);
            displacement.row(vertex) = motion.apply(point) - point;
        }
    }
}

}  // namespace

ScanTransferResult transfer_to_scan(const Context& context, const TriMesh& fitted,
                                    const PointsRef& neutral_vertices, const TriMesh& scan,
                                    const ScanTransferOptions& options) {
    if (!(options.max_distance_mm > 0.0) || !std::isfinite(options.max_distance_mm) ||
        !(options.smoothing_mm >= 0.0) || !std::isfinite(options.smoothing_mm))
        fail(Status::invalid_argument,
             "max_distance_mm must be positive, smoothing_mm not negative");
    if (fitted.triangles.rows() == 0)
        fail(Status::invalid_argument, "the fitted face has no triangles");
    if (neutral_vertices.rows() != fitted.vertices.rows())
        fail(Status::mismatch, "the neutral face has %lld vertices, the fitted face %lld",
             static_cast<long long>(neutral_vertices.rows()),
             static_cast<long long>(fitted.vertices.rows()));
    check_mesh(scan, "the scan");
    const Index n = scan.vertices.rows();
    context.progress(Stage::neutralizing, 0.0);
    const TriangleTree tree(fitted.vertices, fitted.triangles, context);
    std::vector<SurfaceHit> hits;
    tree.closest(scan.vertices, std::numeric_limits<double>::infinity(), hits, context);
    context.progress(Stage::neutralizing, 0.4);

    Points displacement(n, 3);
    Vector weight(n);
    std::vector<char> far(static_cast<std::size_t>(n), 0);
    ScanTransferResult result;
    for (Index i = 0; i < n; ++i) {
        const SurfaceHit& hit = hits[static_cast<std::size_t>(i)];
        displacement.row(i).setZero();
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t corner = fitted.triangles(hit.triangle, k);
            displacement.row(i) +=
                hit.barycentric[k] * (neutral_vertices.row(corner) - fitted.vertices.row(corner));
        }
        const double share = hit.distance() / options.max_distance_mm;
        weight[i] = share < 1.0 ? (1.0 - share * share) * (1.0 - share * share) : 0.0;
        if (weight[i] < kFarWeight) {
            far[static_cast<std::size_t>(i)] = 1;
            ++result.num_far_vertices;
            weight[i] = kFarWeight;
        }
    }
    result.scan = scan;
    if (scan.triangles.rows() != 0) {
        move_far_pieces(scan.vertices, scan.triangles, far, displacement);
        context.progress(Stage::neutralizing, 0.5);
        LaplacianOptions laplacian;
        laplacian.negative = NegativeCotangents::clamp;  // needs no manifold
        laplacian.mass = MassKind::barycentric;
        const LaplaceOperator laplace = build_laplacian(scan.vertices, scan.triangles, laplacian);
        const Vector diagonal = laplace.mass.cwiseProduct(weight);
        SparseMatrix system = options.smoothing_mm * options.smoothing_mm * laplace.stiffness;
        for (Index i = 0; i < n; ++i) system.coeffRef(i, i) += diagonal[i];
        const Eigen::SimplicialLDLT<SparseMatrix> factor(system);
        if (factor.info() != Eigen::Success)
            fail(Status::no_solution,
                 "the displacement cannot be smoothed over this scan's surface");
        displacement = factor.solve(diagonal.asDiagonal() * Matrix(displacement)).eval();
    }
    result.scan.vertices += displacement;
    result.max_displacement_mm = displacement.rowwise().norm().maxCoeff();
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

}  // namespace mien
