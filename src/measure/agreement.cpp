#include "measure/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "measure/distributions.hpp"

namespace mien {
namespace {

void check_ratings(const Ratings& ratings, int num_grades) {
    if (num_grades < 2)
        fail(Status::invalid_argument, "%d grades; agreement needs at least two", num_grades);
    for (Index s = 0; s < ratings.rows(); ++s)
        for (Index r = 0; r < ratings.cols(); ++r)
            if (ratings(s, r) >= num_grades)
                fail_at(Status::invalid_argument, s,
                        "subject %lld has grade %d, but grades are 0 .. %d",
                        static_cast<long long>(s), ratings(s, r), num_grades - 1);
}

bool complete(const Ratings& ratings, Index subject) {
    return (ratings.row(subject).array() >= 0).all();
}

double agreement_weight(Index i, Index j, Index k, KappaWeights weights) {
    if (weights == KappaWeights::unweighted) return i == j ? 1.0 : 0.0;
    const double distance = std::fabs(static_cast<double>(i - j)) / static_cast<double>(k - 1);
    return 1.0 - (weights == KappaWeights::linear ? distance : distance * distance);
}

}  // namespace

Matrix confusion_matrix(const Ratings& ratings, Index rater_a, Index rater_b, int num_grades) {
    check_ratings(ratings, num_grades);
    if (rater_a < 0 || rater_b < 0 || rater_a >= ratings.cols() || rater_b >= ratings.cols())
        fail(Status::invalid_argument, "raters %lld and %lld, but there are %lld",
             static_cast<long long>(rater_a), static_cast<long long>(rater_b),
             static_cast<long long>(ratings.cols()));
    Matrix counts = Matrix::Zero(num_grades, num_grades);
    for (Index s = 0; s < ratings.rows(); ++s)
        if (ratings(s, rater_a) >= 0 && ratings(s, rater_b) >= 0)
            counts(ratings(s, rater_a), ratings(s, rater_b)) += 1.0;
    return counts;
}

double percent_agreement(const Ratings& ratings, int tolerance) {
    if (ratings.cols() < 2 || tolerance < 0)
        fail(Status::invalid_argument,
             "percent agreement needs two raters or more and a tolerance of zero or more");
    Index used = 0, agreed = 0;
    for (Index s = 0; s < ratings.rows(); ++s) {
        if (!complete(ratings, s)) continue;
        ++used;
        if (ratings.row(s).maxCoeff() - ratings.row(s).minCoeff() <= tolerance) ++agreed;
    }
    if (used == 0)
        fail(Status::invalid_argument, "no subject was graded by every rater; nothing to compare");
    return static_cast<double>(agreed) / static_cast<double>(used);
}

Kappa cohen_kappa(const Matrix& confusion, KappaWeights weights) {
    const Index k = confusion.rows();
    if (k < 2 || confusion.cols() != k || !confusion.allFinite() || confusion.minCoeff() < 0 ||
        !(confusion.sum() > 0))
        fail(Status::invalid_argument,
             "a confusion matrix is square, at least 2 x 2, with counts of zero or more, not all "
             "zero");
    const double n = confusion.sum();
    const Matrix p = confusion / n;
    const Vector rows = p.rowwise().sum(), cols = p.colwise().sum().transpose();
    Kappa result;
    result.num_subjects = static_cast<Index>(std::llround(n));
    Matrix w(k, k);
    for (Index i = 0; i < k; ++i)
        for (Index j = 0; j < k; ++j) w(i, j) = agreement_weight(i, j, k, weights);
    const double po = (w.array() * p.array()).sum();
    const double pe = rows.dot(w * cols);
    result.observed = po;
    result.expected = pe;
    if (!(1.0 - pe > 1e-15)) {
        result.kappa = result.z = result.standard_error = result.standard_error_null =
            result.low95 = result.high95 = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    result.kappa = (po - pe) / (1.0 - pe);
    // Fleiss, Cohen & Everitt 1969, (9) and (10), with the mean weights of each margin.
    const Vector mean_row = w * cols, mean_col = w.transpose() * rows;
    double null_sum = 0.0, sum = 0.0;
    for (Index i = 0; i < k; ++i)
        for (Index j = 0; j < k; ++j) {
            const double margins = mean_row[i] + mean_col[j];
            const double null_term = w(i, j) - margins;
            null_sum += rows[i] * cols[j] * null_term * null_term;
            const double term = w(i, j) * (1.0 - pe) - margins * (1.0 - po);
            sum += p(i, j) * term * term;
        }
    const double null_variance = (null_sum - pe * pe) / (n * (1 - pe) * (1 - pe));
    const double correction = po * pe - 2.0 * pe + po;
    const double variance = (sum - correction * correction) / (n * std::pow(1 - pe, 4));
    result.standard_error_null = std::sqrt(std::max(0.0, null_variance));
    result.standard_error = std::sqrt(std::max(0.0, variance));
    if (result.standard_error_null > 0) {
        result.z = result.kappa / result.standard_error_null;
        result.p_value = two_sided_p_value(result.z);
    }
    const double half = normal_quantile(0.975) * result.standard_error;
    result.low95 = std::max(-1.0, result.kappa - half);
    result.high95 = std::min(1.0, result.kappa + half);
    return result;
}

FleissKappa fleiss_kappa(const Ratings& ratings, int num_grades) {
    check_ratings(ratings, num_grades);
    const double raters = static_cast<double>(ratings.cols());
    Matrix counts = Matrix::Zero(ratings.rows(), num_grades);
    Index n = 0;
    for (Index s = 0; s < ratings.rows(); ++s) {
        if (!complete(ratings, s)) continue;
        for (Index r = 0; r < ratings.cols(); ++r) counts(n, ratings(s, r)) += 1.0;
        ++n;
    }
    if (ratings.cols() < 2 || n < 2)
        fail(
            Status::invalid_argument,
            "Fleiss' kappa needs two raters and two completely graded subjects; there are %lld and "
            "%lld",
            static_cast<long long>(ratings.cols()), static_cast<long long>(n));
    counts.conservativeResize(n, Eigen::NoChange);
    const double cells = static_cast<double>(n) * raters;
    const Vector share = counts.colwise().sum().transpose() / cells;
    const double pairs = cells * (raters - 1.0);
    const double observed = (counts.array().square().sum() - cells) / pairs;
    const double expected = share.squaredNorm();
    FleissKappa result;
    result.num_subjects = n;
    result.kappa_per_grade = Vector::Constant(num_grades, std::numeric_limits<double>::quiet_NaN());
    result.z_per_grade = result.kappa_per_grade;
    if (!(1.0 - expected > 1e-15)) {
        result.kappa = result.z = result.standard_error_null =
            std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    result.kappa = (observed - expected) / (1.0 - expected);
    const Vector pq = share.array() * (1.0 - share.array());
    const double spread = pq.sum() * pq.sum() - (pq.array() * (1.0 - 2.0 * share.array())).sum();
    result.standard_error_null =
        std::sqrt(2.0 / pairs) * std::sqrt(std::max(0.0, spread)) / pq.sum();
    if (result.standard_error_null > 0) {
        result.z = result.kappa / result.standard_error_null;
        result.p_value = two_sided_p_value(result.z);
    }
    for (int grade = 0; grade < num_grades; ++grade) {
        if (!(pq[grade] > 0)) continue;
        const double disagreement =
            (counts.col(grade).array() * (raters - counts.col(grade).array())).sum();
        result.kappa_per_grade[grade] = 1.0 - disagreement / (pairs * pq[grade]);
        result.z_per_grade[grade] = result.kappa_per_grade[grade] / std::sqrt(2.0 / pairs);
    }
    return result;
}

std::vector<int> majority_grades(const Ratings& ratings, int num_grades) {
    check_ratings(ratings, num_grades);
    std::vector<int> result;
    std::vector<int> votes(static_cast<std::size_t>(num_grades));
    for (Index s = 0; s < ratings.rows(); ++s) {
        std::fill(votes.begin(), votes.end(), 0);
        double sum = 0.0;
        int given = 0;
        for (Index r = 0; r < ratings.cols(); ++r)
            if (ratings(s, r) >= 0) {
                ++votes[static_cast<std::size_t>(ratings(s, r))];
                sum += ratings(s, r);
                ++given;
            }
        int best = -1;
        for (int g = 0; given > 0 && g < num_grades; ++g) {
            const int have = votes[static_cast<std::size_t>(g)];
            if (have == 0) continue;
            const int best_votes = best < 0 ? 0 : votes[static_cast<std::size_t>(best)];
            const double mean = sum / given;
            if (have > best_votes ||
                (have == best_votes && std::fabs(g - mean) < std::fabs(best - mean)))
                best = g;
        }
        result.push_back(best);
    }
    return result;
}

PairwiseAgreement pairwise_agreement(const Ratings& ratings, int num_grades, KappaWeights weights) {
    const Index raters = ratings.cols();
    if (raters < 2) fail(Status::invalid_argument, "pairwise agreement needs two raters or more");
    PairwiseAgreement result;
    result.kappa = Matrix::Identity(raters, raters);
    result.percent = Matrix::Identity(raters, raters);
    int pairs = 0;
    for (Index a = 0; a < raters; ++a)
        for (Index b = a + 1; b < raters; ++b) {
            const Matrix counts = confusion_matrix(ratings, a, b, num_grades);
            if (!(counts.sum() > 0))
                fail(Status::invalid_argument, "raters %lld and %lld graded no subject in common",
                     static_cast<long long>(a), static_cast<long long>(b));
            result.kappa(a, b) = result.kappa(b, a) = cohen_kappa(counts, weights).kappa;
            result.percent(a, b) = result.percent(b, a) = counts.trace() / counts.sum();
            result.mean_kappa += result.kappa(a, b);
            result.mean_percent += result.percent(a, b);
            ++pairs;
        }
    result.mean_kappa /= pairs;
    result.mean_percent /= pairs;
    return result;
}

}  // namespace mien
