#include "registration/fit.hpp"

namespace mien {

LoopSettings loop_for(const FitSettings& settings, bool is_free) {
    LoopSettings loop = settings.loop;
    if (is_free) {
        loop.evidence.surface.weight = settings.free.surface_weight;
        loop.evidence.color.weight = settings.free.color_weight;
    }
    return loop;
}

FitOutcome fit_surface(const DeformationModel& model, const PriorState& prior,
                       const StartState& start, const FitSettings& settings,
                       const Context& context) {
    const FitProblem problem{model, start.scan, prior.inner, prior.colors, start.held};
    FitOutcome outcome{start.state, {}};
    outcome.trace = run_fit(problem, prior.freedom, loop_for(settings, start.is_free()),
                            outcome.state, context);
    return outcome;
}

}  // namespace mien
