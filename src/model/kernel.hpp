// What makes two vertices move alike: scalar kernels k(x, x') of a deformation model, and sums of
// them. Every kernel is normalised so that its variance k(x, x) is scale_mm^2 (on average over the
// surface where it varies from place to place), so one prior scale serves all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/types.hpp"

namespace mien {

enum class KernelKind : std::int32_t {
    euclidean_se = 1,  ///< s^2 exp(-|x - x'|^2 / 2 sigma^2)            (2.18)
    geodesic_se = 2,  ///< s^2 exp(-geodesic(x, x')^2 / 2 sigma^2)     (2.19), not positive definite
    bspline = 3,      ///< cubic B-splines on a grid of sigma / 4       (2.15), (2.16)
    surface_matern = 4,  ///< Matern from Laplace-Beltrami eigenpairs, positive definite
};

/// One summand. sigma_mm is the length scale of the exponential kernels, the full width of the
/// spline of a B-spline kernel (four grid steps; the thesis writes 2^-sigma for the step), and
/// sqrt(2 nu) / kappa of a Matern kernel, the length scale usual in statistics.
struct KernelTerm {
    KernelKind kind = KernelKind::geodesic_se;
    double sigma_mm = 20;  ///< > 0
    double scale_mm = 1;   ///< standard deviation of a displacement's coordinate, > 0
    double nu = 2;         ///< smoothness of a Matern kernel, 0.1 .. 20
};

/// The name used in files, options and messages ("geodesic-se"); Status::internal for no kernel.
const char* kernel_name(KernelKind kind);
/// Throws Status::invalid_argument listing the known names.
KernelKind kernel_from_name(const std::string& name);
/// Throws Status::invalid_argument unless every number is in its range and there is a term.
void check_kernels(const std::vector<KernelTerm>& terms);

/// Multiscale sum (2.17): sigma, 2 sigma, 4 sigma, ... with weights doubling alike; the scales are
/// normalised so that the sum keeps the variance of the given term. levels 1 .. 12.
std::vector<KernelTerm> multiscale(const KernelTerm& finest, int levels);

/// (2.16): the cubic B-spline.
double cubic_bspline(double x);

}  // namespace mien
