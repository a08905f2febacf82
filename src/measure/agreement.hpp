// How far raters agree on grades: confusion matrix, percent agreement, Cohen's kappa (plain,
// linear, quadratic), Fleiss' kappa. The same functions serve intra-rater agreement: the "raters"
// are then one rater's sessions.
//
// Sources: Cohen 1960 and 1968; Fleiss, Cohen & Everitt 1969 (large-sample errors); Fleiss 1971 and
// Fleiss, Nee & Landis 1979 (errors of the many-rater kappa).
#pragma once

#include <vector>

#include "base/types.hpp"

namespace mien {

/// Subjects x raters; grades are 0 .. num_grades - 1, a negative entry is missing.
using Ratings = Eigen::Matrix<std::int32_t, Eigen::Dynamic, Eigen::Dynamic>;

/// num_grades x num_grades counts, rows: first rater. Subjects that either missed are left out.
Matrix confusion_matrix(const Ratings& ratings, Index rater_a, Index rater_b, int num_grades);

/// Share of subjects, 0 .. 1, for which all raters lie within `tolerance` grades of each other;
/// subjects with a missing grade are left out. Throws Status::invalid_argument when none is left.
double percent_agreement(const Ratings& ratings, int tolerance);

enum class KappaWeights { unweighted, linear, quadratic };

struct Kappa {
    double kappa = 0.0;                ///< not a number when chance agreement is perfect
    double observed = 0.0;             ///< weighted agreement, 0 .. 1
    double expected = 0.0;             ///< by chance
    double standard_error = 0.0;       ///< for intervals
    double standard_error_null = 0.0;  ///< under no agreement, for the test
    double z = 0.0;
    double p_value = 1.0;
    double low95 = 0.0, high95 = 0.0;  ///< normal approximation, cut at -1 and 1
    Index num_subjects = 0;
};

/// From a confusion matrix of counts. Throws Status::invalid_argument for a matrix that is not
/// square, holds a negative or not-finite count, or is empty.
Kappa cohen_kappa(const Matrix& confusion, KappaWeights weights);

struct FleissKappa {
    double kappa = 0.0;
    double standard_error_null = 0.0;
    double z = 0.0;
    double p_value = 1.0;
    Vector kappa_per_grade;  ///< each grade against all others
    Vector z_per_grade;
    Index num_subjects = 0;  ///< without missing grades
};

/// At least two raters and two subjects without missing grades.
FleissKappa fleiss_kappa(const Ratings& ratings, int num_grades);

/// The grade that most raters gave; ties go to the grade nearest to the mean, then to the lower.
/// Subjects without any grade get -1.
std::vector<int> majority_grades(const Ratings& ratings, int num_grades);

/// Mean over all pairs of raters of cohen_kappa and of the exact agreement (Light 1971).
struct PairwiseAgreement {
    double mean_kappa = 0.0;
    double mean_percent = 0.0;
    Matrix kappa;    ///< raters x raters, one on the diagonal
    Matrix percent;  ///< raters x raters, 0 .. 1
};
PairwiseAgreement pairwise_agreement(const Ratings& ratings, int num_grades, KappaWeights weights);

}  // namespace mien
