// Which vertices a study measures, leaves out and aligns on.
#pragma once

#include "base/types.hpp"
#include "study/settings.hpp"

namespace mien {

/// The vertices within margin_mm (straight) of given ones on a face, those among them; ascending.
/// O(#V times the vertices given). Throws Status::mismatch for a vertex beyond #V.
std::vector<std::uint32_t> with_margin(const PointsRef& face,
                                       const std::vector<std::uint32_t>& vertices,
                                       double margin_mm);

/// Takes the vertices that are marked out of each zone; a zone of nothing else stays as it is.
/// left_out: #V, not 0 where marked.
void leave_out(std::vector<Zone>& zones, const std::vector<std::uint8_t>& left_out);

struct StudyZones {
    std::vector<Zone> named;                ///< the zones, then each treated one with its margin
    std::vector<Zone> measured;             ///< the same without skin that nobody saw
    std::vector<std::uint32_t> treated;     ///< with the margin
    std::vector<std::uint32_t> stable;      ///< to align on; empty: the whole face
    std::vector<std::string> stable_names;  ///< of the zones that stable is made of
    bool stable_is_untreated = false;       ///< all zones but the treated ones and their margin
};

/// face: where the margin is measured. Throws Status::not_found for a name that no zone has, and
/// Status::mismatch for a vertex beyond the face.
StudyZones resolve_zones(const StudyZoneSettings& settings, const PointsRef& face,
                         bool expressions_taken_off);

}  // namespace mien
