// What is known of the errors of fitted surfaces, for every room that reckons with them.
#pragma once

namespace mien {

/// Length l over which the errors of a fitted surface along its normal go together, mm: their
/// correlation at a distance d is exp(-d^2 / (2 l^2)). Chosen on four simulated people (seed 77)
/// and reported on twenty others (seed 78): injection study, tests/bench/README.md.
constexpr double kSurfaceCorrelationMm = 4.0;

}  // namespace mien
