// Are left and right exchanged among the landmarks? Names as an observer sees the face, a mirrored
// scan, or only eyes and brows drawn from the other side: each would pull a fit inside out.
//
// The partner of a landmark is the one nearest to its mirror image on the template, across the
// plane x = 0. All are exchanged when the template with partners in place of each other aligns
// clearly better than as it is; some are, when after a robust alignment they lie at their partner's
// place and far from their own.
#pragma once

#include <string>
#include <vector>

#include "registration/align_pins.hpp"

namespace mien {

/// What is done about exchanged landmarks. The numbers are the C ABI's numbers.
enum class SideRule : std::int32_t {
    refuse = 0,  ///< throw Status::mismatch that names the cause
    mend = 1,    ///< exchange the names back
    ignore = 2,
};

/// [J]; tags in brackets: registration/settings.hpp. Right sets align to 2 to 6 mm, exchanged ones
/// to 15 mm and more.
struct SideSettings {
    SideRule rule = SideRule::refuse;
    double partner_mm = 12;  ///< mm, > 0: of the mirror image to the partner, at most
    double least_mm = 5;     ///< mm, >= 0: alignments better than that are not questioned
    double clearly = 0.6;    ///< 0 to 1: of the misfit, that partners must reach
    double own_mm = 20;      ///< mm, > 0: a single one is exchanged when so far from its own place
    double share = 0.5;      ///< 0 to 1: and its partner's place is nearer by this
    std::size_t fewest = 4;  ///< >= 1: so many single ones, or none
};

struct ExchangedSides {
    bool all = false;
    std::vector<std::size_t> pins;      ///< numbers of exchanged pins, ascending
    std::vector<Index> partner_vertex;  ///< one per pin of the input: its partner's, or its own
};

ExchangedSides find_exchanged_sides(const DeformationModel& model, const std::vector<Pin>& pins,
                                    bool with_scale, const SideSettings& settings,
                                    const PinAlignmentSettings& alignment);

/// "left and right are exchanged ...", for errors and notes.
std::string describe(const ExchangedSides& sides, const std::vector<std::string>& names);

}  // namespace mien
