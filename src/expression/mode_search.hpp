// How many modes an expression model should have, by hold-out over its training people.
//
// Too few modes leave a part of every face to the noise, where an expression and a person are told
// apart by chance; too many fit what the training people alone share. Each pair of counts is
// cross-validated as the noise level is (noise.hpp): identity modes and prior are learned without a
// fold of the people, whose faces are then neutralized. The smallest pair whose error is within
// `least_gain` of the least wins: modes cost time and memory in every fit.
//
// Joint PCA finds the subspaces of every pair, whatever method trains the model afterwards: how
// many directions the people have is a matter of the data.
#pragma once

#include <vector>

#include "base/context.hpp"
#include "expression/column_source.hpp"
#include "expression/joint_span.hpp"
#include "expression/prior.hpp"

namespace mien {

struct ModeSearch {
    /// Counts that are tried, of both kinds alike as far as there are so many; ascending, 1 to
    /// 4000. Up to 100: a fit with 100 + 100 modes takes twice as long as one with 50 + 50.
    std::vector<Index> counts = {25, 50, 75, 100};
    double least_gain = 0.02;  ///< of the held-out error, 0 to 1, that more modes must bring
};

struct TriedModes {
    Index identity = 0, expression = 0;
    double held_out_mm = 0.0;  ///< root mean square error of the mixture, mean over the faces
};

struct ModeChoice {
    Index identity_modes = 0, expression_modes = 0;
    std::vector<TriedModes> tried;  ///< empty for fewer than 4 people: the largest count up to 50
};

/// The counts that are 0 are searched, others stay. Deterministic; the same bits for any thread
/// count. Throws Status::invalid_argument (a search without counts, or out of range), cancelled.
/// One joint PCA and one estimate_noise() per pair.
ModeChoice choose_modes(const Context& context, const ColumnSource& source, const JointSpan& span,
                        Index identity_modes, Index expression_modes, const PriorOptions& prior,
                        const ModeSearch& search);

}  // namespace mien
