// Units that scans come in, and whether two surfaces are in one.
#pragma once

#include <string>
#include <vector>

#include "base/types.hpp"

namespace mien {

/// "mm", "cm", "in", ... and what one of it is.
struct LengthUnit {
    const char* name;
    double to_mm;
};

/// mm, cm, inch, dm, foot, m, km: in the order in which equal evidence chooses.
const std::vector<LengthUnit>& length_units();

/// "mm", "25.4 mm (in)" for messages and reports: the name where it is one of the units.
std::string unit_text(double to_mm);

/// Diagonal of the box that holds all but one in `stray` of the vertices at each end of each axis,
/// so that a stray point says nothing. O(V).
double robust_extent(const PointsRef& vertices, Index stray = 50);

/// Units in which the extent is that of a face, a head, a bust or a whole body, likeliest first:
/// those of a face to a bust (110 to 900 mm), nearest to a head's 280 mm before the others, then
/// those of a body (to 2600 mm).
std::vector<LengthUnit> plausible_units(double extent);

/// Throws Status::mismatch, naming both and the unit that would explain it, when one surface is
/// `too_different` times larger than the other or more, so that they cannot be one face in one
/// unit: the closest units, mm and cm, differ by 10; a bust is three times larger than its face.
/// Fewer than three vertices say nothing.
void check_same_unit(const PointsRef& first, const char* first_name, const PointsRef& second,
                     const char* second_name, double too_different = 7);

}  // namespace mien
