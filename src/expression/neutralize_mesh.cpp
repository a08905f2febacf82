#include "expression/neutralize_mesh.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

#include "base/error.hpp"
#include "geometry/laplacian.hpp"

namespace mien {

TopologyMatch match_topology(const ExpressionModel& model, Index num_vertices,
                             const TrianglesRef& triangles) {
    const Index n = model.num_vertices();
    if (num_vertices < n) return TopologyMatch::none;
    if (triangles.rows() == 0 || model.triangles.rows() == 0)
        return num_vertices == n ? TopologyMatch::same : TopologyMatch::none;
    if (num_vertices == n)
        return triangles.rows() == model.triangles.rows() && triangles == model.triangles
                   ? TopologyMatch::same
                   : TopologyMatch::none;
    Index next = 0;
    for (Index row = 0; row < triangles.rows(); ++row) {
        if (triangles.row(row).maxCoeff() >= static_cast<std::uint64_t>(n)) continue;
        if (next == model.triangles.rows() || triangles.row(row) != model.triangles.row(next))
            return TopologyMatch::none;
        ++next;
    }
    return next == model.triangles.rows() ? TopologyMatch::prefix : TopologyMatch::none;
}

Points extend_displacement(const PointsRef& vertices, const TrianglesRef& triangles,
                           const PointsRef& known, double decay_mm) {
    if (!(decay_mm > 0.0) || !std::isfinite(decay_mm))
        fail(Status::invalid_argument, "decay_mm must be positive and finite");
    const Index n = known.rows(), rest = vertices.rows() - n;
    Points displacement(vertices.rows(), 3);
    displacement.topRows(n) = known;
    if (rest == 0) return displacement;
    const LaplaceOperator laplace = build_laplacian(vertices, triangles, LaplacianOptions());
    std::vector<Eigen::Triplet<double>> entries;
    Matrix right = Matrix::Zero(rest, 3);
    for (Index column = 0; column < laplace.stiffness.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(laplace.stiffness, column); entry; ++entry) {
            if (entry.row() < n) continue;
            if (column >= n)
                entries.emplace_back(static_cast<int>(entry.row() - n), static_cast<int>(column - n),
                                     entry.value());
            else
                right.row(entry.row() - n) -= entry.value() * known.row(column);
        }
    for (Index i = 0; i < rest; ++i)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(i),
                             laplace.mass[n + i] / (decay_mm * decay_mm));
    SparseMatrix system(rest, rest);
    system.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> factor(system);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the displacement cannot be carried beyond the model's rim");
    displacement.bottomRows(rest) = factor.solve(right);
    return displacement;
}

NeutralizationResult neutralize_mesh(const Context& context, const ExpressionModel& model,
                                     const TriMesh& mesh, const Vector& weights,
                                     const NeutralizeMeshOptions& options) {
    const Index n = model.num_vertices(), all = mesh.vertices.rows();
    const TopologyMatch match = match_topology(model, all, mesh.triangles);
    if (match == TopologyMatch::none)
        fail(Status::mismatch,
             "the face (%lld vertices) is not in the expression model's topology (%lld vertices): "
             "register it with the template that the model's faces were made with",
             static_cast<long long>(all), static_cast<long long>(n));
    if (match == TopologyMatch::same)
        return neutralize(context, model, mesh.vertices, weights, options.neutralize);
    if (weights.size() != 0 && weights.size() != all)
        fail(Status::mismatch, "%lld weights for %lld vertices",
             static_cast<long long>(weights.size()), static_cast<long long>(all));
    NeutralizationResult result =
        neutralize(context, model, mesh.vertices.topRows(n),
                   weights.size() != 0 ? Vector(weights.head(n)) : weights, options.neutralize);
    const Points moved = result.neutral_vertices - mesh.vertices.topRows(n);
    result.neutral_vertices =
        mesh.vertices + extend_displacement(mesh.vertices, mesh.triangles, moved, options.decay_mm);
    if (result.uncertainty_mm.size() != 0) {
        Vector uncertainty = Vector::Zero(all);
        uncertainty.head(n) = result.uncertainty_mm;
        result.uncertainty_mm = uncertainty;
    }
    return result;
}

}  // namespace mien
