// Frequency bands of faces in correspondence (kosk-2024, 4.1-4.5, 4.10-4.11, 4.15, 4.16).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/safetensors.hpp"
#include "geometry/laplacian.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

struct SpectralBasisOptions {
    Index num_modes = 500;  ///< k of the thesis; 1 .. #V - 1
    LaplacianOptions laplacian;
    /// true: L U = M U Lambda (4.2). false: L U = U Lambda (4.1), for comparison; bands then depend
    /// on how finely each region is triangulated.
    bool with_mass = true;
};

/// The first k Laplace-Beltrami eigenpairs of a mean shape. Immutable once built; shared freely
/// between threads. The n x n matrix X = U U' M of the thesis is never formed.
struct SpectralBasis {
    TriMesh mean_mesh;  ///< the mean shape P-bar and the triangles, mm
    Vector values;      ///< k, ascending, 1/mm^2 (1 without mass)
    Vector mass;        ///< #V, mm^2; ones without mass
    /// #V x k, row-major: a face is projected in one pass over memory. M-orthonormal.
    const double* vectors = nullptr;
    std::shared_ptr<const void> storage;
    std::string mass_kind;      ///< "mixed_voronoi", "barycentric" or "none"
    std::string negative_kind;  ///< "keep", "clamp" or "intrinsic_delaunay"

    Index num_vertices() const { return mean_mesh.vertices.rows(); }
    Index num_modes() const { return values.size(); }
};

std::shared_ptr<const SpectralBasis> build_spectral_basis(const TriMesh& mean_mesh,
                                                          const SpectralBasisOptions& options,
                                                          const Context& context);

/// safetensors, kind "mien-spectral-basis", format 1: mean f64, triangles u32, values, mass f64,
/// vectors f64 [#V, k]. The vectors stay in the mapped file.
std::shared_ptr<const SpectralBasis> load_spectral_basis(const std::string& path,
                                                         const SafetensorsReadOptions& options,
                                                         const Context& context);
void save_spectral_basis(const std::string& path, const SpectralBasis& basis,
                         const Context& context);

/// Coefficients U' M field of the first `count` modes (count x 3). O(#V count).
Matrix project(const SpectralBasis& basis, const PointsRef& field, Index count,
               const Context& context);
/// U coefficients for modes [first, first + coefficients.rows()). O(#V count).
Points synthesise(const SpectralBasis& basis, const Matrix& coefficients, Index first,
                  const Context& context);

/// Displacements of a face from the mean in bands: limits k_1 < k_2 < ... give bands [0, k_1),
/// [k_1, k_2), ..., and the last one is all that is left, so the bands add up to the displacement
/// to rounding. Throws Status::mismatch for another vertex count, invalid_argument for limits that
/// do not ascend or exceed the basis.
std::vector<Points> split_bands(const SpectralBasis& basis, const PointsRef& face,
                                const std::vector<Index>& limits, const Context& context);
/// Mean + sum of the bands, each projected onto its own frequencies first (4.5): what an editor put
/// into a band that does not belong there is dropped.
Points merge_bands(const SpectralBasis& basis, const std::vector<Points>& bands,
                   const std::vector<Index>& limits, const Context& context);

/// (4.11): the mean moved by the low, and by the high frequencies of the face.
Points low_band(const SpectralBasis& basis, const PointsRef& face, Index k, const Context& context);
Points high_band(const SpectralBasis& basis, const PointsRef& face, Index k,
                 const Context& context);
/// (4.15), (5.10): X low + (I - X) high for two whole faces. k = 0 gives `high`, k >= #V gives
/// `low`.
Points assemble(const SpectralBasis& basis, const PointsRef& low, const PointsRef& high, Index k,
                const Context& context);

/// Gains on the bands of a face: 0 removes a band (smooths), 1 keeps it, more exaggerates it.
Points edit_bands(const SpectralBasis& basis, const PointsRef& face,
                  const std::vector<Index>& limits, const Vector& gains, const Context& context);
/// (4.16) in the linear setting: each band moved from a towards b by its own weight; weights 1 and
/// 0 exchange the detail of two faces.
Points mix_bands(const SpectralBasis& basis, const PointsRef& a, const PointsRef& b,
                 const std::vector<Index>& limits, const Vector& weights, const Context& context);

}  // namespace mien
