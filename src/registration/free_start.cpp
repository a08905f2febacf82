#include "registration/free_start.hpp"

#include <algorithm>

namespace mien {
namespace {

// The fit's own settings with all rounds rough, down to the noise level that the fit begins with.
LoopSettings rough_loop(const LoopSettings& fit, const ApproachSettings& approach) {
    LoopSettings rough = fit;
    rough.sigma_end_mm = fit.sigma_start_mm;
    rough.sparse_share = 2;
    rough.sparse_stride = approach.stride;
    return rough;
}

LoopSettings approach_loop(const LoopSettings& fit, const ApproachSettings& approach) {
    LoopSettings loop = rough_loop(fit, approach);
    loop.sigma_start_mm = approach.sigma_mm;
    loop.rounds = approach.rounds;
    loop.evidence.surface.weight = approach.weight;
    loop.evidence.surface.tangential = approach.tangential;
    return loop;
}

LoopSettings opening_loop(const LoopSettings& fit, const ApproachSettings& approach,
                          const OpeningSettings& openings) {
    LoopSettings loop = rough_loop(fit, approach);
    loop.sigma_start_mm = openings.sigma_mm;
    loop.rounds = openings.rounds;
    loop.evidence.surface.tangential = openings.tangential;
    return loop;
}

// Few modes, all of them at rest.
FitState rough_state(const FitState& state, Index scalar_modes, Index pca_modes) {
    FitState rough;
    rough.motion = state.motion;
    rough.kernel_amplitude = state.kernel_amplitude;
    rough.coefficients.kernel.setZero(scalar_modes, 3);
    rough.coefficients.pca.setZero(pca_modes);
    return rough;
}

}  // namespace

void start_freely(const FitProblem& problem, const PriorState& prior, const LoopSettings& fit,
                  const ApproachSettings& approach, const OpeningSettings& openings,
                  FitState& state, const Context& context) {
    const Index p = std::min<Index>(state.coefficients.pca.size(), approach.pca_modes);
    const Index r =
        p > 0 ? 0 : std::min<Index>(state.coefficients.kernel.rows(), approach.scalar_modes);
    FitState rough = rough_state(state, r, p);
    Context quiet = context;  // fits report a stage that is still to come
    quiet.progress_function = nullptr;
    run_fit(problem, prior.freedom, approach_loop(fit, approach), rough, quiet);
    context.progress(Stage::alignment, 0.93);
    if (p == 0 && openings.enabled)
        search_jaw(problem, prior, opening_loop(fit, approach, openings), openings, state, rough,
                   context);
    state.motion = rough.motion;
    state.places = std::move(rough.places);
    state.kernel_amplitude = rough.kernel_amplitude;
    if (rough.kernel_mean.rows() > 0) {
        state.kernel_mean.setZero(state.coefficients.kernel.rows(), 3);
        state.kernel_mean.topRows(rough.kernel_mean.rows()) = rough.kernel_mean;
    }
    state.coefficients.kernel.topRows(rough.coefficients.kernel.rows()) = rough.coefficients.kernel;
    state.coefficients.pca.head(p) = rough.coefficients.pca;
}

}  // namespace mien
