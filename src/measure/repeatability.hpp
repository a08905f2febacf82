// What repeated captures say about a measure: within-subject deviation, repeatability coefficient,
// limit of detection, and the Bland-Altman comparison of two methods.
//
// Sources: Bland & Altman 1986 and 1999; Currie 1968 and CLSI EP17 for blank and detection limits.
#pragma once

#include <vector>

#include "base/types.hpp"

namespace mien {

struct Repeatability {
    double within_subject_sd = 0.0;  ///< root of the pooled within-subject variance
    double degrees = 0.0;
    /// Two captures of an unchanged subject differ by less than this in 95 % of cases:
    /// t(0.975) sqrt(2) sd. Also the smallest change of one subject that can be called real.
    double coefficient = 0.0;
    double sd_low95 = 0.0, sd_high95 = 0.0;  ///< chi-squared interval of the deviation
};

/// captures[s]: the values of subject s, one per capture; subjects with one capture add nothing.
/// Throws Status::invalid_argument when no subject has two, or a value is not finite.
Repeatability repeatability(const std::vector<std::vector<double>>& captures);

struct DetectionLimit {
    double blank_mean = 0.0;  ///< bias: what is measured when nothing changed
    double blank_sd = 0.0;
    double limit_of_blank = 0.0;      ///< blank_mean + z(0.95) sd: exceeded by 5 % of blanks
    double limit_of_detection = 0.0;  ///< limit_of_blank + z(0.95) sd: missed in 5 % of cases
    /// blank_mean + z(0.975) sd: what a measured change must exceed to be called real, either way.
    double minimal_detectable_change = 0.0;
    double degrees = 0.0;
};

/// Signed changes measured where the truth is zero (repeated captures of one visit, every pair
/// once, registered and measured as patients are). Few blanks are paid for: z becomes Student's t.
/// The limits hold for |change|: |blank_mean| is used.
DetectionLimit detection_limit(const std::vector<double>& blanks);

struct BlandAltman {
    double bias = 0.0;  ///< mean of first - second
    double sd = 0.0;
    double lower_limit = 0.0, upper_limit = 0.0;  ///< bias -+ 1.96 sd
    double bias_low95 = 0.0, bias_high95 = 0.0;
    double lower_low95 = 0.0, lower_high95 = 0.0;  ///< interval of the lower limit
    double upper_low95 = 0.0, upper_high95 = 0.0;
    double slope = 0.0;  ///< of the difference over the mean: does the bias grow with the size?
    double slope_p_value = 1.0;
};

/// Two methods (or two captures) on the same subjects, three subjects or more.
BlandAltman bland_altman(const std::vector<double>& first, const std::vector<double>& second);

/// The verdict that goes beside every reported change.
enum class Detection { below_limit, detected };
Detection compare_with_limit(double change, double limit_of_detection);

}  // namespace mien
