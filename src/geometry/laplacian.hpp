// Cotangent Laplacian and mass of a triangle mesh.
#pragma once

#include <Eigen/SparseCore>

#include "base/types.hpp"

namespace mien {

using SparseMatrix = Eigen::SparseMatrix<double>;

enum class MassKind { barycentric, mixed_voronoi };
enum class NegativeCotangents { keep, clamp, intrinsic_delaunay };

struct LaplacianOptions {
    MassKind mass = MassKind::mixed_voronoi;
    NegativeCotangents negative = NegativeCotangents::intrinsic_delaunay;
};

/// stiffness is symmetric positive semidefinite (rows sum to zero), mass diagonal and positive:
/// L u = lambda M u with lambda in 1/mm^2. Needle and zero-area triangles give finite entries.
struct LaplaceOperator {
    SparseMatrix stiffness;
    Vector mass;  ///< #V, mm^2
};

LaplaceOperator build_laplacian(const PointsRef& vertices, const TrianglesRef& triangles,
                                const LaplacianOptions& options);

}  // namespace mien
