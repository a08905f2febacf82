#include "registration/prior.hpp"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr double kNoDeviation_mm = 1e-9;  // of a model whose modes move nothing

Index at_most(Index most, Index all) {
    return most >= 0 ? std::min(most, all) : all;
}

}  // namespace

double kernel_deviation_mm(const DeformationModel& model, Index scalar_modes) {
    return std::sqrt(static_cast<double>(model.basis.map().leftCols(scalar_modes).squaredNorm()) /
                     static_cast<double>(model.num_vertices()));
}

FitState PriorState::state_at_rest() const {
    FitState state;
    state.coefficients.kernel.setZero(scalar_modes, 3);
    state.coefficients.pca.setZero(pca_modes);
    state.kernel_amplitude = kernel_amplitude;
    return state;
}

PriorState choose_prior(const DeformationModel& model, const PriorSettings& settings,
                        const InnerSettings& inner, const ColorFeatureSettings& colors,
                        const Context& context) {
    PriorState prior;
    prior.pca_modes = at_most(settings.max_pca_modes, model.pca_modes.cols);
    prior.scalar_modes = at_most(settings.max_scalar_modes, model.basis.cols);
    prior.amplitude_given = settings.kernel_amplitude > 0;
    prior.kernel_amplitude = prior.amplitude_given ? settings.kernel_amplitude : 1;
    if (prior.pca_modes > 0 && prior.scalar_modes > 0) {
        prior.scalar_modes = std::min(prior.scalar_modes, settings.max_residual_modes);
        const double kernel_mm =
            std::max(kernel_deviation_mm(model, prior.scalar_modes), kNoDeviation_mm);
        // Of few people much is left out: no more than the kernel alone would do.
        const double left_mm = model.pca_left_out_mm > 0
                                   ? std::min(model.pca_left_out_mm, kernel_mm)
                                   : settings.residual_sd_mm;
        if (!prior.amplitude_given) prior.kernel_amplitude = left_mm / kernel_mm;
    }
    prior.freedom.pca_amplitude = settings.pca_amplitude;
    prior.freedom.move = settings.estimate_motion;
    prior.freedom.scale =
        settings.estimate_scale < 0 ? prior.pca_modes == 0 : settings.estimate_scale != 0;
    const bool known = inner.exclude && !model.walls.empty() &&
                       model.walls_key == walls_key(model.template_mesh, inner.walls);
    prior.inner = known ? model.walls : find_inner_vertices(model.template_mesh, inner, context);
    prior.colors = ColorFeatures(model, prior.inner, colors, context);
    return prior;
}

PriorState kernel_alone(const DeformationModel& model, const PriorState& prior,
                        const PriorSettings& settings) {
    PriorState alone = prior;
    alone.pca_modes = 0;
    alone.scalar_modes = at_most(settings.max_scalar_modes, model.basis.cols);
    alone.kernel_amplitude = 1;
    alone.freedom.scale = settings.estimate_scale != 0;
    return alone;
}

}  // namespace mien
