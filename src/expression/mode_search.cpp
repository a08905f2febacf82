#include "expression/mode_search.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "expression/joint_pca.hpp"
#include "expression/noise.hpp"

namespace mien {
namespace {

constexpr Index kFewestPeople = 4;     ///< below it nobody can be left out (noise.hpp)
constexpr Index kWithoutHoldOut = 50;  ///< modes where nobody can be left out
constexpr Index kMostModes = 4000;

void check_search(const ModeSearch& search) {
    const std::vector<Index>& counts = search.counts;
    if (counts.empty() || counts.front() < 1 || counts.back() > kMostModes ||
        !std::is_sorted(counts.begin(), counts.end()))
        fail(Status::invalid_argument,
             "the search for a number of modes needs ascending counts from 1 to %lld",
             static_cast<long long>(kMostModes));
    if (!(search.least_gain >= 0.0) || !(search.least_gain <= 1.0))
        fail(Status::invalid_argument, "least_gain is %g; give 0 to 1", search.least_gain);
}

/// The error of held-out people with so many modes. `tried` takes the counts that there really are.
double held_out_error(const Context& context, const ColumnSource& source, const JointSpan& span,
                      const PriorOptions& prior, TriedModes& tried) {
    JointPcaOptions options;
    options.identity_modes = tried.identity;
    options.expression_modes = tried.expression;
    const JointPca subspaces = joint_pca(context, span.neutrals, span.displacements, options);
    tried.identity = subspaces.identity.cols();
    tried.expression = subspaces.expression.cols();
    // Without the smooth prior, which is chosen for the modes that are found here.
    return estimate_noise(context, source, span, subspaces.expression,
                          subspaces.expression.transpose() * span.displacements, tried.identity,
                          prior, {})
        .mixture_error_mm;
}

}  // namespace

ModeChoice choose_modes(const Context& context, const ColumnSource& source, const JointSpan& span,
                        Index identity_modes, Index expression_modes, const PriorOptions& prior,
                        const ModeSearch& search) {
    check_search(search);
    if (identity_modes < 0 || expression_modes < 0)
        fail(Status::invalid_argument, "a number of modes is negative; give 0 for a search");
    const Index people = source.num_neutrals(), faces = source.num_displacements();
    ModeChoice choice;
    const auto pair_of = [&](Index count) {
        TriedModes pair;
        // The mean takes one direction of the people.
        pair.identity =
            identity_modes > 0 ? identity_modes : std::min(count, std::max<Index>(1, people - 1));
        pair.expression = expression_modes > 0 ? expression_modes : std::min(count, faces);
        return pair;
    };
    if (people < kFewestPeople) {
        const TriedModes pair = pair_of(kWithoutHoldOut);
        choice.identity_modes = pair.identity;
        choice.expression_modes = pair.expression;
        return choice;
    }
    for (const Index count : search.counts) {
        context.check_cancelled();
        TriedModes pair = pair_of(count);
        pair.held_out_mm = held_out_error(context, source, span, prior, pair);
        const auto same = [&](const TriedModes& other) {
            return other.identity == pair.identity && other.expression == pair.expression;
        };
        if (std::none_of(choice.tried.begin(), choice.tried.end(), same))
            choice.tried.push_back(pair);
    }
    double least = std::numeric_limits<double>::infinity();
    for (const TriedModes& pair : choice.tried) least = std::min(least, pair.held_out_mm);
    const auto near_least = [&](const TriedModes& pair) {
        return pair.held_out_mm * (1.0 - search.least_gain) <= least;
    };
    const TriedModes& best = *std::find_if(choice.tried.begin(), choice.tried.end(), near_least);
    choice.identity_modes = best.identity;
    choice.expression_modes = best.expression;
    return choice;
}

}  // namespace mien
