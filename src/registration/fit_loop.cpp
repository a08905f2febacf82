#include "registration/fit_loop.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/normals.hpp"

namespace mien {
namespace {

// About one vertex in `stride`, spread by a hash of the index, and every pinned vertex; ascending.
std::vector<Index> choose_rows(Index num_vertices, Index stride, const std::vector<Pin>& pins) {
    constexpr std::uint32_t kKnuth = 2654435761u;  // 2^32 over the golden ratio
    std::vector<std::uint8_t> take(static_cast<std::size_t>(num_vertices), 0);
    for (std::size_t i = 0; i < take.size(); ++i)
        take[i] =
            ((static_cast<std::uint32_t>(i) * kKnuth) >> 16) % static_cast<std::uint32_t>(stride) ==
            0;
    for (const Pin& pin : pins) take[static_cast<std::size_t>(pin.vertex)] = 1;
    std::vector<Index> rows;
    for (std::size_t i = 0; i < take.size(); ++i)
        if (take[i]) rows.push_back(static_cast<Index>(i));
    return rows;
}

// The vertices that the rounds look at, and where each stands in the terms.
struct Rows {
    std::vector<Index> row_of, vertex_of;
    std::vector<std::uint8_t> inner;  // #rows, or empty: walls, which stand for no place of a scan
};

// Points the solver at every stride-th vertex (1: all).
Rows use_stride(const DeformationModel& model, Index stride, const std::vector<Pin>& pins,
                const FitCoefficients& coefficients, FitSolver& solver, const Context& context) {
    std::vector<Index> chosen;
    if (stride > 1) chosen = choose_rows(model.num_vertices(), stride, pins);
    solver.use_rows(chosen, coefficients.kernel.rows(), coefficients.pca.size(), context);
    Rows rows;
    rows.row_of.assign(static_cast<std::size_t>(model.num_vertices()), -1);
    rows.vertex_of.resize(static_cast<std::size_t>(solver.num_rows()));
    for (Index row = 0; row < solver.num_rows(); ++row) {
        rows.vertex_of[static_cast<std::size_t>(row)] = solver.vertex(row);
        rows.row_of[static_cast<std::size_t>(solver.vertex(row))] = row;
    }
    return rows;
}

Points pick_rows(const Points& points, const Rows& rows) {
    Points picked(static_cast<Index>(rows.vertex_of.size()), 3);
    for (Index row = 0; row < picked.rows(); ++row)
        picked.row(row) = points.row(rows.vertex_of[static_cast<std::size_t>(row)]);
    return picked;
}

void move_places(const DeformationModel& model, const FitSolver& solver, FitState& state,
                 const Context& context) {
    state.displacement = solver.displacement(state.coefficients, context);
    const Points shaped = model.template_mesh.vertices + state.displacement;
    state.places = state.motion.apply(PointsRef(shaped));
}

// Solves once and moves the state.
void solve_round(const DeformationModel& model, const Rows& rows, const FitTerms& terms,
                 const FitStepOptions& step, FitSolver& solver, FitState& state,
                 const Context& context) {
    const Points current = pick_rows(model.template_mesh.vertices + state.displacement, rows);
    const Similarity motion = solver.step(terms, current, step, state.coefficients, context);
    state.motion = compose(state.motion, motion);
    move_places(model, solver, state, context);
}

FitStepOptions step_options(const FitFreedom& freedom, const SolverSettings& solver,
                            const FitState& state) {
    FitStepOptions step;
    step.scalar_modes = state.coefficients.kernel.rows();
    step.pca_modes = state.coefficients.pca.size();
    step.kernel_ridge = 1 / (state.kernel_amplitude * state.kernel_amplitude);
    step.pca_ridge = 1 / (freedom.pca_amplitude * freedom.pca_amplitude);
    if (state.kernel_mean.rows() > 0) step.kernel_mean = &state.kernel_mean;
    step.move = freedom.move;
    step.scale = freedom.scale;
    step.solver = solver;
    return step;
}

// The filters at a noise level.
CorrespondenceSettings filters_at(const LoopSettings& settings, double sigma_mm) {
    CorrespondenceSettings match = settings.match;
    match.robust_scale_mm = settings.robust_factor * sigma_mm;
    match.max_distance_mm =
        std::min(settings.match.max_distance_mm, settings.reach * match.robust_scale_mm);
    return match;
}

// Weighted mean squared distance to the scan, mm^2.
double energy_of(const Correspondences& matches) {
    double energy = 0;
    for (Index row = 0; row < matches.weight.size(); ++row)
        if (matches.weight[row] > 0)
            energy +=
                matches.weight[row] * matches.hits[static_cast<std::size_t>(row)].squared_distance;
    return energy / std::max(1.0, matches.weight.sum());
}

// What changes from round to round of one fit.
struct Loop {
    FitSolver solver;
    std::vector<std::unique_ptr<EvidenceTerm>> evidence;
    Rows rows;
    Index stride = 0;
    Correspondences matches;
    FitTerms terms;
};

// One round at the noise level `sigma_mm`; returns the mean movement, mm.
double run_round(const FitProblem& problem, const LoopSettings& settings, double sigma_mm,
                 const FitStepOptions& step, Loop& loop, FitState& state, const Context& context) {
    const DeformationModel& model = problem.model;
    const CorrespondenceSettings match = filters_at(settings, sigma_mm);
    const Points normals = vertex_normals(state.places, model.template_mesh.triangles);
    find_correspondences(problem.scan, pick_rows(state.places, loop.rows),
                         pick_rows(normals, loop.rows), match, loop.matches, context,
                         loop.rows.inner);

    const Similarity to_model = state.motion.inverse();
    const EvidenceRound round{
        problem,      state, to_model, normals,    loop.rows.row_of, loop.rows.vertex_of,
        loop.matches, match, sigma_mm, loop.stride};
    loop.terms.reset(loop.solver.num_rows());
    for (const auto& term : loop.evidence) term->add(round, loop.terms, context);
    const Points before = state.places;
    solve_round(model, loop.rows, loop.terms, step, loop.solver, state, context);
    return (state.places - before).rowwise().norm().mean();
}

}  // namespace

Index modes_at(ModeGrowth growth, double f, Index first, Index all) {
    first = std::min(first, all);
    const double low = static_cast<double>(first), high = static_cast<double>(all);
    double modes = high;
    switch (growth) {
        case ModeGrowth::constant:
            break;
        case ModeGrowth::linear:
            modes = low + f * (high - low);
            break;
        case ModeGrowth::exponential:
            modes = low * std::pow(high / std::max(low, 1.0), f);
            break;
        case ModeGrowth::cubic:
            modes = low + f * f * f * (high - low);
            break;
    }
    return std::min(all, std::max(first, static_cast<Index>(std::lround(modes))));
}

FitTrace run_fit(const FitProblem& problem, const FitFreedom& freedom, const LoopSettings& settings,
                 FitState& state, const Context& context) {
    const DeformationModel& model = problem.model;
    Loop loop{FitSolver(model), make_evidence(problem, settings.evidence), {}, 0, {}, {}};
    FitStepOptions step = step_options(freedom, settings.solver, state);
    move_places(model, loop.solver, state, context);
    FitTrace trace;
    const int rounds = std::max(1, settings.rounds);
    for (int round = 0; round < rounds; ++round) {
        context.progress(Stage::fitting, static_cast<double>(round) / rounds);
        const double f = rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1;
        const double sigma_mm =
            settings.sigma_start_mm * std::pow(settings.sigma_end_mm / settings.sigma_start_mm, f);
        const Index wanted = f < settings.sparse_share ? settings.sparse_stride : 1;
        if (wanted != loop.stride) {
            loop.stride = wanted;
            loop.rows =
                use_stride(model, wanted, problem.pins, state.coefficients, loop.solver, context);
            for (std::size_t row = 0; row < loop.rows.vertex_of.size() && !problem.inner.empty();
                 ++row)
                loop.rows.inner.push_back(
                    problem.inner[static_cast<std::size_t>(loop.rows.vertex_of[row])]);
            loop.matches.hits.clear();
        }
        step.scalar_modes =
            modes_at(settings.growth, f, settings.first_modes, state.coefficients.kernel.rows());
        step.tolerance = f < 1 ? settings.tolerance : settings.last_tolerance * settings.tolerance;
        state.coefficients.kernel.bottomRows(state.coefficients.kernel.rows() - step.scalar_modes)
            .setZero();
        const double movement_mm =
            run_round(problem, settings, sigma_mm, step, loop, state, context);
        trace.energy.push_back(energy_of(loop.matches));
        trace.sigma_mm = sigma_mm;
        ++trace.rounds;
        context.log(LogLevel::debug,
                    "round %d: sigma %.3f mm, %lld modes, energy %.4f, moved %.4f mm, %d steps",
                    round, sigma_mm, static_cast<long long>(step.scalar_modes), trace.energy.back(),
                    movement_mm, loop.solver.iterations());
        if (f >= 1 && movement_mm < settings.stop_movement_mm) break;
    }
    trace.weight = loop.matches.weight;
    context.progress(Stage::fitting, 1);
    return trace;
}

void fit_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const FitFreedom& freedom, const PinFitSettings& settings, FitState& state,
              const Context& context) {
    FitSolver solver(model);
    const FitStepOptions step = step_options(freedom, settings.solver, state);
    move_places(model, solver, state, context);
    const Index stride = std::max<Index>(1, model.num_vertices() / settings.other_vertices);
    const Rows rows = use_stride(model, stride, pins, state.coefficients, solver, context);
    for (int round = 0; round < settings.rounds; ++round) {
        FitTerms terms;
        terms.reset(solver.num_rows());
        add_pins(model, pins, state.motion.inverse(), rows.row_of, terms);
        solve_round(model, rows, terms, step, solver, state, context);
    }
}

}  // namespace mien
