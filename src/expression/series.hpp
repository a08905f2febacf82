// Several scans of one person (B4): one identity, an expression each.
//
//     v_k = mean + P a + d + Q b_k + e_k,   d ~ N(0, s I) shared,   e_k ~ N(0, t I / w_k)
//
// d is what the identity modes miss of this person (s, the model's noise level): it is the same in
// every scan, so differences between scans tell the expressions apart without it. With d integrated
// out, the scans couple at every vertex through the K x K precision
//     C = diag(w)/t - w w' / (t^2 (1/s + sum(w)/t)),
// and (a, b_1 .. b_K) solve one symmetric system. Each scan's mixture component is chosen by
// coordinate ascent on the joint evidence, starting from the scans' own fits.
//
// In a zone where the identity may change between the scans (a treated zone) the variance of e_k
// rises by the square of the change that is expected times the number of vertices (they change
// together), so that the change is not taken for an expression.
#pragma once

#include <string>
#include <vector>

#include "base/context.hpp"
#include "expression/expression_model.hpp"
#include "expression/neutralize.hpp"

namespace mien {

struct SeriesScan {
    Points vertices;  ///< in the model's topology
    Vector weights;   ///< per vertex or empty; 0: no data there, the vertex may hold anything
};

struct SeriesOptions {
    FitMethod method = FitMethod::mixture;  ///< or map
    Pose pose = Pose::automatic;
    double noise_mm2 = 0.0;          ///< s; 0: the model's
    double scan_noise_share = 0.01;  ///< t / s, > 0: what differs between scans beyond the model
    std::vector<std::uint32_t> changing_zone;  ///< vertices whose identity may change
    double expected_change_mm = 5.0;           ///< there, > 0
};

struct SeriesResult {
    Points identity_vertices;  ///< the person's neutral face: mean of the scans' neutrals
    std::vector<Points> neutral_vertices;  ///< per scan, in its own frame; where a scan has no
                                           ///< finite vertex, the shared face's
    Vector identity;                      ///< a
    std::vector<Vector> expressions;      ///< b_k
    std::vector<std::string> components;  ///< name of each scan's mixture component; map: empty
    std::vector<Similarity> poses;        ///< training frame -> frame of the scan
    std::vector<double> residuals_mm;     ///< distance of each scan from its own fit per vertex
    /// Root mean square distance of each scan's neutral face from the shared one, changing zone
    /// left out, mm.
    std::vector<double> distances_mm;
};

/// Throws as neutralize(); Status::invalid_argument for no scan or fits without a prior.
/// O(K #V (p+q)) and a system of p + K q unknowns; with weights or a zone O(K^2 #V (p+q)^2) more.
SeriesResult neutralize_series(const Context& context, const ExpressionModel& model,
                               const std::vector<SeriesScan>& scans, const SeriesOptions& options);

/// What speaks against trusting scan `k` of a series, in sentences; empty: nothing.
std::vector<std::string> series_warnings(const ExpressionModel& model, const SeriesResult& result,
                                         std::size_t k);

}  // namespace mien
