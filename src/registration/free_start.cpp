#include "registration/free_start.hpp"

#include <algorithm>
#include <cmath>

#include "base/scalar_math.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// 0 to 1, and what the colours add.
double agreement(const FitProblem& problem, const OpeningSettings& settings,
                 const CorrespondenceSettings& match, const FitState& state,
                 const Context& context) {
    const Points& rest = problem.model.template_mesh.vertices;
    std::vector<SurfaceHit> hits;
    problem.scan.tree().closest(state.places, settings.reach * settings.scale_mm, hits, context);
    const Points normals = vertex_normals(state.places, problem.model.template_mesh.triangles);
    Index tip;
    rest.col(2).maxCoeff(&tip);
    double sum = 0;
    Index counted = 0;
    for (Index i = 0; i < rest.rows(); ++i) {
        const std::size_t v = static_cast<std::size_t>(i);
        if (problem.inner[v] || (rest.row(i) - rest.row(tip)).norm() > settings.radius_mm) continue;
        ++counted;
        if (!hits[v].valid() || problem.scan.surface().at_border(hits[v])) continue;
        const double cosine = normals.row(i).dot(problem.scan.normal_at(hits[v]).transpose());
        if (cosine > 0)
            sum += std::pow(cosine, 4) * std::exp(-0.5 * hits[v].squared_distance /
                                                  (settings.scale_mm * settings.scale_mm));
    }
    if (counted == 0) return 0;
    const std::vector<ColorAgreement> features =
        problem.colors.agreements(problem.scan, state.places, normals, match, context);
    double colors = 0;
    for (const ColorAgreement& feature : features)
        colors += feature.correlation / static_cast<double>(features.size());
    return sum / static_cast<double>(counted) + settings.color_share * colors;
}

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

// Puts into `rough` the opening that agrees with the scan clearly better than what the approach
// found, all under the same prior.
void try_openings(const FitProblem& problem, const PriorState& prior, const LoopSettings& fit,
                  const ApproachSettings& approach, const OpeningSettings& settings,
                  const FitState& start, FitState& rough, const Context& context,
                  const Context& quiet) {
    if (open_jaw(problem.model, start, 0, settings.jaw).empty()) return;
    const LoopSettings loop = opening_loop(fit, approach, settings);
    const Index modes = std::min<Index>(start.coefficients.kernel.rows(), settings.scalar_modes);
    const double amplitude = prior.amplitude_given ? 1 : settings.amplitude;
    FitState trial = rough;
    trial.coefficients.kernel.conservativeResizeLike(Eigen::MatrixXf::Zero(modes, 3));
    trial.kernel_amplitude *= amplitude;
    run_fit(problem, prior.freedom, loop, trial, quiet);
    double best = agreement(problem, settings, fit.match, trial, context) + settings.clearly;
    double done = 0;
    for (const double opening_deg : settings.openings_deg) {
        trial = rough_state(start, modes, 0);
        trial.kernel_amplitude *= amplitude;
        fit_pins(problem.model,
                 open_jaw(problem.model, trial, opening_deg * kRadiansPerDegree, settings.jaw),
                 prior.freedom, settings.pins, trial, quiet);
        run_fit(problem, prior.freedom, loop, trial, quiet);
        context.progress(Stage::alignment, 0.94 + 0.05 * ++done / settings.openings_deg.size());
        const double agrees = agreement(problem, settings, fit.match, trial, context);
        context.log(LogLevel::debug, "jaw opened by %.0f degrees: agreement %.4f", opening_deg,
                    agrees);
        if (agrees <= best) continue;
        best = agrees;
        rough = trial;
        if (opening_deg == 0) rough.kernel_amplitude = start.kernel_amplitude;
    }
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
        try_openings(problem, prior, fit, approach, openings, state, rough, context, quiet);
    state.motion = rough.motion;
    state.places = std::move(rough.places);
    state.kernel_amplitude = rough.kernel_amplitude;
    state.coefficients.kernel.topRows(rough.coefficients.kernel.rows()) = rough.coefficients.kernel;
    state.coefficients.pca.head(p) = rough.coefficients.pca;
}

}  // namespace mien
