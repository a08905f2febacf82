#include "measure/repeatability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "measure/distributions.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

void expect_relative(double value, double truth) {
    EXPECT_NEAR(value, truth, 1e-12 * std::fabs(truth));
}

TEST(Distributions, MatchR) {  // R 4.2.2: qt, qf, qchisq, qnorm, pf, pt, pchisq
    expect_relative(student_t_quantile(0.975, 3), 3.1824463052837078);
    expect_relative(student_t_quantile(0.95, 1), 6.3137515146750376);
    expect_relative(student_t_quantile(0.001, 2), -22.327124770119873);
    expect_relative(f_quantile(0.975, 5, 18.5), 3.3565800692237557);
    expect_relative(chi_squared_quantile(0.025, 7), 1.6898691806773545);
    expect_relative(normal_quantile(0.975), 1.9599639845400536);
    expect_relative(normal_quantile(1e-10), -6.3613409024040557);
    expect_relative(f_cdf(3.3, 4, 11), 0.94767186617412791);
    expect_relative(student_t_cdf(-2.7, 6.5), 0.016446624589517646);
    expect_relative(chi_squared_cdf(3.2, 4), 0.47506905321389592);
}

TEST(Distributions, RefuseProbabilitiesAndDegreesOutOfRange) {
    for (double p : {0.0, 1.0, -0.1, std::nan("")})
        EXPECT_EQ(test::status_of([&] { normal_quantile(p); }), Status::invalid_argument);
    EXPECT_EQ(test::status_of([&] { student_t_quantile(0.5, 0); }), Status::invalid_argument);
}

TEST(Repeatability, PoolsTheWithinSubjectVariance) {
    // Variances 2 (one degree) and 1 (two degrees): pooled 4 / 3.
    const Repeatability r = repeatability({{10, 12}, {5, 6, 7}, {99}});
    EXPECT_NEAR(r.within_subject_sd, std::sqrt(4.0 / 3.0), 1e-14);
    EXPECT_EQ(r.degrees, 3.0);
    EXPECT_NEAR(r.coefficient, 3.1824463052837078 * std::sqrt(2.0) * std::sqrt(4.0 / 3.0), 1e-12);
    EXPECT_LT(r.sd_low95, r.within_subject_sd);
    EXPECT_GT(r.sd_high95, r.within_subject_sd);
    EXPECT_EQ(test::status_of([] { repeatability({{1}, {2}}); }), Status::invalid_argument);
    EXPECT_EQ(test::status_of([] {
                  repeatability({{1, std::nan("")}});
              }),
              Status::invalid_argument);
}

TEST(DetectionLimit, AddsTheBlanksBiasAndTwoSteps) {
    const DetectionLimit limit = detection_limit({-0.1, 0.3, 0.1});
    EXPECT_NEAR(limit.blank_mean, 0.1, 1e-15);
    EXPECT_NEAR(limit.blank_sd, 0.2, 1e-15);
    const double step = student_t_quantile(0.95, 2) * 0.2;
    EXPECT_NEAR(limit.limit_of_blank, 0.1 + step, 1e-14);
    EXPECT_NEAR(limit.limit_of_detection, 0.1 + 2 * step, 1e-14);
    EXPECT_NEAR(limit.minimal_detectable_change, 0.1 + student_t_quantile(0.975, 2) * 0.2, 1e-14);
    EXPECT_EQ(compare_with_limit(-0.5, limit.limit_of_detection), Detection::below_limit);
    EXPECT_EQ(compare_with_limit(-5.0, limit.limit_of_detection), Detection::detected);
    EXPECT_EQ(test::status_of([] { detection_limit({0.1}); }), Status::invalid_argument);
}

TEST(BlandAltman, MatchesThePublishedPeakFlowExample) {
    // Bland & Altman 1986, table 1: Wright and mini peak flow meter, first readings of 17 subjects;
    // published: bias -2.1 l/min, sd 38.8, limits -79.7 to 75.5 (with 2 sd).
    const std::vector<double> wright{494, 395, 516, 434, 476, 557, 413, 442, 650,
                                     433, 417, 656, 267, 478, 178, 423, 427};
    const std::vector<double> mini{512, 430, 520, 428, 500, 600, 364, 380, 658,
                                   445, 432, 626, 260, 477, 259, 350, 451};
    const BlandAltman b = bland_altman(wright, mini);
    EXPECT_NEAR(b.bias, -2.1, 0.05);
    EXPECT_NEAR(b.sd, 38.8, 0.05);
    EXPECT_NEAR(b.bias - 2 * b.sd, -79.7, 0.1);
    EXPECT_NEAR(b.bias + 2 * b.sd, 75.5, 0.1);
    EXPECT_NEAR(b.bias_low95, -22.0, 0.1);  // published interval of the bias
    EXPECT_NEAR(b.bias_high95, 17.8, 0.1);
    EXPECT_GT(b.slope_p_value, 0.1);
    EXPECT_EQ(test::status_of([&] { bland_altman(wright, {1, 2}); }), Status::invalid_argument);
}

TEST(BlandAltman, SeesABiasThatGrowsWithTheSize) {
    std::vector<double> first, second;
    for (int i = 1; i <= 20; ++i) {
        second.push_back(i);
        first.push_back(1.2 * i + 0.05 * std::sin(7.0 * i));
    }
    const BlandAltman b = bland_altman(first, second);
    EXPECT_NEAR(b.slope, 0.2 / 1.1, 0.01);
    EXPECT_LT(b.slope_p_value, 1e-6);
}

}  // namespace
}  // namespace mien
