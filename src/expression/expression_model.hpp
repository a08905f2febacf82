// What a trained expression model holds: two subspaces, one for who a person is and one for what
// the face does, and what is known about the coordinates in each (J 4.13):
//     v = mean + P a + Q b + rest,   a ~ N(0, diag(identity deviations^2)),
// with a spill between the two where they were trained to be orthogonal (mode_spill.hpp),
// and b from a mixture: a face shows one of a few expressions, so every trained expression has a
// mean and a covariance of its own, next to "neutral" (b near zero) and "any" (the broad Gaussian
// over all expressions, for what was never trained). A wide mouth smiles widely: the mean of an
// expression moves linearly with the identity. The last columns of P may be smooth directions that
// the training people did not show (smooth_identity.hpp); a is then N(0, C) with a full C. The
// thesis keeps the people's P and Q only.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/safetensors.hpp"
#include "base/types.hpp"
#include "expression/mode_spill.hpp"

namespace mien {

/// Column-major float matrix that may lie in a mapped file. Rows run x0 y0 z0 x1 ..., so that a
/// column is a displacement of all vertices.
struct ModesView {
    const float* data = nullptr;
    Index rows = 0, cols = 0;
    Eigen::Map<const Eigen::MatrixXf> map() const { return {data, rows, cols}; }
};

/// One part of the expression prior, in coordinates of the expression modes.
struct ExpressionComponent {
    std::string name;     ///< an expression's name, "neutral" or "any"
    double weight = 1.0;  ///< prior probability, up to a common factor
    Vector mean;          ///< q, mm along the unit modes
    Matrix covariance;    ///< q x q, positive definite, mm^2: of what mean and person leave open
    /// q x r, mm per mm: how the mean moves with the person, mean + follows * (first r identity
    /// coordinates); empty: the same for everybody.
    Matrix follows;
};

struct FitPlan;

/// Immutable once trained or loaded; shared freely between threads. Millimetres.
struct ExpressionModel {
    Points mean;                 ///< #V x 3, the mean neutral face
    Triangles triangles;         ///< #F x 3
    ModesView identity_modes;    ///< P, 3#V x p, orthonormal columns
    ModesView expression_modes;  ///< Q, 3#V x q, orthonormal columns
    Vector identity_deviations;  ///< p, standard deviation of the coordinate of each mode, mm
    /// p x p, of all coordinates together, mm^2; empty: the squared deviations, independent.
    Matrix identity_covariance;
    Index smooth_modes = 0;  ///< the last identity modes: no person's, the prior's alone
    /// The model without smooth modes, with its own noise: of the thesis' fits, and of several
    /// faces of one person, who tell by themselves what is hers. Null where there are no smooth
    /// modes.
    std::shared_ptr<const ExpressionModel> people;
    Vector expression_deviations;  ///< q, root mean square of the coordinate of each mode, mm
    Matrix gram;                   ///< (p+q) x (p+q), [P Q]' [P Q]
    ModeSpill spill;               ///< empty for joint PCA
    std::vector<ExpressionComponent> components;
    /// How strongly an expression may be shown, shares of its mean, above 0: each trained component
    /// is tried at each of them (fit.hpp). {1}: at full strength only.
    std::vector<double> intensities = {1.0};
    /// Variance of one coordinate of what the modes do not explain, as the fits use it, mm^2.
    /// Larger than the plain residual, since that residual is smooth over the face (noise.hpp).
    double map_noise_mm2 = 30.0, mixture_noise_mm2 = 100.0;
    /// Distance from the fitted model per vertex, root mean square, that 95 % of new people's faces
    /// stay under, mm; 0: not known. A face farther off was measured worse than the training faces.
    double expected_residual_mm = 0.0;
    /// Vertices that every face is rigidly aligned on before it is fitted (posture); may be empty.
    std::vector<std::uint32_t> stable_vertices;
    std::vector<std::string> expression_names;  ///< of the training set
    std::map<std::string, std::string> info;    ///< method, lambda, subjects, faces, ...
    std::shared_ptr<const void> storage;        ///< keeps the modes alive
    std::shared_ptr<const FitPlan> plan;        ///< factorisations for unweighted faces (fit.hpp)

    Index num_vertices() const { return mean.rows(); }
    Index num_identity_modes() const { return identity_modes.cols; }
    Index num_expression_modes() const { return expression_modes.cols; }
    /// Identity modes that the training people showed; the thesis' fits know these alone.
    Index num_people_modes() const { return identity_modes.cols - smooth_modes; }
    /// p x p, the inverse of the coordinates' covariance. Throws Status::corrupt. O(p^3).
    Matrix identity_precision() const;
};

/// What a fit of several faces works with: `people`, or the model itself.
inline const ExpressionModel& people_of(const ExpressionModel& model) {
    return model.people != nullptr ? *model.people : model;
}

/// What a model without its smooth modes is measured with.
struct PeopleLevels {
    double map_noise_mm2 = 0, mixture_noise_mm2 = 0;
    double residual_mm = 0;  ///< expected_residual_mm
};
/// Makes `people` of a whole model with smooth modes.
void put_people(ExpressionModel& model, const PeopleLevels& levels);

/// Checks shapes, ranges and definiteness, and computes `plan`. Every maker of a model calls it
/// last. Throws Status::corrupt naming the part that is wrong.
void finish_expression_model(ExpressionModel& model);

/// safetensors, kind "mien-expression-model", format 1. The modes stay in the mapped file. Errors
/// of SafetensorsFile, and Status::corrupt for numbers that are no model.
std::shared_ptr<const ExpressionModel> load_expression_model(const std::string& path,
                                                             const SafetensorsReadOptions& options,
                                                             const Context& context);
/// The same from an opened file or a view of memory; what the model borrows stays alive with it.
std::shared_ptr<const ExpressionModel> read_expression_model(const SafetensorsFile& file);
void save_expression_model(const std::string& path, const ExpressionModel& model,
                           const Context& context);

/// First 16 hex digits of the SHA-256 of the vertex count and the triangles: two meshes with the
/// same value have the same topology.
std::string topology_hash(Index num_vertices, const TrianglesRef& triangles);

}  // namespace mien
