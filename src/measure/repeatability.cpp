#include "measure/repeatability.hpp"

#include <cmath>

#include "base/error.hpp"
#include "measure/distributions.hpp"

namespace mien {
namespace {

void check_finite(const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            fail_at(Status::invalid_argument, static_cast<std::int64_t>(i),
                    "value %lld is not finite; leave out captures that failed",
                    static_cast<long long>(i));
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double centre) {
    double sum = 0.0;
    for (double v : values) sum += (v - centre) * (v - centre);
    return sum;
}

}  // namespace

Repeatability repeatability(const std::vector<std::vector<double>>& captures) {
    double squares = 0.0, degrees = 0.0;
    for (const std::vector<double>& values : captures) {
        check_finite(values);
        if (values.size() < 2) continue;
        squares += squares_about(values, mean_of(values));
        degrees += static_cast<double>(values.size() - 1);
    }
    if (!(degrees > 0))
        fail(Status::invalid_argument,
             "no subject was captured twice; repeatability needs repeated captures");
    Repeatability result;
    result.degrees = degrees;
    result.within_subject_sd = std::sqrt(squares / degrees);
    result.coefficient =
        student_t_quantile(0.975, degrees) * std::sqrt(2.0) * result.within_subject_sd;
    result.sd_low95 = std::sqrt(squares / chi_squared_quantile(0.975, degrees));
    result.sd_high95 = std::sqrt(squares / chi_squared_quantile(0.025, degrees));
    return result;
}

DetectionLimit detection_limit(const std::vector<double>& blanks) {
    check_finite(blanks);
    if (blanks.size() < 2)
        fail(Status::invalid_argument,
             "%zu blank measurements; a limit of detection needs two or more", blanks.size());
    DetectionLimit result;
    result.degrees = static_cast<double>(blanks.size() - 1);
    result.blank_mean = mean_of(blanks);
    result.blank_sd = std::sqrt(squares_about(blanks, result.blank_mean) / result.degrees);
    const double step = student_t_quantile(0.95, result.degrees) * result.blank_sd;
    result.limit_of_blank = std::fabs(result.blank_mean) + step;
    result.limit_of_detection = result.limit_of_blank + step;
    result.minimal_detectable_change =
        std::fabs(result.blank_mean) + student_t_quantile(0.975, result.degrees) * result.blank_sd;
    return result;
}

BlandAltman bland_altman(const std::vector<double>& first, const std::vector<double>& second) {
    if (first.size() != second.size() || first.size() < 3)
        fail(Status::invalid_argument,
             "Bland-Altman compares two equally long lists of three values or more; these have %zu "
             "and %zu",
             first.size(), second.size());
    check_finite(first);
    check_finite(second);
    const double n = static_cast<double>(first.size());
    std::vector<double> difference(first.size()), average(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        difference[i] = first[i] - second[i];
        average[i] = 0.5 * (first[i] + second[i]);
    }
    BlandAltman result;
    result.bias = mean_of(difference);
    const double squares = squares_about(difference, result.bias);
    result.sd = std::sqrt(squares / (n - 1));
    const double z = normal_quantile(0.975), t = student_t_quantile(0.975, n - 1);
    result.lower_limit = result.bias - z * result.sd;
    result.upper_limit = result.bias + z * result.sd;
    const double bias_half = t * result.sd / std::sqrt(n);
    result.bias_low95 = result.bias - bias_half;
    result.bias_high95 = result.bias + bias_half;
    // Bland & Altman 1999, 2.2: Var(limit) = (1/n + z^2 / (2 (n - 1))) sd^2.
    const double limit_half = t * result.sd * std::sqrt(1.0 / n + z * z / (2.0 * (n - 1)));
    result.lower_low95 = result.lower_limit - limit_half;
    result.lower_high95 = result.lower_limit + limit_half;
    result.upper_low95 = result.upper_limit - limit_half;
    result.upper_high95 = result.upper_limit + limit_half;
    const double centre = mean_of(average);
    double cross = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i)
        cross += (average[i] - centre) * (difference[i] - result.bias);
    const double spread = squares_about(average, centre);
    if (spread > 0) {
        result.slope = cross / spread;
        const double residual = std::fmax(0.0, squares - result.slope * cross);
        const double error = std::sqrt(residual / (n - 2) / spread);
        if (error > 0)
            result.slope_p_value = 2.0 * student_t_cdf(-std::fabs(result.slope / error), n - 2);
        else
            result.slope_p_value = result.slope == 0.0 ? 1.0 : 0.0;
    }
    return result;
}

Detection compare_with_limit(double change, double limit_of_detection) {
    return std::fabs(change) < limit_of_detection ? Detection::below_limit : Detection::detected;
}

}  // namespace mien
