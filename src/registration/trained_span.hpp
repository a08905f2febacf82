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
    double least_seen = 0.9;  ///< 0 to 1: of the places that the trained fit sees, the kernel's
                              ///< must see so many: one that lost the scan leaves nothing open [J]
    double least_weight = 0.3;  ///< 0 to 1: places of less weight do not tell of the surface [J]
};

/// Of the open skin of the face that sees the scan, along the scan's normals.
struct OpenSurface {
    double middle_mm = 0;  ///< median of what the modes left; 0 of none. A median: a mask, hair or
                           ///< a hand is not the person's shape
    Index seen = 0;        ///< vertices
};

/// Whether the landmarks of `start` are likelier by far under the kernel alone.
bool landmarks_prefer_kernel(const DeformationModel& model, const PriorState& prior,
                             const StartState& start, double landmark_sigma_mm,
                             const PinPriorSettings& pins, const TrainedSpanSettings& settings,
                             const Context& context);

/// What a fit's modes leave open. O(#V log F).
OpenSurface open_surface(const DeformationModel& model, const PriorState& prior,
                         const StartState& start, const FitOutcome& fit,
                         const CorrespondenceSettings& match, const TrainedSpanSettings& settings,
                         const Context& context);

/// Whether the kernel's fit leaves clearly less of as much surface open.
bool surface_prefers_kernel(const OpenSurface& trained, const OpenSurface& kernel,
                            const TrainedSpanSettings& settings);

/// Whether there is a choice between trained modes and kernel that the host did not make.
bool may_weigh_trained(const DeformationModel& model, const PriorState& prior,
                       const TrainedSpanSettings& settings);

}  // namespace mien
