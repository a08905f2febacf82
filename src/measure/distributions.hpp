// Distribution functions and quantiles that intervals and tests need: normal, Student t, F,
// chi-squared. Relative error below 1e-12 over the range used here; no global state (std::lgamma
// writes one on some platforms).
#pragma once

namespace mien {

double normal_cdf(double z);
/// p in (0, 1), otherwise Status::invalid_argument; the same for the quantiles below.
double normal_quantile(double p);
double student_t_cdf(double t, double degrees);
double student_t_quantile(double p, double degrees);
double f_cdf(double f, double degrees1, double degrees2);
double f_quantile(double p, double degrees1, double degrees2);
double chi_squared_cdf(double x, double degrees);
double chi_squared_quantile(double p, double degrees);
/// Probability that |Z| >= |z| for a standard normal Z.
double two_sided_p_value(double z);

}  // namespace mien
