// Stage 3, start: where a fit begins. Landmarks are matched by name and weighed; the motion comes
// from them, from the host, or from a search over poses; fewer than three landmarks are helped by a
// rough fit. Another way to begin (a fit before this one) is one more StartKind.
#pragma once

#include <string>
#include <vector>

#include "registration/align_pins.hpp"
#include "registration/free_start.hpp"
#include "registration/gross_pins.hpp"
#include "registration/intake.hpp"
#include "registration/landmark_sides.hpp"
#include "registration/pin_prior.hpp"
#include "registration/search.hpp"
#include "registration/shut_lids.hpp"

namespace mien {

/// The numbers are the C ABI's numbers.
enum class StartKind : std::int32_t {
    automatic = 0,  ///< landmarks when at least three match, else a search over all poses
    landmarks = 1,
    pose = 2,  ///< given by the host
    search = 3,
};

/// Does the shape on the scan face the other way? Tags in brackets: registration/settings.hpp.
struct FacingSettings {
    double reach_mm = 10;       ///< mm, > 0: places farther from the scan are not asked [J]
    double least_cosine = 0.3;  ///< 0 to 1: normals across each other say nothing [J]
    double opposed = 0.6;       ///< 0 to 1: the scan is turned over when a larger share opposes [J]
    double outward = 0.3;  ///< 0 to 1: a scan that faces outwards so clearly is not inside out:
                           ///< then the landmarks are mirrored [J]
};

struct StartSettings {
    StartKind kind = StartKind::automatic;
    Similarity pose;               ///< template -> scan (mm), for StartKind::pose
    double landmark_sigma_mm = 2;  ///< mm, > 0: picking error per axis [J]
    PinAlignmentSettings alignment;
    SideSettings sides;
    GrossPinSettings gross;
    PinPriorSettings pin_prior;
    PinFitSettings pin_fit;
    SearchSettings search;
    FacingSettings facing;
    ApproachSettings approach;
    OpeningSettings openings;
    ShutLidSettings lids;
};

struct StartState {
    ScanView scan;                      ///< with the side out that faces like the template
    FitState state;                     ///< motion, and a first shape
    Similarity motion;                  ///< template -> scan as it was found, before any shape
    std::vector<Pin> pins;              ///< the landmarks that hold the fit
    std::vector<Pin> held;              ///< these, and lids that were found shut
    std::vector<std::string> unknown;   ///< landmarks that the model does not name
    std::vector<std::string> rejected;  ///< landmarks that the others contradict
    double search_score = 0;            ///< 0 to 1, of a search; 0 without one
    bool searched = false;
    std::vector<std::string> notes;            ///< what was settled or mended on the way
    PinFactors pin_factors;                    ///< by which `pins` were weighed
    std::vector<std::string> colors_left_out;  ///< features whose colours led a first fit astray

    /// No landmarks hold the fit along the skin.
    bool is_free() const { return pins.size() < kFewestPins; }
    static constexpr std::size_t kFewestPins = 3;  ///< fewer leave a motion open
};

/// `landmarks` in units of the raw scan. `fit`: the settings of the loop that follows. Throws
/// Status::not_found when landmarks are asked for and fewer than three are known,
/// invalid_argument for places that are not finite, no_solution when they lie on a line.
StartState find_start(const DeformationModel& model, const PreparedScan& scan,
                      const PriorState& prior, const std::vector<LandmarkPoint>& landmarks,
                      const StartSettings& settings, const LoopSettings& fit,
                      const Context& context);

}  // namespace mien
