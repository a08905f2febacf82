// Stage 5, gap: a smooth field along the normals closes what the modes cannot span.
//
//   minimise  sum_i w_i (r_i - delta_i)^2 + alpha |L delta|^2 + e |delta|^2,   x_i += delta_i n_i
//
// r_i the signed gap along the normal, w_i its robust weight, L the graph Laplacian (umbrella) of
// the template. alpha spreads the scanner's noise over neighbours instead of following it; the
// small e decides where nothing is seen. Rounds fit what the rounds before left (twicing; Tukey,
// Exploratory data analysis, 1977): a hill that the modes do not know, a swelling or an injection,
// is beyond the robust scale at first and rises from its foot to its top, round by round.
#pragma once

#include "mesh/adjacency.hpp"
#include "registration/fit.hpp"
#include "registration/gap_field.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct GapSettings {
    bool enabled = true;  ///< [A]
    GapFieldSettings field;
    double robust_sigmas = 2;  ///< > 0: robust scale in the fit's last noise levels [J]
    double reach = 4;          ///< > 0, robust scales: farther hits are not looked for [J]
    double max_step_mm = 3;    ///< mm, > 0: cap of the field in one round [J]
    int rounds = 6;            ///< >= 1: closest points are found anew in each [T] "An injection"
    // Turns that the field makes
    bool undo_turns = true;    ///< [A]
    double turn_cosine = 0.5;  ///< a triangle turned farther (60 degrees) goes back [J]
    double turn_ramp = 0.1;    ///< > 0, cosine: to both sides, where it goes back by a share [J]
    int undo_rounds = 6;       ///< >= 1 [J]
};

struct GapState {
    Points places;     ///< #V x 3, scan frame
    Vector weight;     ///< #V of the last round; empty when the stage is switched off
    Index undone = 0;  ///< turned triangles that went back, of all rounds
};

/// `sigma_mm`: the fit's last noise level. Throws Status::no_solution when the field is not finite.
GapState close_gap(const DeformationModel& model, const ScanView& scan, const PriorState& prior,
                   const FitState& state, const VertexRings& rings,
                   const CorrespondenceSettings& match, double sigma_mm,
                   const GapSettings& settings, const Context& context);

/// The field alone. Moves `places` (#V x 3, scan frame). `trust`, per vertex in [0, 1], multiplies
/// the weights. Returns the weights of the last round, #V.
Vector raise_field(const ScanView& scan, const Triangles& triangles, const VertexRings& rings,
                   const Vector& trust, const CorrespondenceSettings& match, double robust_scale_mm,
                   const GapSettings& settings, Points& places, const Context& context);

/// Where the field turned a triangle against `before`, its corners (and, when that is not enough,
/// their neighbours) go back there. Lids that close and lips that press fold against the template
/// by right, so the shape before the field is the judge and not the template. About the limit they
/// go back by a share: at a hard cut rounding decides. Returns the number of turned triangles, of
/// all rounds.
Index undo_turns(const Points& before, const Triangles& triangles, const VertexRings& rings,
                 const GapSettings& settings, Points& places);

}  // namespace mien
