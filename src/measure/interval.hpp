// Intervals and limits that follow from a standard deviation, for errors that are normal.
//
// Sources: GUM (JCGM 100:2008) 5.2 and 6.3 for the interval; Currie 1968 for the limit of detection
// with five percent of errors of both kinds.
#pragma once

namespace mien {

struct Interval {
    double low = 0.0, high = 0.0;
};

/// value -+ z sd, z the quantile that leaves (1 - level) / 2 on either side (level 0.95: 1.96).
/// Not a number throughout when sd is none. Throws Status::invalid_argument unless 0 < level < 1.
Interval normal_interval(double value, double sd, double level);

/// The minimal detectable change: what a measured change must reach to be told from none, as its
/// interval of that level then leaves zero out. An unchanged subject exceeds it, in either
/// direction, with probability 1 - level. z sd, in the unit of sd; not a number for such a sd.
/// Throws Status::invalid_argument unless 0 < level < 1.
double minimal_detectable_change(double sd, double level);

}  // namespace mien
