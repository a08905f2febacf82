// What a finished fit shows of itself, zone by zone: how much of the zone was scanned, how far the
// scan lies off, what the modes left to the smooth field, how the normals turn, how far the prior
// leaves the places open, how the surface was stretched, and how its landmarks ended.
// expected_error.hpp reads an error in mm from them.
#pragma once

#include <string>
#include <vector>

#include "registration/fit.hpp"

namespace mien {

/// Tags in brackets: registration/settings.hpp.
struct ZoneMeasureSettings {
    double beside_mm = 10;      ///< mm, > 0: places farther from the scan are not beside it [J]
    double least_weight = 0.3;  ///< 0 to 1: places of less weight do not tell of the surface [J]
    double most_stretch = 2;    ///< > 0: bound on the logarithm of an edge's stretch
    double most_share = 0.9;    ///< 0 to 1: quantile of the places that the modes left [J]
    double near_mm = 25;        ///< mm, > 0: how far along the template a landmark's misfit, or a
                                ///< feature's colours, tell of their surroundings [J]
    double far_mm = 100;        ///< mm, > 0: farther landmarks are as good as none [J]
    Index shape_modes = 100;    ///< >= 1: strongest kernel modes that a deviation is held against
};

/// Of one zone, or of the whole face.
struct ZoneMeasures {
    std::string name;            ///< the model's; "face" for the whole
    double unseen = 0;           ///< 0 to 1: share of its open skin that the scan had no say in
    double residual_mm = 0;      ///< mean distance to the scan where it had one
    double open_mm = 0;          ///< mean distance that the modes left to the smooth field there
    double turn = 0;             ///< mean of 1 - cosine between the modes' normals and the scan's
    double deviation_mm = 0;     ///< mean stated deviation of a place, per axis
    double stretch = 0;          ///< root mean square logarithm of the edges' lengths over those at
                                 ///< rest, about the whole face's mean
    double landmark_mm = 0;      ///< root mean square misfit of the landmarks in it; 0 without
    int landmarks = 0;           ///< that hold it
    double open_most_mm = 0;     ///< what nine of ten of its places stayed below of open_mm
    double asymmetry_mm = 0;     ///< mean distance to the mirrored face, rigid motions left out; 0
                                 ///< when the template has no mirror image
    double shape_deviation = 0;  ///< root mean square displacement, in the prior's deviations of
                                 ///< the places
    double slid_mm = 0;          ///< mean movement along the skin since the start
    double pin_far_mm = 0;       ///< mean distance to the nearest landmark that holds the fit, on
                                 ///< the template; bounded by ZoneMeasureSettings::far_mm
    double pin_misfit_mm = 0;    ///< mean misfit of the landmarks around, by their distance
    double color_hold = 0;       ///< 0 to 1: how far agreeing colours around hold it
    double color_doubt = 0;      ///< 0 to 2: how far colours around disagree
};

/// Of the fit as a whole, whichever zone is asked for.
struct WholeMeasures {
    double search_miss = 0;      ///< 1 - score of a searched start; 0 when it was not searched
    double landmark_misfit = 0;  ///< root mean square misfit over the stated picking error per
                                 ///< axis; 0 without landmarks
    double landmarks_out = 0;    ///< 0 to 1: share of the landmarks that were left out
    double color_miss = 0;       ///< 1 - least agreement of a feature's colours; 0 without colours
    double trained_deviation = 0;  ///< root mean square of the trained modes' coefficients, in
                                   ///< standard deviations
    double kernel_deviation = 0;   ///< and of the kernel's
    double kernel_mm = 0;          ///< deviation that the kernel was given, mm
    double size = 0;               ///< |logarithm of fitted size over template size|
    double folds = 0;              ///< share of folded triangles
    double is_free = 0;            ///< 1: fewer than three landmarks hold it
    double is_trained = 0;         ///< 1: trained modes take part
    double no_colors = 0;          ///< 1: colours had no say
    double landmarks = 0;          ///< that hold the fit
    double lips_miss = 0;          ///< 1 - agreement of the lips' colours; 0 without
    double brows_miss = 0;         ///< and of the worse brow's
    double worst_open_mm = 0, worst_unseen = 0;  ///< of the zones
};

/// Borrowed.
struct MeasuredFit {
    const DeformationModel& model;
    const PriorState& prior;
    const StartState& start;
    const FitOutcome& fit;
    const Points& places;                           ///< #V x 3, scan frame
    const std::vector<SurfaceHit>& correspondence;  ///< #V, all valid
    const Vector& weight;                           ///< #V, 0 to 1
    const Vector& deviation_mm;                     ///< #V
};

/// Without colours, folds and the worst zone, which the verdict adds. `landmark_sigma_mm`: as
/// stated.
WholeMeasures measure_whole(const MeasuredFit& finished, double landmark_sigma_mm);

/// The whole face first (the model's zone "face", else all open skin), then every other zone of the
/// model in its order. `colors`: of lips and brows. O(V + F) for each zone's vertices once, O(V P)
/// for P landmarks.
std::vector<ZoneMeasures> measure_zones(const MeasuredFit& finished,
                                        const std::vector<ColorAgreement>& colors,
                                        const ZoneMeasureSettings& settings,
                                        const Context& context);

}  // namespace mien
