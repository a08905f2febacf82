// From a template and kernels to a deformation model: control points, kernel columns, low-rank
// basis.
#pragma once

#include <memory>
#include <vector>

#include "base/context.hpp"
#include "geometry/heat_method.hpp"
#include "model/deformation_model.hpp"
#include "model/kernel.hpp"
#include "model/low_rank.hpp"
#include "model/point_distribution.hpp"

namespace mien {

struct ModelOptions {
    // Named, so that they can be told without the allocation that `kernels` makes.
    static constexpr Index kNumModes = 999;
    static constexpr double kEigenvalueThreshold = 1e-4;

    std::vector<KernelTerm> kernels =
        std::vector<KernelTerm>(1);  ///< summed; may be empty beside pca_faces
    /// Borrowed, or null: registered faces for a mean and principal modes on top of the kernel,
    /// whose scale_mm is then the deviation of what the faces do not explain. Without kernels:
    /// those alone.
    const FaceDataset* pca_faces = nullptr;
    PcaOptions pca;
    Index num_modes = kNumModes;   ///< deformation modes at most; 3 make one scalar mode
    double tolerance = 0;          ///< > 0: stop when this share of the variance is left
    Index num_control_points = 0;  ///< 0: max(1000, num_modes), never more than #V
    double eigenvalue_threshold =
        kEigenvalueThreshold;       ///< of the kernel's block among the control points, relative
    Vector scale_per_vertex;        ///< empty, or #V factors >= 0 of the displacement's deviation
    bool mirror_symmetric = false;  ///< modes purely even or odd about the plane x = 0
    double mirror_correlation = 0;  ///< 0 .. 1: how much both sides are expected to move alike
    HeatOptions heat;
};

struct BuiltModel {
    std::shared_ptr<const DeformationModel> model;
    LowRankReport report;
};

/// Deterministic: same inputs, same bits, for any thread count. Throws Status::invalid_mesh for a
/// template without vertices or (surface kernels) triangles, invalid_argument for options out of
/// range and for landmarks or zones that name vertices the template has not. Progress stages:
/// training, geodesics, basis. Memory about 20 bytes x #V x control points.
BuiltModel build_deformation_model(const TriMesh& template_mesh,
                                   const std::vector<Landmark>& landmarks,
                                   const std::vector<Zone>& zones, const ModelOptions& options,
                                   const Context& context);

/// A number as it stands in DeformationModel::info, shortest form that reads back the same.
std::string info_number(double value);

}  // namespace mien
