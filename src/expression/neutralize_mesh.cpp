#include "expression/neutralize_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/SparseCholesky>

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
                entries.emplace_back(static_cast<int>(entry.row() - n),
                                     static_cast<int>(column - n), entry.value());
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

namespace {

TopologyMatch require_match(const ExpressionModel& model, const TriMesh& mesh) {
    const TopologyMatch match = match_topology(model, mesh.vertices.rows(), mesh.triangles);
    if (match == TopologyMatch::none)
        fail(Status::mismatch,
             "the face (%lld vertices) is not in the expression model's topology (%lld vertices): "
             "register it with the template that the model's faces were made with",
             static_cast<long long>(mesh.vertices.rows()),
             static_cast<long long>(model.num_vertices()));
    return match;
}

Vector weights_before_rim(const ExpressionModel& model, const TriMesh& mesh,
                          const Vector& weights) {
    if (weights.size() == 0) return weights;
    if (weights.size() != mesh.vertices.rows())
        fail(Status::mismatch, "%lld weights for %lld vertices",
             static_cast<long long>(weights.size()), static_cast<long long>(mesh.vertices.rows()));
    return weights.head(model.num_vertices());
}

/// Without what lies behind the rim: no expression reaches there.
std::vector<std::uint32_t> treated_before_rim(const ExpressionModel& model,
                                              const std::vector<std::uint32_t>& treated,
                                              Index num_vertices) {
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t vertex : treated) {
        if (vertex >= static_cast<std::uint64_t>(num_vertices))
            fail(Status::mismatch, "the treated zone names vertex %u of %lld", vertex,
                 static_cast<long long>(num_vertices));
        if (vertex < static_cast<std::uint64_t>(model.num_vertices())) kept.push_back(vertex);
    }
    return kept;
}

/// The mesh with its first vertices replaced and the others following them.
Points carried(const PointsRef& vertices, const TrianglesRef& triangles, const Points& first,
               double decay_mm) {
    const Points moved = first - vertices.topRows(first.rows());
    return vertices + extend_displacement(vertices, triangles, moved, decay_mm);
}

}  // namespace

NeutralizationResult neutralize_mesh(const Context& context, const ExpressionModel& model,
                                     const TriMesh& mesh, const Vector& weights,
                                     const NeutralizeMeshOptions& options) {
    const Index n = model.num_vertices(), all = mesh.vertices.rows();
    if (require_match(model, mesh) == TopologyMatch::same)
        return neutralize(context, model, mesh.vertices, weights, options.neutralize);
    NeutralizeOptions before_rim = options.neutralize;
    before_rim.treated = treated_before_rim(model, before_rim.treated, all);
    NeutralizationResult result = neutralize(context, model, mesh.vertices.topRows(n),
                                             weights_before_rim(model, mesh, weights), before_rim);
    result.neutral_vertices =
        carried(mesh.vertices, mesh.triangles, result.neutral_vertices, options.decay_mm);
    if (result.uncertainty_mm.size() != 0) {
        Vector uncertainty = Vector::Zero(all);
        uncertainty.head(n) = result.uncertainty_mm;
        result.uncertainty_mm = uncertainty;
    }
    return result;
}

VisitsResult neutralize_visit_meshes(const Context& context, const ExpressionModel& model,
                                     const std::vector<std::shared_ptr<const TriMesh>>& meshes,
                                     const std::vector<Vector>& weights, VisitsOptions options,
                                     double decay_mm) {
    if (meshes.empty()) fail(Status::invalid_argument, "there is no face to neutralize");
    if (!weights.empty() && weights.size() != meshes.size())
        fail(Status::mismatch, "weights of %zu faces for %zu faces", weights.size(), meshes.size());
    const Index n = model.num_vertices(), all = meshes[0]->vertices.rows();
    std::vector<VisitFace> faces;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        const TriMesh& mesh = *meshes[k];
        require_match(model, mesh);
        if (mesh.vertices.rows() != all)
            fail(Status::mismatch, "face %zu has %lld vertices, the first one %lld", k,
                 static_cast<long long>(mesh.vertices.rows()), static_cast<long long>(all));
        faces.push_back({mesh.vertices.topRows(n),
                         weights.empty() ? Vector() : weights_before_rim(model, mesh, weights[k])});
    }
    options.treated = treated_before_rim(model, options.treated, all);
    VisitsResult result = neutralize_visits(context, model, faces, options);
    if (all == n) return result;
    for (std::size_t k = 0; k < meshes.size(); ++k)
        result.neutral_vertices[k] = carried(meshes[k]->vertices, meshes[k]->triangles,
                                             result.neutral_vertices[k], decay_mm);
    const Points first = result.poses[0].inverse().apply(PointsRef(meshes[0]->vertices));
    result.shared_vertices = carried(first, meshes[0]->triangles, result.shared_vertices, decay_mm);
    return result;
}

}  // namespace mien
