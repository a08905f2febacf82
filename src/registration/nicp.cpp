#include "registration/nicp.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/normals.hpp"

namespace mien {
namespace {

// Blur of the colours, in noise levels of the surface and in mm.
constexpr double kColorBlur = 1.3, kLeastBlur_mm = 1, kMostBlur_mm = 8;

Similarity compose(const Similarity& outer, const Similarity& inner) {
    Similarity both;
    both.scale = outer.scale * inner.scale;
    both.rotation = outer.rotation * inner.rotation;
    both.translation = outer.apply(inner.translation);
    return both;
}

Vector3 rest_place(const DeformationModel& model, Index vertex) {
    Vector3 place = model.template_mesh.vertices.row(vertex).transpose();
    if (model.mean_displacement.rows() > 0)
        place += model.mean_displacement.row(vertex).transpose();
    return place;
}

// row_of: row of each vertex in the terms, or -1.
void add_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const Similarity& to_model, const std::vector<Index>& row_of, FitTerms& terms) {
    for (const Pin& pin : pins)
        terms.add_isotropic(row_of[static_cast<std::size_t>(pin.vertex)],
                            1 / (pin.sigma_mm * pin.sigma_mm),
                            to_model.apply(pin.place) - rest_place(model, pin.vertex));
}

// Where a surface bends, a normal that differs from the one seen tells of a slide: with S the
// scan's shape operator and p the shift along the surface, |(n_t - n_s) - S p|^2 is one more term
// of the energy. A large turn comes from another shape and not from a slide, and the sharpest bends
// are noise, lids and lips: both lose their say.
void add_turn(const ScanSurface& scan, const SurfaceHit& hit, const Vector3& seen,
              const Vector3& place_normal, const Similarity& to_model, double weight,
              const Vector3& target, Index row, FitTerms& terms) {
    constexpr double kTurn = 0.3, kBend = 0.1;  // radians, 1/mm
    Vector3 turn = place_normal - seen;
    turn -= seen * seen.dot(turn);
    const Matrix3 bend = to_model.rotation * scan.bending_at(hit) * to_model.rotation.transpose();
    const Matrix3 squared = bend * bend;
    weight *= std::exp(-0.5 * turn.squaredNorm() / (kTurn * kTurn)) /
              (1 + squared.trace() / (kBend * kBend));
    terms.add(row, weight * squared,
              weight * (squared * target + bend * (to_model.rotation * turn)));
}

// What lips and brows ask for (color_features.hpp), carried into the model's frame: where a vertex
// should end is known in the gradient's direction only.
void add_colors(const DeformationModel& model, const std::vector<ColorPull>& pulls,
                const FitState& state, double precision, const std::vector<Index>& row_of,
                FitTerms& terms) {
    const Matrix3 to_model =
        state.motion.scale * state.motion.rotation.transpose();  // of a gradient
    for (const ColorPull& pull : pulls) {
        const Index row = row_of[static_cast<std::size_t>(pull.vertex)];
        if (row < 0) continue;
        const Vector3 gradient = to_model * pull.gradient;
        Vector3 moved = state.displacement.row(pull.vertex).transpose();
        if (model.mean_displacement.rows() > 0)
            moved -= model.mean_displacement.row(pull.vertex).transpose();
        const double weight = pull.weight * precision;
        terms.add(row, weight * gradient * gradient.transpose(),
                  weight * gradient * (pull.difference + gradient.dot(moved)));
    }
}

// About one vertex in `stride`, spread by a hash of the index, and every pinned vertex; ascending.
std::vector<Index> choose_rows(Index num_vertices, Index stride, const std::vector<Pin>& pins) {
    std::vector<std::uint8_t> take(static_cast<std::size_t>(num_vertices), 0);
    for (std::size_t i = 0; i < take.size(); ++i)
        take[i] = ((static_cast<std::uint32_t>(i) * 2654435761u) >> 16) %
                      static_cast<std::uint32_t>(stride) ==
                  0;
    for (const Pin& pin : pins) take[static_cast<std::size_t>(pin.vertex)] = 1;
    std::vector<Index> rows;
    for (std::size_t i = 0; i < take.size(); ++i)
        if (take[i]) rows.push_back(static_cast<Index>(i));
    return rows;
}

// Points the solver at every stride-th vertex (1: all) and tells where each vertex's row is.
std::vector<Index> use_stride(const DeformationModel& model, Index stride,
                              const std::vector<Pin>& pins, const FitCoefficients& coefficients,
                              FitSolver& solver, const Context& context) {
    std::vector<Index> rows;
    if (stride > 1) rows = choose_rows(model.num_vertices(), stride, pins);
    solver.use_rows(rows, coefficients.kernel.rows(), coefficients.pca.size(), context);
    std::vector<Index> row_of(static_cast<std::size_t>(model.num_vertices()), -1);
    for (Index row = 0; row < solver.num_rows(); ++row)
        row_of[static_cast<std::size_t>(solver.vertex(row))] = row;
    return row_of;
}

Points pick_rows(const Points& points, const FitSolver& solver) {
    Points picked(solver.num_rows(), 3);
    for (Index row = 0; row < picked.rows(); ++row)
        picked.row(row) = points.row(solver.vertex(row));
    return picked;
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

void fit_pins(const DeformationModel& model, const std::vector<Pin>& pins,
              const RegistrationOptions& options, FitState& state, const Context& context) {
    FitSolver solver(model);
    FitStepOptions step;
    step.scalar_modes = state.coefficients.kernel.rows();
    step.pca_modes = state.coefficients.pca.size();
    step.kernel_ridge = 1 / (state.kernel_amplitude * state.kernel_amplitude);
    step.pca_ridge = 1 / (options.pca_amplitude * options.pca_amplitude);
    step.move = options.estimate_motion;
    step.scale = options.estimate_scale != 0;
    move_places(model, solver, state, context);
    // Nothing but the pins speaks, so a handful of other vertices is enough to hold the motion's
    // centre.
    const std::vector<Index> row_of =
        use_stride(model, std::max<Index>(1, model.num_vertices() / 500), pins, state.coefficients,
                   solver, context);
    for (int round = 0; round < 3; ++round) {
        FitTerms terms;
        terms.reset(solver.num_rows());
        add_pins(model, pins, state.motion.inverse(), row_of, terms);
        const Points current = pick_rows(model.template_mesh.vertices + state.displacement, solver);
        const Similarity motion = solver.step(terms, current, step, state.coefficients, context);
        state.motion = compose(state.motion, motion);
        move_places(model, solver, state, context);
    }
}

void fit_surface(const DeformationModel& model, const ScanSurface& scan, const Vector& scan_weight,
                 const std::vector<Pin>& pins, const RegistrationOptions& options, FitState& state,
                 const Context& context) {
    FitSolver solver(model);
    FitStepOptions step;
    step.pca_modes = state.coefficients.pca.size();
    step.kernel_ridge = 1 / (state.kernel_amplitude * state.kernel_amplitude);
    step.pca_ridge = 1 / (options.pca_amplitude * options.pca_amplitude);
    step.move = options.estimate_motion;
    step.scale = options.estimate_scale != 0;
    move_places(model, solver, state, context);

    CorrespondenceOptions match = options.correspondence;
    FitTerms terms;
    Index stride = 0;
    std::vector<Index> row_of;
    const int rounds = std::max(1, options.iterations);
    for (int round = 0; round < rounds; ++round) {
        context.progress(Stage::fitting, static_cast<double>(round) / rounds);
        const double f = rounds > 1 ? static_cast<double>(round) / (rounds - 1) : 1;
        const double sigma =
            options.sigma_start_mm * std::pow(options.sigma_end_mm / options.sigma_start_mm, f);
        const Index wanted = f < options.sparse_rounds ? options.sparse_stride : 1;
        if (wanted != stride) {
            stride = wanted;
            row_of = use_stride(model, stride, pins, state.coefficients, solver, context);
            state.matches.hits.clear();
        }
        step.scalar_modes = modes_at(options.growth, f, 10, state.coefficients.kernel.rows());
        step.tolerance = f < 1 ? options.solver_tolerance : 0.1 * options.solver_tolerance;
        state.coefficients.kernel.bottomRows(state.coefficients.kernel.rows() - step.scalar_modes)
            .setZero();
        match.robust_scale_mm = options.robust_factor * sigma;
        match.max_distance_mm =
            std::min(options.correspondence.max_distance_mm, 4 * match.robust_scale_mm);

        const Points normals = vertex_normals(state.places, model.template_mesh.triangles);
        const Points place_normals = pick_rows(normals, solver);
        find_correspondences(scan, pick_rows(state.places, solver), place_normals, scan_weight,
                             match, state.matches, context);
        for (Index row = 0; row < solver.num_rows() && !state.inner.empty(); ++row)
            if (state.inner[static_cast<std::size_t>(solver.vertex(row))])
                state.matches.weight[row] = 0;

        const Similarity to_model = state.motion.inverse();
        terms.reset(solver.num_rows());
        double energy = 0;
        const double precision =
            options.data_weight * static_cast<double>(stride) / (sigma * sigma);
        for (Index row = 0; row < solver.num_rows(); ++row) {
            const double weight = state.matches.weight[row];
            if (!(weight > 0)) continue;
            const SurfaceHit& hit = state.matches.hits[static_cast<std::size_t>(row)];
            const Vector3 normal = to_model.rotation * state.matches.normals.row(row).transpose();
            terms.add_planar(row, weight * precision, options.tangential, normal,
                             to_model.apply(hit.point) - rest_place(model, solver.vertex(row)));
            if (options.normal_length_mm > 0)
                add_turn(scan, hit, state.matches.normals.row(row).transpose(),
                         place_normals.row(row).transpose(), to_model,
                         weight * precision * options.normal_length_mm * options.normal_length_mm,
                         to_model.apply(hit.point) - rest_place(model, solver.vertex(row)), row,
                         terms);
            energy += weight * hit.squared_distance;
        }
        add_pins(model, pins, to_model, row_of, terms);
        if (state.colors) {
            const double blur_mm = std::clamp(kColorBlur * sigma, kLeastBlur_mm, kMostBlur_mm);
            add_colors(model,
                       state.colors->pulls(state.places, normals, match, blur_mm,
                                           state.color_matches, context),
                       state, options.color_weight * static_cast<double>(stride), row_of, terms);
        }
        const Points before = state.places;
        const Points current = pick_rows(model.template_mesh.vertices + state.displacement, solver);
        const Similarity motion = solver.step(terms, current, step, state.coefficients, context);
        state.motion = compose(state.motion, motion);
        move_places(model, solver, state, context);
        state.energy.push_back(energy / std::max(1.0, state.matches.weight.sum()));
        state.sigma_mm = sigma;
        ++state.iterations;
        const double movement = (state.places - before).rowwise().norm().mean();
        context.log(LogLevel::debug,
                    "round %d: sigma %.3f mm, %lld modes, energy %.4f, moved %.4f mm, %d steps",
                    round, sigma, static_cast<long long>(step.scalar_modes), state.energy.back(),
                    movement, solver.iterations());
        if (f >= 1 && movement < options.stop_movement_mm) break;
    }
    state.final_weight = state.matches.weight;
    context.progress(Stage::fitting, 1);
}

}  // namespace mien
