// Incomplete beta by Lentz's continued fraction, incomplete gamma by series or continued fraction
// (Abramowitz & Stegun 26.5.8, 6.5.29, 6.5.31); quantiles by bisection, which needs no starting
// value and always ends.
#include "measure/distributions.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>

#include "base/error.hpp"

namespace mien {
namespace {

constexpr double kTiny = 1e-300;
constexpr double kEpsilon = 1e-16;

// Stirling's series after shifting the argument to at least 15 (A&S 6.1.40).
double log_gamma(double x) {
    double shift = 0.0;
    while (x < 15.0) {
        shift += std::log(x);
        x += 1.0;
    }
    const double inverse = 1.0 / x, square = inverse * inverse;
    const double series =
        inverse *
        (1.0 / 12 -
         square * (1.0 / 360 - square * (1.0 / 1260 - square * (1.0 / 1680 - square / 1188))));
    return (x - 0.5) * std::log(x) - x + 0.91893853320467274178 + series - shift;
}

double beta_fraction(double x, double a, double b) {
    double c = 1.0, d = 1.0 - (a + b) * x / (a + 1.0);
    if (std::fabs(d) < kTiny) d = kTiny;
    d = 1.0 / d;
    double result = d;
    for (int m = 1; m <= 10000; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        for (const double term : {even, odd}) {
            d = 1.0 + term * d;
            if (std::fabs(d) < kTiny) d = kTiny;
            c = 1.0 + term / c;
            if (std::fabs(c) < kTiny) c = kTiny;
            d = 1.0 / d;
            result *= c * d;
        }
        if (std::fabs(c * d - 1.0) < kEpsilon) break;
    }
    return result;
}

double regularised_beta(double x, double a, double b) {
    if (!(x > 0)) return 0.0;
    if (!(x < 1)) return 1.0;
    const double front = std::exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * std::log(x) +
                                  b * std::log1p(-x));
    if (x < (a + 1.0) / (a + b + 2.0)) return front * beta_fraction(x, a, b) / a;
    return 1.0 - front * beta_fraction(1.0 - x, b, a) / b;
}

double regularised_gamma(double a, double x) {
    if (!(x > 0)) return 0.0;
    const double front = std::exp(a * std::log(x) - x - log_gamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a, sum = term;
        for (int n = 1; n <= 100000; ++n) {
            term *= x / (a + n);
            sum += term;
            if (term < sum * kEpsilon) break;
        }
        return front * sum;
    }
    double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, result = d;
    for (int n = 1; n <= 100000; ++n) {
        const double numerator = -n * (n - a);
        b += 2.0;
        d = numerator * d + b;
        if (std::fabs(d) < kTiny) d = kTiny;
        c = b + numerator / c;
        if (std::fabs(c) < kTiny) c = kTiny;
        d = 1.0 / d;
        result *= c * d;
        if (std::fabs(c * d - 1.0) < kEpsilon) break;
    }
    return 1.0 - front * result;
}

template <typename Cdf>
double invert(double p, double low, double high, const Cdf& cdf) {
    for (int i = 0; i < 400; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (cdf(middle) < p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// The smallest power of two, from one on, whose cdf reaches p.
template <typename Cdf>
double upper_bracket(double p, const Cdf& cdf) {
    double high = 1.0;
    while (high < 1e300 && cdf(high) < p) high *= 2.0;
    return high;
}

void check_probability(double p) {
    if (!(p > 0.0 && p < 1.0))
        fail(Status::invalid_argument,
             "a probability of %g has no quantile; use one between 0 and 1", p);
}

void check_degrees(double degrees) {
    if (!(degrees > 0.0))
        fail(Status::invalid_argument, "%g degrees of freedom; at least one more sample is needed",
             degrees);
}

}  // namespace

double normal_cdf(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

double normal_quantile(double p) {
    check_probability(p);
    // The lower tail keeps its relative precision, so the upper one is mirrored.
    if (p > 0.5) return -normal_quantile(1.0 - p);
    return invert(p, -40.0, 0.0, [](double z) { return normal_cdf(z); });
}

double student_t_cdf(double t, double degrees) {
    check_degrees(degrees);
    const double tail = 0.5 * regularised_beta(degrees / (degrees + t * t), degrees / 2.0, 0.5);
    return t > 0 ? 1.0 - tail : tail;
}

double student_t_quantile(double p, double degrees) {
    check_probability(p);
    check_degrees(degrees);
    if (p > 0.5) return -student_t_quantile(1.0 - p, degrees);
    auto lower_tail = [degrees](double t) { return 1.0 - student_t_cdf(-t, degrees); };
    const double high = upper_bracket(1.0 - p, lower_tail);
    return invert(p, -high, 0.0, [degrees](double t) { return student_t_cdf(t, degrees); });
}

double f_cdf(double f, double degrees1, double degrees2) {
    check_degrees(degrees1);
    check_degrees(degrees2);
    if (!(f > 0)) return 0.0;
    return regularised_beta(degrees1 * f / (degrees1 * f + degrees2), degrees1 / 2, degrees2 / 2);
}

double f_quantile(double p, double degrees1, double degrees2) {
    check_probability(p);
    auto cdf = [=](double f) { return f_cdf(f, degrees1, degrees2); };
    return invert(p, 0.0, upper_bracket(p, cdf), cdf);
}

double chi_squared_cdf(double x, double degrees) {
    check_degrees(degrees);
    return regularised_gamma(degrees / 2.0, x / 2.0);
}

double chi_squared_quantile(double p, double degrees) {
    check_probability(p);
    auto cdf = [=](double x) { return chi_squared_cdf(x, degrees); };
    return invert(p, 0.0, upper_bracket(p, cdf), cdf);
}

double two_sided_p_value(double z) {
    return std::erfc(std::fabs(z) / std::sqrt(2.0));
}

}  // namespace mien
