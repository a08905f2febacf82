// The neutral face of a face (J 4.15): fit identity and expression, take the expression's
// displacement away, and keep everything that the model does not explain:  neutral = v - Q b.
// The joint fit (joint_fit.hpp) of one face.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/fit.hpp"
#include "expression/joint_fit.hpp"
#include "expression/placed_fit.hpp"

namespace mien {

struct NeutralizeOptions {
    FitOptions fit;
    Pose pose = Pose::automatic;
    bool uncertainty = false;  ///< compute the deviation per vertex
    /// Vertices where the person may have changed (a treated zone): no witness of the expression,
    /// which there is what it is elsewhere.
    std::vector<std::uint32_t> treated;
};

struct NeutralizationResult {
    Points neutral_vertices;                      ///< #V x 3 of the input, mm
    Vector identity, expression;                  ///< coordinates, mm along the unit modes
    std::vector<double> component_probabilities;  ///< of model.components; mixture only
    double intensity = 1.0;  ///< expected share of the likeliest expression that is shown
    /// Root of the summed posterior variance of a vertex's three coordinates, mm: of the expression
    /// that was taken off where the vertex was seen, of the whole person where its weight is zero;
    /// empty unless asked for, or for fits without a prior.
    Vector uncertainty_mm;
    double mean_displacement_mm = 0, max_displacement_mm = 0, rms_displacement_mm = 0;
    double unseen_share = 0;        ///< of the vertices: those of weight zero
    double rms_uncertainty_mm = 0;  ///< of the displacement, over all vertices; 0 without a prior
    Similarity pose;                ///< training frame -> frame of the face
    double residual_rms_mm = 0;     ///< distance of the face from the fitted model per vertex
    double noise_mm2 = 0;  ///< noise variance that was used; above the model's for faces that were
                           ///< measured worse than the training faces all over; 0 without a prior
    double doubted_share = 0;  ///< of the weights: taken away from vertices that nothing explains
    int sweeps = 0;
    bool converged = true;
};

/// `vertices` in the model's topology. The result lies in the frame of the input. Weights per
/// vertex (>= 0; zero: no data there) or empty. A vertex of weight zero still moves with the model.
/// Throws Status::mismatch, invalid_mesh, invalid_argument, no_solution. O(#V (p+q)).
NeutralizationResult neutralize(const Context& context, const ExpressionModel& model,
                                const PointsRef& vertices, const Vector& weights_per_vertex,
                                const NeutralizeOptions& options);

/// What speaks against trusting a result, in sentences; empty: nothing.
std::vector<std::string> neutralization_warnings(const ExpressionModel& model,
                                                 const NeutralizationResult& result);

/// Throws Status::mismatch unless a mesh of so many vertices with these triangles is in the model's
/// topology. Without triangles (0 rows) only the vertex count is held against the model.
void check_topology(const ExpressionModel& model, Index num_vertices,
                    const TrianglesRef& triangles);

/// mean + P (identity coordinates) + Q (expression coordinates), with the model's spill for
/// coordinates of fits with a prior; empty vectors for none.
Points synthesize_face(const Context& context, const ExpressionModel& model, const Vector& identity,
                       const Vector& expression, FitMethod method = FitMethod::mixture);

/// 3#V, what an expression's coordinates move.
Vector expression_displacement(const Context& context, const ExpressionModel& model,
                               const Vector& expression, FitMethod method = FitMethod::mixture);

}  // namespace mien
