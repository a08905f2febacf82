// Cotangent Laplacian of a triangle mesh (Pinkall & Polthier 1993; Meyer et al. 2003; kosk-2024,
// 4.10): L_ij = -(cot a_ij + cot b_ij) / 2, from edge lengths alone, so that one piece of code
// serves the mesh as it lies in space and its intrinsic Delaunay triangulation (Bobenko &
// Springborn 2007; Fisher et al. 2007). Departures: kosk-2024 leaves negative cotangents as they
// are; the default here flips edges on intrinsic lengths until no inner edge has a negative weight.
// Lengths of meshes with needles or zero-area triangles are mollified (Sharp & Crane 2020): one
// small length is added to every edge until each triangle has an area, so every cotangent is
// finite.
#include "geometry/laplacian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/error.hpp"
#include "geometry/intrinsic_triangulation.hpp"

namespace mien {
namespace {

/// Mass of the three corners (mixed Voronoi: the circumcentric cell of an acute triangle, else half
/// of the area at the obtuse corner and a quarter at the others, Meyer et al. 2003, 3.3).
std::array<double, 3> corner_areas(const IntrinsicTriangle& t,
                                   const std::array<double, 3>& cotangent, double area,
                                   MassKind kind) {
    if (kind == MassKind::barycentric) return {area / 3, area / 3, area / 3};
    for (int c = 0; c < 3; ++c)
        if (cotangent[c] < 0) {
            std::array<double, 3> split = {area / 4, area / 4, area / 4};
            split[c] = area / 2;
            return split;
        }
    std::array<double, 3> cell;
    for (int c = 0; c < 3; ++c) {
        // Side c joins corners c and c + 1 and faces corner c + 2.
        const int next = (c + 1) % 3, previous = (c + 2) % 3;
        const double a = t.length[c], b = t.length[previous];
        cell[c] = (a * a * cotangent[previous] + b * b * cotangent[next]) / 8;
    }
    return cell;
}

}  // namespace

LaplaceOperator build_laplacian(const PointsRef& vertices, const TrianglesRef& triangles,
                                const LaplacianOptions& options) {
    IntrinsicTriangulation mesh(vertices, triangles);
    if (options.negative == NegativeCotangents::intrinsic_delaunay) mesh.make_delaunay();

    const Index n = vertices.rows();
    LaplaceOperator laplace;
    laplace.mass = Vector::Zero(n);
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(mesh.triangles().size() * 3);
    for (const IntrinsicTriangle& t : mesh.triangles()) {
        const double area = t.area();
        const std::array<double, 3> cotangent = t.cotangents(area);
        const std::array<double, 3> cell = corner_areas(t, cotangent, area, options.mass);
        for (int c = 0; c < 3; ++c) {
            laplace.mass[t.vertex[c]] += cell[c];
            const auto i = static_cast<int>(t.vertex[c]);
            const auto j = static_cast<int>(t.vertex[(c + 1) % 3]);
            // A flip may join a vertex to itself: such an edge carries no difference.
            if (i != j)
                entries.emplace_back(std::max(i, j), std::min(i, j), cotangent[(c + 2) % 3] / 2);
        }
    }
    SparseMatrix weights(n, n);  // strictly lower triangle of the edge weights
    weights.setFromTriplets(entries.begin(), entries.end());
    entries.clear();
    Vector diagonal = Vector::Zero(n);
    for (Index j = 0; j < n; ++j)
        for (SparseMatrix::InnerIterator it(weights, j); it; ++it) {
            if (options.negative == NegativeCotangents::clamp && it.value() < 0) it.valueRef() = 0;
            diagonal[j] += it.value();
            diagonal[it.row()] += it.value();
        }
    entries.reserve(static_cast<std::size_t>(2 * weights.nonZeros() + n));
    for (Index j = 0; j < n; ++j) {
        entries.emplace_back(static_cast<int>(j), static_cast<int>(j), diagonal[j]);
        for (SparseMatrix::InnerIterator it(weights, j); it; ++it) {
            entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(j), -it.value());
            entries.emplace_back(static_cast<int>(j), static_cast<int>(it.row()), -it.value());
        }
    }
    laplace.stiffness.resize(n, n);
    laplace.stiffness.setFromTriplets(entries.begin(), entries.end());

    // A vertex of no triangle, or of zero-area ones alone, has no area of its own: it gets one that
    // keeps the scale of the problem, since its value is free either way.
    const double mean = laplace.mass.sum() / static_cast<double>(n);
    const double floor = 1e-10 * mean;
    for (Index i = 0; i < n; ++i)
        if (!(laplace.mass[i] > 0))
            laplace.mass[i] = mean > 0 ? mean : 1.0;
        else if (laplace.mass[i] < floor)
            laplace.mass[i] = floor;
    return laplace;
}

}  // namespace mien
