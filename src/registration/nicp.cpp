#include "registration/nicp.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

Similarity compose(const Similarity& outer, const Similarity& inner) {
    Similarity both;
    both.scale = outer.scale * inner.scale;
    both.rotation = outer.rotation * inner.rotation;
    both.translation = outer.apply(inner.translation);
    return both;
}

void add_pins(const DeformationModel& model, const std::vector<Pin>& pins, const Similarity& to_model,
              FitTerms& terms) {
    for (const Pin& pin : pins) {
        Vector3 start = model.template_mesh.vertices.row(pin.vertex).transpose();
        if (model.mean_displacement.rows() > 0) start += model.mean_displacement.row(pin.vertex).transpose();
        terms.add_isotropic(pin.vertex, 1 / (pin.sigma_mm * pin.sigma_mm),
                            to_model.apply(pin.place) - start);
    }
}

void move_places(const DeformationModel& model, const FitSolver& solver, FitState& state,
                 const Context& context) {
    state.displacement = solver.displacement(state.coefficients, context);
    const Points shaped = model.template_mesh.vertices + state.displacement;
    state.places = state.motion.apply(PointsRef(shaped));
}

}  // namespace

Index modes_at(ModeGrowth growth, double f, Index first, Index all) {
    first = std::min(first, all);
    const double low = static_cast<double>(first), high = static_cast<double>(all);
    double modes = high;
    switch (growth) {
        case ModeGrowth::constant: break;
        case ModeGrowth::linear: modes = low + f * (high - low); break;
        case ModeGrowth::exponential: modes = low * std::pow(high / std::max(low, 1.0), f); break;
        case ModeGrowth::cubic: modes = low + f * f * f * (high - low); break;
    }
    return std::min(all, std::max(first, static_cast<Index>(std::lround(modes))));
}

void fit_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const RegistrationOptions& options, FitState& state, const Context& context) {
    FitSolver solver(model);
    FitStepOptions step;
    step.scalar_modes = state.coefficients.kernel.rows();
    step.pca_modes = state.coefficients.pca.size();
    step.kernel_ridge = 1 / (state.kernel_amplitude * state.kernel_amplitude);
    step.pca_ridge = 1 / (options.pca_amplitude * options.pca_amplitude);
    step.move = options.estimate_motion;
    step.scale = options.estimate_scale;
    move_places(model, solver, state, context);
    for (int round = 0; round < 3; ++round) {
        FitTerms terms;
        terms.reset(model.num_vertices());
        add_pins(model, pins, state.motion.inverse(), terms);
        const Points current = model.template_mesh.vertices + state.displacement;
        const Similarity motion = solver.step(terms, current, step, state.coefficients, context);
        state.motion = compose(state.motion, motion);
        move_places(model, solver, state, context);
    }
}

void fit_surface(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                 const std::vector<Pin>& pins, const RegistrationOptions& options, FitState& state,
                 const Context& context) {
    const Index n = model.num_vertices();
    FitSolver solver(model);
    FitStepOptions step;
    step.pca_modes = state.coefficients.pca.size();
    step.kernel_ridge = 1 / (state.kernel_amplitude * state.kernel_amplitude);
    step.pca_ridge = 1 / (options.pca_amplitude * options.pca_amplitude);
    step.move = options.estimate_motion;
    step.scale = options.estimate_scale;
    move_places(model, solver, state, context);

    CorrespondenceOptions match = options.correspondence;
    FitTerms terms;
    const int rounds = std::max(1, options.iterations);
    for (int round = 0; round < rounds; ++round) {
        context.progress(Stage::fitting, static_cast<double>(round) / rounds);
        const double f = rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1;
        const double sigma =
            options.sigma_start_mm * std::pow(options.sigma_end_mm / options.sigma_start_mm, f);
        step.scalar_modes = modes_at(options.growth, f, 10, state.coefficients.kernel.rows());
        state.coefficients.kernel.bottomRows(state.coefficients.kernel.rows() - step.scalar_modes).setZero();
        match.robust_scale_mm = options.robust_factor * sigma;
        match.max_distance_mm = std::min(options.correspondence.max_distance_mm, 4 * match.robust_scale_mm);

        const Points place_normals = vertex_normals(state.places, model.template_mesh.triangles);
        find_correspondences(scan, state.places, place_normals, scan_weight, match, state.matches, context);

        const Similarity to_model = state.motion.inverse();
        terms.reset(n);
        double energy = 0;
        const double precision = options.data_weight / (sigma * sigma);
        for (Index i = 0; i < n; ++i) {
            const double weight = state.matches.weight[i];
            if (!(weight > 0)) continue;
            const SurfaceHit& hit = state.matches.hits[static_cast<std::size_t>(i)];
            const Vector3 normal = to_model.rotation * state.matches.normals.row(i).transpose();
            Vector3 target = to_model.apply(hit.point) - model.template_mesh.vertices.row(i).transpose();
            if (model.mean_displacement.rows() > 0) target -= model.mean_displacement.row(i).transpose();
            terms.add_planar(i, weight * precision, options.tangential, normal, target);
            energy += weight * hit.squared_distance;
        }
        add_pins(model, pins, to_model, terms);
        const Points before = state.places;
        const Points current = model.template_mesh.vertices + state.displacement;
        const Similarity motion = solver.step(terms, current, step, state.coefficients, context);
        state.motion = compose(state.motion, motion);
        move_places(model, solver, state, context);
        state.energy.push_back(energy / std::max(1.0, state.matches.weight.sum()));
        state.sigma_mm = sigma;
        ++state.iterations;
        const double movement = (state.places - before).rowwise().norm().mean();
        context.log(LogLevel::debug, "round %d: sigma %.3f mm, %lld modes, energy %.4f, moved %.4f mm, %d steps",
                    round, sigma, static_cast<long long>(step.scalar_modes), state.energy.back(), movement,
                    solver.iterations());
        if (round + 1 == rounds || (f >= 1 && movement < options.stop_movement_mm)) break;
    }
    state.final_weight = state.matches.weight;
    context.progress(Stage::fitting, 1);
}

}  // namespace mien
