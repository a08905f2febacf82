// Trained modes know the family of their training people. On a face outside of it they are worse
// than the kernel that knows nothing: its landmarks tell, or what they leave of its surface.
#pragma once

#include "registration/fit.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct TrainedSpanSettings {
    bool weigh = true;    ///< the face may speak against the trained modes [T] "Two priors,
                          ///< weighed"
    double clearly = 18;  ///< >= 0: by how much the kernel's cost of the landmarks (pin_prior.hpp)
                          ///< must be lower [T]
    /// mm, >= 0: a fit without landmarks that leaves no more open is not doubted, and the kernel
    /// alone must leave less than this share of it, 0 to 1. [T] "Two priors, weighed"
    double least_open_mm = 0.27, kernel_share = 0.65;
    double least_weight = 0.3;  ///< 0 to 1: places of less weight do not tell of the surface [J]
};

/// Whether the landmarks of `start` are likelier by far under the kernel alone.
bool landmarks_prefer_kernel(const DeformationModel& model, const PriorState& prior,
                             const StartState& start, double landmark_sigma_mm,
                             const PinPriorSettings& pins, const TrainedSpanSettings& settings,
                             const Context& context);

/// What a fit without landmarks leaves open: the middle, over the open skin of the face that sees
/// the scan, of its distance along the scan's normal, mm. A middle: a mask, hair or a hand is not
/// the person's shape.
double open_surface_mm(const DeformationModel& model, const PriorState& prior,
                       const StartState& start, const FitOutcome& fit,
                       const CorrespondenceSettings& match, const TrainedSpanSettings& settings,
                       const Context& context);

/// Whether the trained modes may be asked at all: there are some, and nobody settled it.
bool may_weigh_trained(const DeformationModel& model, const PriorState& prior,
                       const TrainedSpanSettings& settings);

}  // namespace mien
