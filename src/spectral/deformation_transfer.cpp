// S_t = [e1' e2' n'] [e1 e2 n]^-1 from the source, n the normal over the square root of its length
// as in Sumner & Popovic (2004), 3. Their fourth vertex only carries the third column, which the
// target's own edges never meet, so it is eliminated: what remains is the Poisson problem of Botsch
// et al. (2006), L x = sum of c_ij S_t e_ij, with one right-hand side a coordinate. Weighted by the
// target's areas, which the original is not: otherwise small triangles would pull as hard as large
// ones.
#include "spectral/deformation_transfer.hpp"

#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <numeric>
#include <vector>

#include "base/error.hpp"
#include "geometry/laplacian.hpp"

namespace mien {
namespace {

constexpr double kLeastArea = 1e-7;  // of the longest edge squared

/// Columns e1, e2, n / sqrt|n|; false for a triangle without area.
bool frame_of(const PointsRef& vertices, const TrianglesRef& triangles, Index t, Matrix3& frame) {
    const Vector3 a = vertices.row(triangles(t, 0));
    frame.col(0) = vertices.row(triangles(t, 1)).transpose() - a;
    frame.col(1) = vertices.row(triangles(t, 2)).transpose() - a;
    const Vector3 normal = frame.col(0).cross(frame.col(1));
    const double length = normal.norm();
    const double longest = std::max(frame.col(0).squaredNorm(), frame.col(1).squaredNorm());
    if (!(length > kLeastArea * longest)) return false;
    frame.col(2) = normal / std::sqrt(length);
    return true;
}

}  // namespace

struct DeformationTransfer::State {
    TriMesh target;
    Points cotangent;  // half the cotangent of each corner
    std::vector<int> piece;
    std::vector<int> piece_size;
    std::vector<char> pinned;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> laplace;
};

DeformationTransfer::DeformationTransfer(const TriMesh& target_neutral, const Context& context)
    : state_(std::make_unique<State>()) {
    check_mesh(target_neutral, "the target");
    if (target_neutral.triangles.rows() == 0)
        fail(Status::invalid_mesh, "the target has no triangles");
    context.check_cancelled();
    State& s = *state_;
    s.target.vertices = target_neutral.vertices;
    s.target.triangles = target_neutral.triangles;
    const Points& x = s.target.vertices;
    const Triangles& triangles = s.target.triangles;
    const Index n = x.rows();
    std::vector<int> root(static_cast<std::size_t>(n));
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    std::vector<Eigen::Triplet<double, int>> entries;
    s.cotangent.resize(triangles.rows(), 3);
    Vector diagonal = Vector::Zero(n);
    for (Index t = 0; t < triangles.rows(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index i = triangles(t, c), j = triangles(t, (c + 1) % 3),
                        k = triangles(t, (c + 2) % 3);
            const Vector3 u = x.row(j) - x.row(i), v = x.row(k) - x.row(i);
            const double longest =
                std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
            // A floor under the area scales the whole triangle's energy, so it stays positive.
            const double area = std::max(u.cross(v).norm(), 1e-4 * longest);
            s.cotangent(t, c) = area > 0 ? 0.5 * u.dot(v) / area : 0.0;
        }
        for (int c = 0; c < 3; ++c) {
            const int i = static_cast<int>(triangles(t, c)),
                      j = static_cast<int>(triangles(t, (c + 1) % 3));
            const double w = s.cotangent(t, (c + 2) % 3);
            if (i == j) continue;
            diagonal[i] += w;
            diagonal[j] += w;
            entries.emplace_back(std::max(i, j), std::min(i, j), -w);
            const int a = find(i), b = find(j);
            if (a != b) root[std::max(a, b)] = std::min(a, b);
        }
    }
    s.piece.assign(static_cast<std::size_t>(n), -1);
    s.pinned.assign(static_cast<std::size_t>(n), 0);
    for (Index v = 0; v < n; ++v) {
        const int r = find(static_cast<int>(v));
        if (r == v) {
            s.piece[v] = static_cast<int>(s.piece_size.size());
            s.piece_size.push_back(0);
            s.pinned[v] = 1;
        } else {
            s.piece[v] = s.piece[r];
        }
        ++s.piece_size[s.piece[v]];
    }
    SparseMatrix matrix(n, n);
    const double tiny = 1e-15 * diagonal.sum() / static_cast<double>(n) + 1e-300;
    for (auto& entry : entries)
        if (s.pinned[entry.row()] || s.pinned[entry.col()])
            entry = Eigen::Triplet<double, int>(entry.row(), entry.col(), 0.0);
    for (Index v = 0; v < n; ++v)
        entries.emplace_back(static_cast<int>(v), static_cast<int>(v),
                             s.pinned[v] ? 1.0 : diagonal[v] + tiny);
    matrix.setFromTriplets(entries.begin(), entries.end());
    s.laplace.compute(matrix);
    if (s.laplace.info() != Eigen::Success || !s.laplace.vectorD().allFinite())
        fail(Status::no_solution, "the target's Laplacian cannot be factorised");
}

DeformationTransfer::~DeformationTransfer() = default;

Points DeformationTransfer::transfer(const PointsRef& source_neutral,
                                     const PointsRef& source_expression,
                                     const Context& context) const {
    const State& s = *state_;
    const Index n = s.target.vertices.rows();
    if (source_neutral.rows() != n || source_expression.rows() != n)
        fail(Status::mismatch, "source faces with %lld and %lld vertices for a target with %lld",
             static_cast<long long>(source_neutral.rows()),
             static_cast<long long>(source_expression.rows()), static_cast<long long>(n));
    if (!source_neutral.allFinite() || !source_expression.allFinite())
        fail(Status::invalid_mesh, "a source face with a vertex that is not finite");
    context.check_cancelled();
    const Triangles& triangles = s.target.triangles;
    Points right = Points::Zero(n, 3);
    for (Index t = 0; t < triangles.rows(); ++t) {
        Matrix3 before, after, gradient = Matrix3::Identity();
        // A source triangle without area has no deformation: its target keeps its shape.
        if (frame_of(source_neutral, triangles, t, before) &&
            frame_of(source_expression, triangles, t, after))
            gradient = after * before.inverse();
        for (int c = 0; c < 3; ++c) {
            const Index i = triangles(t, c), j = triangles(t, (c + 1) % 3);
            const Vector3 edge = s.target.vertices.row(i) - s.target.vertices.row(j);
            const Eigen::RowVector3d pull =
                s.cotangent(t, (c + 2) % 3) * (gradient * edge).transpose();
            right.row(i) += pull;
            right.row(j) -= pull;
        }
    }
    for (Index v = 0; v < n; ++v)
        if (s.pinned[v]) right.row(v).setZero();
    Points x = s.laplace.solve(right);
    if (!x.allFinite()) fail(Status::no_solution, "the transferred face is not finite");
    std::vector<Eigen::RowVector3d> shift(s.piece_size.size(), Eigen::RowVector3d::Zero());
    for (Index v = 0; v < n; ++v)
        shift[s.piece[v]] +=
            s.target.vertices.row(v) + source_expression.row(v) - source_neutral.row(v) - x.row(v);
    for (Index v = 0; v < n; ++v) x.row(v) += shift[s.piece[v]] / s.piece_size[s.piece[v]];
    return x;
}

}  // namespace mien
