// What changed in one zone between two visits, every number with its deviation, interval and limit
// of detection; not a number, and a reason, where nothing is known.
//
// Signed volume V and its deviation: measure/uncertainty.hpp, and the expressions' part beside it.
// Of places that no visit saw a share alone counts (change_deviation_mm(), study_face.hpp). Mean
// distance: the signed distance along the normals, whose errors are those of V over the area.
// Gained, lost and absolute volume are not linear: noise alone makes a gain of B = sum a_v s_v /
// sqrt(2 pi) where nothing changed (the mean of the positive part of a normal error), s_v the whole
// deviation of vertex v. Their deviation is that of the part of the zone that they sum up, and
// their interval goes down by B more, counted where the change is within three deviations:
//     [V+ - B - z s, V+ + z s], not below 0.
// Area: g' S g with the slope g of the zone's area, by the errors along the normals, by the
// expressions, and by the template's slide along the skin, which a joint neutralization takes off
// where both faces were seen.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "geometry/rigid_zone.hpp"
#include "study/expression_error.hpp"
#include "study/study_zones.hpp"

namespace mien {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct StudyValue {
    double value = kUnknown;
    double sd = kUnknown;
    double low = kUnknown, high = kUnknown;  ///< interval at the settings' level
    double limit_of_detection = kUnknown;
    double noise_bias = 0.0;  ///< B: what noise alone adds to the value
};

/// Why there is no deviation. The numbers are the C ABI's numbers.
enum class WhyUnknown : std::int32_t {
    nothing = 0,              ///< all is known
    unseen = 1,               ///< too little of the zone was seen; nothing is told, values neither
    failed_fit = 2,           ///< the fit of one visit failed
    no_surface_errors = 3,    ///< a face came without deviations
    outside_expressions = 4,  ///< the zone lies behind the expression model's rim
};
/// A sentence for people; empty for `nothing`.
const char* why_unknown(WhyUnknown reason);

struct ZoneChange {
    WhyUnknown reason = WhyUnknown::nothing;
    StudyValue signed_ml, gained_ml, lost_ml, absolute_ml;
    StudyValue area_mm2;          ///< change of area; its sd is none when the slide is not known
    StudyValue mean_distance_mm;  ///< signed, along the normal of the first face
    /// What signed_ml.sd is made of.
    double surface_sd_ml = kUnknown, alignment_sd_ml = kUnknown, bias_sd_ml = kUnknown,
           expression_sd_ml = kUnknown;
    double expression_removed_ml = 0.0;  ///< what the expressions accounted for
    double seen_share = kUnknown;        ///< of the area, in both visits; none: not told
    double area_before_mm2 = kUnknown, area_after_mm2 = kUnknown;
    int detected = -1;  ///< 1: |signed| reaches its limit of detection, 0: below, -1: no limit
};

/// What two visits' comparison stands on.
struct StudyData {
    StudySettings settings;
    std::vector<StudyFace> faces;
    StudyZones zones;
    NeutralFaces neutral;
    std::shared_ptr<const ExpressionModel> model;  ///< null: expressions stay on
    Matrix expression_map;                         ///< empty without a joint fit
};

struct PairChange {
    RigidZoneResult alignment;  ///< second neutral face -> first neutral face
    std::vector<ZoneChange> zones;
};

/// first, second: places in data.faces. Limits of detection are propagated (no blanks yet).
PairChange compare_faces(const Context& context, const StudyData& data, std::size_t first,
                         std::size_t second);

/// The second neutral face in the frame of the first.
TriMesh aligned_face(const StudyData& data, std::size_t second, const RigidZoneResult& alignment);

}  // namespace mien
