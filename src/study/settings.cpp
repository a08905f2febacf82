#include "study/settings.hpp"

#include <cmath>

#include "base/error.hpp"

namespace mien {
namespace {

void require(double value, double low, double high, const char* name) {
    if (!(value >= low) || !(value <= high))
        fail(Status::invalid_argument, "%s is %g; give %g to %g", name, value, low, high);
}

constexpr double kLongestMm = 1000.0;  ///< no length of a face is longer

}  // namespace

void check_study_settings(const StudySettings& settings) {
    require(settings.surface.noise_mm, 0, kLongestMm, "noise_mm");
    require(settings.surface.correlation_length_mm, 0, kLongestMm, "correlation_length_mm");
    require(settings.surface.slide_correlation_mm, 0, kLongestMm, "slide_correlation_mm");
    require(settings.surface.unseen_apart_share, 0, 1, "unseen_apart_share");
    require(settings.surface.common_bias_mm, 0, kLongestMm, "common_bias_mm");
    require(settings.expression.posterior_factor, 0, 1000, "posterior_factor");
    require(settings.expression.untrained_share, 0, 1000, "untrained_share");
    require(settings.zones.margin_mm, 0, 100, "margin_mm");
    require(settings.reporting.min_seen_share, 0, 1, "min_seen_share");
    require(settings.reporting.least_seen_weight, 0, 1, "least_seen_weight");
    require(settings.reporting.max_outside_share, 0, 1, "max_outside_share");
    if (!(settings.reporting.level > 0) || !(settings.reporting.level < 1))
        fail(Status::invalid_argument, "level is %g; give one above 0 and below 1",
             settings.reporting.level);
}

}  // namespace mien
