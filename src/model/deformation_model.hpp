// How a template may move: u(x) = sum_j basis(x, j) a_j + mean(x), a_j ~ N(0, I3) for each scalar
// mode j (the kernel is k(x, x') I3, so one scalar column serves x, y and z), plus, when trained on
// faces, vector modes of their own: u += pca_modes c, c ~ N(0, I).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/safetensors.hpp"
#include "mesh/tri_mesh.hpp"

namespace mien {

/// Of DeformationModel::info: pca_left_out_mm.
inline constexpr const char* kLeftOutInfo = "pca_left_out_mm";

/// Column-major float matrix that may lie in a mapped file.
struct FloatMatrixView {
    const float* data = nullptr;
    Index rows = 0, cols = 0;
    Eigen::Map<const Eigen::MatrixXf> map() const { return {data, rows, cols}; }
};

/// Immutable once built or loaded; shared freely between threads. Millimetres.
struct DeformationModel {
    TriMesh template_mesh;
    FloatMatrixView basis;     ///< #V x r, columns scaled by sqrt(lambda_j), strongest first
    Vector eigenvalues;        ///< r, lambda_j of the kernel operator, descending
    Points mean_displacement;  ///< #V x 3 or empty (zero)
    FloatMatrixView
        pca_modes;  ///< 3#V x p (x0 y0 z0 x1 ...), scaled by their deviations; p may be 0
    /// mm per axis: what the trained modes leave of people left out of the training
    /// (point_distribution.hpp); 0: not known, as in older files.
    double pca_left_out_mm = 0;
    /// r x 3 or empty (ones): a_j ~ N(0, diag(row j)). Only models built with a preference for
    /// mirror symmetry have it; treating it as ones is still a valid, less informed prior.
    Matrix prior_variance;
    std::vector<Landmark> landmarks;
    std::vector<Zone> zones;
    /// #V, 1 on walls that no scanner sees (template_walls.hpp), and what they were found by; empty
    /// in models of files before 0.2, for which they are found in each fit.
    std::vector<std::uint8_t> walls;
    std::string walls_key;
    std::map<std::string, std::string> info;  ///< kernel, sigma_mm, scale_mm, seed, rank, ...
    std::shared_ptr<const void> storage;      ///< keeps basis and pca_modes alive

    Index num_vertices() const { return template_mesh.vertices.rows(); }
    Index num_scalar_modes() const { return basis.cols; }  ///< 3 times as many deformation modes
};

/// safetensors, kind "mien-deformation-model", format 1. The basis stays in the mapped file.
std::shared_ptr<const DeformationModel> load_deformation_model(
    const std::string& path, const SafetensorsReadOptions& options, const Context& context);
/// The same from an opened file or a view of memory; what the model borrows stays alive with it.
std::shared_ptr<const DeformationModel> read_deformation_model(const SafetensorsFile& file);
void save_deformation_model(const std::string& path, const DeformationModel& model,
                            const Context& context);

}  // namespace mien
