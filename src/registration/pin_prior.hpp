// What the model's prior says of picked landmarks: how likely they are together, which of them
// contradict the others, how far the kernel should reach and how well they were picked.
//
// With d the pinned places' displacements, K and P their covariances by the kernel and the trained
// modes, M the seven small motions,
//
//   d ~ N(0, a^2 K + c^2 P + M M' 10^3 + s^2 I).
//
// Amplitude a and picking error s are those of the greatest marginal likelihood, seen orthogonal to
// the motions. A pin k is contradicted when leave-one-out prediction (Rasmussen and Williams,
// Gaussian processes for machine learning, 5.4.2),
//
//   r_k = (C^-1 d)_k,  S_k = (C^-1)_kk,  finds  r_k' S_k^-1 r_k > limit.
#pragma once

#include <vector>

#include "registration/fit_state.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct PinPriorSettings {
    std::size_t most = 300;  ///< more are taken as they are: the algebra is dense [J]
    // Contradicted pins
    std::size_t fewest_to_reject = 5;  ///< >= 5 [J]
    double limit = 40;  ///< > 0: chi-squared with 3 degrees, with room for an imperfect prior [J]
    std::size_t reject_one_in = 10;  ///< >= 1: when more would go, none does: then it is the face
                                     ///< that the prior did not expect (an open mouth) [J]
    double motion_variance = 1e3;    ///< mm^2, > 0: of the free small motions [J]
    // Likeliest amplitude and picking error
    bool weigh = true;                   ///< [A]
    std::size_t fewest_to_weigh = 10;    ///< [J]
    int amplitude_octaves = 3;           ///< 1/8 to 8 times; not with trained modes, which know how
                                         ///< far faces differ [J]
    int amplitude_steps = 8;             ///< per octave [J]
    int noise_low = -8, noise_high = 2;  ///< quarter octaves: 1/4 to 1.4 times the stated error [J]
};

/// Factors on the kernel's deviation (1 when trained modes take part, that is pca_amplitude > 0)
/// and on the pins' picking error.
struct PinFactors {
    double amplitude = 1, noise = 1;
    double cost = 0;       ///< twice the negative logarithm of their marginal likelihood, but for a
                           ///< constant that all priors share
    bool weighed = false;  ///< false: too few pins, or too many
};

/// The likeliest factors; ones for too few or too many pins. Amplitudes are those that the factors
/// multiply. Throws Status::no_solution when the eigenproblem does. O(#pins^3).
PinFactors weigh_pins(const DeformationModel& model, const std::vector<Pin>& pins,
                      const Similarity& motion, double kernel_amplitude, double pca_amplitude,
                      const PinPriorSettings& settings, const Context& context);

/// Numbers of the contradicted pins, worst first. Throws Status::no_solution when the covariance
/// cannot be factored. O(#pins^3) for each.
std::vector<std::size_t> contradicting_pins(const DeformationModel& model,
                                            const std::vector<Pin>& pins, const Similarity& motion,
                                            double kernel_amplitude, double pca_amplitude,
                                            const PinPriorSettings& settings,
                                            const Context& context);

}  // namespace mien
