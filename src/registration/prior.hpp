// Stage 2, prior: how the template may move before anything of the scan is known. It depends on the
// model and the settings alone, so one prior serves any number of fits.
//
// Kernel modes and trained modes share the work: trained modes know faces, and leave to the kernel
// what their training people did not span: what the model's training left of people left out
// (DeformationModel::pca_left_out_mm). Without trained modes the kernel carries all, at an
// amplitude that landmarks choose (pin_evidence.hpp).
#pragma once

#include "registration/fit_state.hpp"
#include "registration/inner.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct PriorSettings {
    Index max_scalar_modes = -1;  ///< -1: all of the model's (three deformation modes each)
    Index max_pca_modes = -1;     ///< -1: all of the model's
    double kernel_amplitude = 0;  ///< >= 0: factor on the kernel's standard deviation; 0: the
                                  ///< landmarks' likeliest [A]
    double pca_amplitude = 1;     ///< > 0: factor on the trained modes' standard deviations
    bool estimate_motion = true;
    /// Whether the motion may scale: 1, 0, or -1: only for models without trained modes, which know
    /// sizes. [A]
    int estimate_scale = -1;
    double residual_sd_mm = 0.7;     ///< mm, > 0: what trained modes leave to the kernel, when its
                                     ///< amplitude is automatic and the model does not say [A]
    Index max_residual_modes = 250;  ///< >= 0: the scalar modes spent on it [A]
};

/// What the solver may change, and how freely.
struct FitFreedom {
    double pca_amplitude = 1;
    bool move = true;
    bool scale = true;
};

struct PriorState {
    Index scalar_modes = 0, pca_modes = 0;
    double kernel_amplitude = 1;
    bool amplitude_given = false;  ///< by the host: landmarks do not change it
    FitFreedom freedom;
    std::vector<std::uint8_t> inner;  ///< #V, excluded from correspondence
    ColorFeatures colors;             ///< on the template

    /// What trained modes say of landmarks: nothing when they are left out.
    double pin_pca_amplitude() const { return pca_modes > 0 ? freedom.pca_amplitude : 0; }
    /// At rest, with room for all modes.
    FitState state_at_rest() const;
};

/// The same without trained modes: all the kernel's modes, free in size unless the settings say
/// otherwise, at an amplitude that landmarks choose.
PriorState kernel_alone(const DeformationModel& model, const PriorState& prior,
                        const PriorSettings& settings);

/// Root mean square over the vertices of the kernel's prior deviation in its first modes at
/// amplitude 1, mm.
double kernel_deviation_mm(const DeformationModel& model, Index scalar_modes);

/// O(V log F) for the walls that no scanner sees.
PriorState choose_prior(const DeformationModel& model, const PriorSettings& settings,
                        const InnerSettings& inner, const ColorFeatureSettings& colors,
                        const Context& context);

}  // namespace mien
