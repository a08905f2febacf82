#include "measure/icc.hpp"

#include <cmath>

#include "base/error.hpp"
#include "measure/distributions.hpp"

namespace mien {
namespace {

IntraclassCorrelation test_of(double icc, double f, double degrees1, double degrees2) {
    IntraclassCorrelation result;
    result.icc = icc;
    result.f = f;
    result.degrees1 = degrees1;
    result.degrees2 = degrees2;
    // 1 - F(f; a, b) = F(1/f; b, a), without cancellation.
    result.p_value = f > 0 ? f_cdf(1.0 / f, degrees2, degrees1) : 1.0;
    return result;
}

// One-way and consistency forms share their interval: F / F_quantile, F * F_quantile.
void interval_from_f(IntraclassCorrelation& single, IntraclassCorrelation& mean, double k,
                     double tail) {
    const double low_f = single.f / f_quantile(1 - tail, single.degrees1, single.degrees2);
    const double high_f = single.f * f_quantile(1 - tail, single.degrees2, single.degrees1);
    single.low = (low_f - 1) / (low_f + k - 1);
    single.high = (high_f - 1) / (high_f + k - 1);
    mean.low = 1 - 1 / low_f;
    mean.high = 1 - 1 / high_f;
}

}  // namespace

IccReport intraclass_correlation(const Eigen::Ref<const Matrix>& scores, double confidence) {
    const Index n_subjects = scores.rows(), n_raters = scores.cols();
    if (n_subjects < 2 || n_raters < 2 || !scores.allFinite())
        fail(
            Status::invalid_argument,
            "intraclass correlation needs a complete table of two subjects and two raters or more; "
            "this one is %lld x %lld",
            static_cast<long long>(n_subjects), static_cast<long long>(n_raters));
    if (!(confidence > 0 && confidence < 1))
        fail(Status::invalid_argument, "confidence %g; use a number between 0 and 1", confidence);
    const double n = static_cast<double>(n_subjects), k = static_cast<double>(n_raters);
    const double grand = scores.mean();
    const Vector subject_mean = scores.rowwise().mean();
    const Vector rater_mean = scores.colwise().mean().transpose();
    const double subjects = k * (subject_mean.array() - grand).square().sum();
    const double raters = n * (rater_mean.array() - grand).square().sum();
    const double within = (scores.colwise() - subject_mean).array().square().sum();
    // Residuals directly, not as a difference of sums of squares.
    const double error = ((scores.colwise() - subject_mean).rowwise() -
                          (rater_mean.array() - grand).matrix().transpose())
                             .array()
                             .square()
                             .sum();
    if (!(subjects + within > 0))
        fail(Status::no_solution, "every score is equal; intraclass correlation is undefined");
    IccReport report;
    const double msb = report.mean_square_subjects = subjects / (n - 1);
    const double msj = report.mean_square_raters = raters / (k - 1);
    const double msw = report.mean_square_within = within / (n * (k - 1));
    const double mse = report.mean_square_error = error / ((n - 1) * (k - 1));

    const double df_within = n * (k - 1), df_error = (n - 1) * (k - 1);
    report.icc1 = test_of((msb - msw) / (msb + (k - 1) * msw), msb / msw, n - 1, df_within);
    report.icc1k = test_of((msb - msw) / msb, msb / msw, n - 1, df_within);
    report.icc2 = test_of((msb - mse) / (msb + (k - 1) * mse + k * (msj - mse) / n), msb / mse,
                          n - 1, df_error);
    report.icc2k = test_of((msb - mse) / (msb + (msj - mse) / n), msb / mse, n - 1, df_error);
    report.icc3 = test_of((msb - mse) / (msb + (k - 1) * mse), msb / mse, n - 1, df_error);
    report.icc3k = test_of((msb - mse) / msb, msb / mse, n - 1, df_error);

    const double tail = (1 - confidence) / 2;
    if (msw > 0) interval_from_f(report.icc1, report.icc1k, k, tail);
    if (mse > 0) {
        interval_from_f(report.icc3, report.icc3k, k, tail);
        // Absolute agreement: Satterthwaite degrees (McGraw & Wong 1996, table 7).
        const double rho = report.icc2.icc, fj = msj / mse;
        const double top = k * rho * fj + n * (1 + (k - 1) * rho) - k * rho;
        const double bottom =
            (n - 1) * k * k * rho * rho * fj * fj + std::pow(n * (1 + (k - 1) * rho) - k * rho, 2);
        const double v = df_error * top * top / bottom;
        const double upper = f_quantile(1 - tail, n - 1, v), lower = f_quantile(1 - tail, v, n - 1);
        const double c = k * msj + (k * n - k - n) * mse;
        report.icc2.low = n * (msb - upper * mse) / (upper * c + n * msb);
        report.icc2.high = n * (lower * msb - mse) / (c + n * lower * msb);
        report.icc2k.low = report.icc2.low * k / (1 + report.icc2.low * (k - 1));
        report.icc2k.high = report.icc2.high * k / (1 + report.icc2.high * (k - 1));
    } else {
        report.icc3.low = report.icc3.high = report.icc3k.low = report.icc3k.high = 1.0;
        report.icc2.low = report.icc2.high = report.icc2.icc;
        report.icc2k.low = report.icc2k.high = report.icc2k.icc;
    }
    if (!(msw > 0)) report.icc1.low = report.icc1.high = report.icc1k.low = report.icc1k.high = 1.0;
    return report;
}

}  // namespace mien
