// Dense correspondence along the skin by texture: a second visit's fit slides along its scan until
// every place of the template lies on the freckles and pores that it lay on at the first visit.
//
// Form alone cannot say where on a smooth cheek a place is; both visits' pictures of it can. Both
// fits carry the template, so both pictures are seen through the same views of it
// (skin_views.hpp), compared from coarse to fine (skin_match.hpp), and what was measured becomes a
// smooth field (slide_field.hpp) that holds where both pictures show the same detail and goes on
// smoothly where they do not. The fit's form does not change: a place moves to where the same fit
// carries another place of the template.
//
// A picture of another person, or one without detail, agrees nowhere: then nothing moves at all.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/deformation_model.hpp"
#include "registration/gap.hpp"
#include "registration/inner.hpp"
#include "registration/intake.hpp"
#include "registration/skin_match.hpp"
#include "registration/slide_field.hpp"

namespace mien {

/// One pass over the pictures. Tags in brackets: registration/settings.hpp.
struct TieRound {
    int halvings = 0;      ///< 0 to 4: of the views' resolution
    int reach = 2;         ///< >= 1, pixels
    double window_mm = 8;  ///< mm, > 0
    double coarse_mm = 4;  ///< mm, > 0: SkinDetailSettings
    double robust_mm = 1;  ///< mm, > 0: a measurement farther from the smooth field counts little
    double smooth_mm = 3;  ///< mm, > 0: SlideFieldSettings
};

struct TextureTieSettings {
    SkinViewSettings views;
    SkinSampleSettings sample;
    SkinDetailSettings detail;  ///< coarse_mm is the rounds'
    SkinMatchSettings match;    ///< window and reach are the rounds'
    SlideFieldSettings field;   ///< smooth_mm is the rounds'
    /// Of 1 mm pixels and far, then finer and nearer. [T] tests/bench/README.md, "Two visits by
    /// texture"
    std::array<TieRound, 4> rounds{
        {{1, 6, 15, 6, 4, 8}, {1, 2, 12, 5, 1.5, 4}, {0, 2, 10, 4, 1, 3}, {0, 2, 8, 3, 0.7, 2}}};
    int reweighings = 4;        ///< >= 1: of the measurements in a round [J]
    double most_slide_mm = 6;   ///< mm, > 0: what slides farther is not tied
    double near_border_mm = 3;  ///< mm, >= 0: from lids, lips and nostrils nothing is measured [J]
    double least_agreement = 0.3;  ///< 0 to 1: correlation below which a window says nothing [J]
    double full_agreement = 0.6;   ///< > least_agreement: from which it counts in full [J]
    double full_lead = 0.15;       ///< > 0, correlation: a far search's best move that leads the
                                   ///< second best by so much counts in full [J]
    double full_sd_mm = 0.2;       ///< mm, > 0: a measurement so sure counts half [J]
    double tied_agreement = 0.4;   ///< 0 to 1: correlation after the slide, from which a place
                                   ///< counts as tied [J]
    double full_tied_agreement = 0.1;  ///< > 0, correlation: and so far above it, in full [J]
    double tied_off_mm = 0.5;      ///< mm, > 0: and so near must its best move be to the field [J]
    double least_share = 0.2;      ///< 0 to 1: of the skin seen twice that must agree, or nothing
                                   ///< moves [T]
    double least_compared = 0.05;  ///< 0 to 1: of the open skin that must be seen twice [J]
    double fill_mm = 0.5;          ///< mm, > 0: over which walls and rims go with the skin [J]
    double raised_slide_mm = 0.1;  ///< mm, > 0: what slid so far is put onto the scan in full [J]
    double raise_mm = 0.5;         ///< mm, > 0: scan farther away raises nothing [J]
    double normal_trust = 0.05;    ///< > 0: how much the field is held in the surface [J]
    GapSettings gap;
};

/// A visit as it was fitted.
struct FittedVisit {
    const Points& places;      ///< #V x 3, mm, scan frame
    const Vector& weight;      ///< #V, how far the scan counted, or empty: all one
    const PreparedScan& scan;  ///< with colours, in the same frame
};

struct TextureTie {
    bool tied = false;           ///< false: nothing moved, `places` are the visit's
    std::string why_not;         ///< what to do about it; empty when tied
    Points places;               ///< #V x 3, mm
    Vector slide_mm;             ///< #V, how far each place moved
    Vector agreement;            ///< #V, -1 to 1: correlation of both pictures around it after the
                                 ///< slide; 0 where they cannot be compared
    Vector share;                ///< #V, 0 to 1: how far the texture holds the place
    Vector sd_mm;                ///< #V, of the tie along the skin, per axis; 0 where share is 0
    double compared = 0;         ///< 0 to 1, of the open skin's area: seen in both visits
    double agreeing = 0;         ///< 0 to 1, of the compared: both pictures show the same
    double median_slide_mm = 0;  ///< of the tied places
    Index undone = 0;            ///< turned triangles that went back
};

/// Both visits are fits of `model`. Throws Status::invalid_argument when a scan has no colours
/// (naming the visit), mismatch for fits of another template, cancelled, memory_budget, no_memory.
/// Half a second to two of processor time.
TextureTie tie_by_texture(const DeformationModel& model, const FittedVisit& reference,
                          const FittedVisit& visit, const TextureTieSettings& settings,
                          const Context& context);

}  // namespace mien
