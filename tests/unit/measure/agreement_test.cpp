#include "measure/agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "measure/icc.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

// Fleiss, Cohen & Everitt 1969, table 1, as counts of 200.
Matrix diagnoses() {
    Matrix counts(3, 3);
    counts << 88, 14, 18, 10, 40, 10, 2, 6, 12;
    return counts;
}

// Ten subjects graded by fourteen raters into five grades: the usual worked example of Fleiss'
// kappa, spread out from its table of counts.
Ratings fourteen_raters() {
    const int counts[10][5] = {{0, 0, 0, 0, 14}, {0, 2, 6, 4, 2}, {0, 0, 3, 5, 6}, {0, 3, 9, 2, 0},
                               {2, 2, 8, 1, 1},  {7, 7, 0, 0, 0}, {3, 2, 6, 3, 0}, {2, 5, 3, 2, 2},
                               {6, 5, 2, 1, 0},  {0, 2, 2, 3, 7}};
    Ratings ratings(10, 14);
    for (Index s = 0; s < 10; ++s) {
        Index column = 0;
        for (int grade = 0; grade < 5; ++grade)
            for (int i = 0; i < counts[s][grade]; ++i) ratings(s, column++) = grade;
    }
    return ratings;
}

TEST(Kappa, MatchesPublishedDiagnosesAndRPsych) {
    // Expected values: R psych 2.2.9, cohen.kappa(); the null error: Fleiss, Levin & Paik 2003,
    // (18.16), in exact fractions; the weighted errors: the delta method in exact fractions (psych
    // departs from it there).
    const Kappa plain = cohen_kappa(diagnoses(), KappaWeights::unweighted);
    EXPECT_NEAR(plain.kappa, 0.49152542372881347, 1e-10);
    EXPECT_NEAR(plain.standard_error * plain.standard_error, 0.0026011851920562587, 1e-10);
    EXPECT_NEAR(plain.observed, 0.70, 1e-12);
    EXPECT_NEAR(plain.expected, 0.41, 1e-12);
    EXPECT_NEAR(plain.standard_error_null, 0.05197893635659544, 1e-10);
    EXPECT_LT(plain.p_value, 1e-15);
    const Kappa linear = cohen_kappa(diagnoses(), KappaWeights::linear);
    EXPECT_NEAR(linear.kappa, 0.47368421052631593, 1e-10);
    EXPECT_NEAR(linear.standard_error * linear.standard_error, 0.002962876282410356, 1e-10);
    const Kappa quadratic = cohen_kappa(diagnoses(), KappaWeights::quadratic);
    EXPECT_NEAR(quadratic.kappa, 0.45454545454545431, 1e-10);
    EXPECT_NEAR(quadratic.standard_error * quadratic.standard_error, 0.004416091797008401, 1e-10);
    EXPECT_LT(quadratic.low95, quadratic.kappa);
    EXPECT_GT(quadratic.high95, quadratic.kappa);
}

TEST(Kappa, IsOneForFullAgreementAndZeroForIndependence) {
    EXPECT_DOUBLE_EQ(
        cohen_kappa(Vector::LinSpaced(4, 3, 9).asDiagonal(), KappaWeights::linear).kappa, 1.0);
    const Vector rows = Vector::LinSpaced(3, 1, 3), cols = Vector::LinSpaced(3, 2, 6);
    const Kappa independent = cohen_kappa(rows * cols.transpose(), KappaWeights::unweighted);
    EXPECT_NEAR(independent.kappa, 0.0, 1e-15);
    EXPECT_NEAR(independent.p_value, 1.0, 1e-12);
}

TEST(Kappa, IsNotANumberWhenEveryoneGivesTheSameGrade) {
    Matrix one = Matrix::Zero(2, 2);
    one(0, 0) = 7;
    EXPECT_TRUE(std::isnan(cohen_kappa(one, KappaWeights::unweighted).kappa));
}

TEST(Kappa, RefusesWhatIsNotAConfusionMatrix) {
    Matrix negative = diagnoses();
    negative(1, 1) = -1;
    for (const Matrix& bad : {negative, Matrix(Matrix::Ones(2, 3)), Matrix(Matrix::Zero(3, 3)),
                              Matrix(Matrix::Ones(1, 1))})
        EXPECT_EQ(test::status_of([&] { cohen_kappa(bad, KappaWeights::linear); }),
                  Status::invalid_argument);
}

TEST(FleissKappa, MatchesTheWorkedExampleInExactFractions) {
    const FleissKappa fleiss = fleiss_kappa(fourteen_raters(), 5);
    EXPECT_NEAR(fleiss.kappa, 0.20993070442195524, 1e-10);
    EXPECT_NEAR(fleiss.standard_error_null, 0.01696506922439313, 1e-10);
    const double per_grade[5] = {0.2012820512820513, 0.07967032967032966, 0.17159763313609466,
                                 0.030381383322559793, 0.5076566951566952};
    for (int g = 0; g < 5; ++g) EXPECT_NEAR(fleiss.kappa_per_grade[g], per_grade[g], 1e-10);
}

TEST(FleissKappa, OfTwoRatersIsScottsPi) {
    Ratings ratings(6, 2);
    ratings << 0, 0, 1, 1, 2, 1, 0, 0, 2, 2, 1, 0;
    // Scott's pi: pooled margins 5/12, 4/12, 3/12, agreement 4/6.
    const double expected = (25.0 + 16.0 + 9.0) / 144.0;
    EXPECT_NEAR(fleiss_kappa(ratings, 3).kappa, (4.0 / 6.0 - expected) / (1 - expected), 1e-14);
}

TEST(FleissKappa, LeavesOutSubjectsWithAMissingGrade) {
    Ratings whole = fourteen_raters(), more(11, 14);
    more << whole, Ratings::Constant(1, 14, 3);
    more(10, 5) = -1;
    EXPECT_EQ(fleiss_kappa(more, 5).kappa, fleiss_kappa(whole, 5).kappa);
    EXPECT_EQ(fleiss_kappa(more, 5).num_subjects, 10);
}

TEST(Agreement, CountsConfusionAndPercent) {
    Ratings ratings(5, 3);
    ratings << 0, 0, 0, 1, 2, 1, 3, 3, 3, 4, 2, 3, -1, 1, 1;
    EXPECT_EQ(confusion_matrix(ratings, 0, 1, 5).sum(), 4.0);
    EXPECT_EQ(confusion_matrix(ratings, 0, 1, 5)(1, 2), 1.0);
    EXPECT_EQ(confusion_matrix(ratings, 1, 2, 5).sum(), 5.0);
    EXPECT_DOUBLE_EQ(percent_agreement(ratings, 0), 0.5);
    EXPECT_DOUBLE_EQ(percent_agreement(ratings, 1), 0.75);
    EXPECT_EQ(test::status_of([&] { confusion_matrix(ratings, 0, 3, 5); }),
              Status::invalid_argument);
    EXPECT_EQ(test::status_of([&] { confusion_matrix(ratings, 0, 1, 4); }),
              Status::invalid_argument);
}

TEST(Agreement, MajorityTakesTheTieNearestToTheMean) {
    Ratings ratings(4, 4);
    ratings << 0, 0, 3, 1, 4, 4, 1, 1, 0, 1, 2, 4, -1, -1, -1, -1;
    EXPECT_EQ(majority_grades(ratings, 5), (std::vector<int>{0, 1, 2, -1}));
}

TEST(Agreement, PairwiseMeansAreThoseOfThePairs) {
    Ratings ratings(6, 3);
    ratings << 0, 0, 1, 1, 1, 1, 2, 1, 2, 0, 0, 0, 2, 2, 2, 1, 0, 1;
    const PairwiseAgreement pairs = pairwise_agreement(ratings, 3, KappaWeights::quadratic);
    double sum = 0.0;
    for (auto pair : {std::pair<Index, Index>{0, 1}, {0, 2}, {1, 2}})
        sum += cohen_kappa(confusion_matrix(ratings, pair.first, pair.second, 3),
                           KappaWeights::quadratic)
                   .kappa;
    EXPECT_NEAR(pairs.mean_kappa, sum / 3, 1e-14);
    EXPECT_NEAR(pairs.mean_percent, (4.0 + 5.0 + 3.0) / 18.0, 1e-14);
}

TEST(IntraclassCorrelation, MatchesShroutAndFleissAndRPsych) {
    // Shrout & Fleiss 1979, table 2; expected values printed by R psych 2.2.9, ICC(lmer = FALSE).
    Matrix scores(6, 4);
    scores << 9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7;
    const IccReport r = intraclass_correlation(scores);
    const double expected[6][5] = {{0.1657417684054756, 1.794678492239469, 0.1647688083446396,
                                    -0.1329323248747509, 0.7225600623281211},
                                   {0.2897637795275592, 11.02724795640327, 0.0001345665164843369,
                                    0.01878651337471205, 0.7610843696489531},
                                   {0.7148407148407149, 11.02724795640327, 0.0001345665164843369,
                                    0.3424647650339254, 0.9458582599553595},
                                   {0.4427971336792689, 1.794678492239469, 0.1647688083446396,
                                    -0.884442155238119, 0.9124154203407756},
                                   {0.6200505475989893, 11.02724795640327, 0.0001345665164843369,
                                    0.07113681530250349, 0.927232040167722},
                                   {0.9093155423770695, 11.02724795640327, 0.0001345665164843369,
                                    0.6756747138163047, 0.9858916781690623}};
    const IntraclassCorrelation* forms[6] = {&r.icc1,  &r.icc2,  &r.icc3,
                                             &r.icc1k, &r.icc2k, &r.icc3k};
    for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(forms[i]->icc, expected[i][0], 1e-10) << i;
        EXPECT_NEAR(forms[i]->f, expected[i][1], 1e-10) << i;
        EXPECT_NEAR(forms[i]->p_value, expected[i][2], 1e-10) << i;
        EXPECT_NEAR(forms[i]->low, expected[i][3], 1e-10) << i;
        EXPECT_NEAR(forms[i]->high, expected[i][4], 1e-10) << i;
    }
}

TEST(IntraclassCorrelation, ConsistencyForgivesAnOffsetThatAgreementDoesNot) {
    Matrix scores(5, 2);
    scores << 1, 4, 2, 5, 3, 6, 7, 10, 9, 12;
    const IccReport r = intraclass_correlation(scores);
    EXPECT_NEAR(r.icc3.icc, 1.0, 1e-14);
    EXPECT_LT(r.icc2.icc, 0.8);
}

TEST(IntraclassCorrelation, RefusesTablesItCannotUse) {
    Matrix scores = Matrix::Ones(3, 2);
    EXPECT_EQ(test::status_of([&] { intraclass_correlation(scores); }), Status::no_solution);
    EXPECT_EQ(test::status_of([&] { intraclass_correlation(Matrix::Ones(1, 4)); }),
              Status::invalid_argument);
    scores(0, 0) = std::nan("");
    EXPECT_EQ(test::status_of([&] { intraclass_correlation(scores); }), Status::invalid_argument);
}

}  // namespace
}  // namespace mien
