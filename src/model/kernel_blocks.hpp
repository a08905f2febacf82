// Kernel values between all vertices of a template and a few control points. What costs (geodesic
// distances, eigenpairs) is computed once and serves every sigma afterwards, which is what tuning
// needs.
#pragma once

#include <memory>
#include <vector>

#include "base/context.hpp"
#include "geometry/heat_method.hpp"
#include "geometry/spectrum.hpp"
#include "mesh/tri_mesh.hpp"
#include "model/kernel.hpp"

namespace mien {

/// `count` vertices spread over the surface by farthest-point sampling along the edges, so that the
/// two sides of a slit both get their own. Starts at the vertex farthest from the centroid; ties go
/// to the lower number. O(#V log #V log count).
std::vector<std::uint32_t> farthest_points(const PointsRef& vertices, const TrianglesRef& triangles,
                                           Index count);

/// Matern spectrum on a surface: lambda_j = c (kappa^2 + mu_j)^-(nu + 1), kappa = sqrt(2 nu) /
/// sigma, the solution of (kappa^2 - Laplace)^((nu + 1) / 2) u = white noise in two dimensions
/// (Whittle; Lindgren, Rue and Lindstroem 2011). c makes the area-weighted mean of k(x, x) over all
/// modes scale^2; the modes beyond the computed ones are counted by Weyl's law mu_j ~ 4 pi j /
/// area.
struct MaternSpectrum {
    Vector variances;  ///< lambda_j of the computed modes, descending
    double tail = 0;   ///< share of the total variance beyond them
};
MaternSpectrum matern_spectrum(const Vector& laplace_eigenvalues, double area_mm2,
                               const KernelTerm& term);

class KernelBlocks {
  public:
    /// Computes what the kinds of kernel in `terms` need. num_pairs: Laplace-Beltrami pairs for a
    /// Matern term. The mesh is borrowed for the lifetime of this object.
    KernelBlocks(const TriMesh& mesh, std::vector<std::uint32_t> control_points,
                 const std::vector<KernelTerm>& terms, Index num_pairs,
                 const HeatOptions& heat_options, const Context& context);

    const std::vector<std::uint32_t>& control_points() const { return control_points_; }
    /// #V x #control; rows of control points form a symmetric block.
    void evaluate(const std::vector<KernelTerm>& terms, Matrix& values,
                  const Context& context) const;
    /// k(x, x) per vertex.
    Vector diagonal(const std::vector<KernelTerm>& terms) const;

    const EigenPairs& eigenpairs() const { return pairs_; }
    double area_mm2() const { return area_mm2_; }

  private:
    const TriMesh& mesh_;
    std::vector<std::uint32_t> control_points_;
    Eigen::MatrixXf geodesic_;  ///< #V x #control, or empty
    EigenPairs pairs_;
    double area_mm2_ = 0;
};

}  // namespace mien
