// The search for a kernel's settings (2.6.1): for each sigma, and each scale and number of levels
// that is asked for, fit faces whose correspondence is known and look at what is left. y = face -
// template, alpha = argmin |y - A alpha|^2 + rho |alpha|^2 (2.38)-(2.39), residual |y - A alpha|,
// averaged over the faces.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "mesh/dataset.hpp"
#include "mesh/tri_mesh.hpp"
#include "model/kernel_blocks.hpp"
#include "model/low_rank.hpp"

namespace mien {

struct TuneOptions {
    KernelTerm kernel;  ///< its sigma is replaced by each of `sigmas_mm`
    int levels = 1;
    std::vector<double> sigmas_mm;
    std::vector<double> scales_mm;  ///< each with each sigma; empty: the kernel's own alone
    std::vector<int> level_counts;  ///< each with each of those; empty: `levels` alone
    Index num_modes = 999;          ///< deformation modes
    double rho = 5;                 ///< >= 0
    std::vector<Index> faces;       ///< of the dataset; empty: all
    HeatOptions heat;
};

struct TunePoint {
    double sigma_mm = 0, scale_mm = 0;
    int levels = 1;
    double residual_mean = 0, residual_sd = 0;  ///< of |y - A alpha| over the faces, mm
    std::vector<double> residuals;              ///< per face
    LowRankReport report;
};

struct TuneReport {
    KernelTerm kernel;
    int levels = 1;
    double rho = 0;
    std::vector<Index> faces;
    std::vector<TunePoint> points;
    std::size_t best = 0;  ///< of the lowest mean; the first one on a tie
};

/// The grid in the order levels, scales, sigmas, the last running fastest; at most 10000 points.
/// Geodesic distances and eigenpairs are computed once for all of them. Faces may cover only the
/// first vertices of the template. Progress stage: fitting, after geodesics and basis.
TuneReport tune_kernel(const TriMesh& template_mesh, const FaceDataset& faces,
                       const TuneOptions& options, const Context& context);

/// Residuals of fits with known correspondence: displacements (#known x 3 each) in the span of the
/// basis' first rows.
std::vector<double> fit_residuals(const Eigen::MatrixXf& basis,
                                  const std::vector<Points>& displacements, double rho,
                                  const Context& context);

/// Faces with one of the expressions (none given: all) of the first max_subjects subjects in the
/// dataset's order (0: all). Throws Status::not_found for an expression the dataset has not,
/// invalid_argument when nothing is left.
std::vector<Index> select_faces(const FaceDataset& faces,
                                const std::vector<std::string>& expressions, Index max_subjects);

std::string tune_json(const TuneReport& report);

}  // namespace mien
