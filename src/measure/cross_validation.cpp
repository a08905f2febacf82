// Cross-validation of partial least squares over groups, with the one-standard-error rule.
#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "measure/pls.hpp"
#include "measure/random.hpp"

namespace mien {
namespace {

// Columns that one step of a Gram matrix takes: a cancel is heard between two.
constexpr Index kGramColumns = 2048;

// X0 = Z V' with orthonormal V, X0 the centred columns of x, each times its factor (none: 1):
// everything PLS needs of X0 is in Z. From the Gram matrix's eigenvectors; directions below the
// rounding of the Gram matrix are nothing that PLS would use.
Matrix principal_coordinates(const ConstMatrixRef& x, const Vector& factors,
                             const Context& context) {
    if (x.cols() <= x.rows() && factors.size() == 0) return x;
    if (x.cols() <= x.rows()) return x * factors.asDiagonal();
    Matrix gram = Matrix::Zero(x.rows(), x.rows());
    Matrix block;
    for (Index begin = 0; begin < x.cols(); begin += kGramColumns) {
        context.check_cancelled();
        const Index count = std::min(kGramColumns, x.cols() - begin);
        block = x.middleCols(begin, count);
        if (factors.size() > 0) block *= factors.segment(begin, count).asDiagonal();
        block.rowwise() -= block.colwise().mean().eval();
        gram.noalias() += block * block.transpose();
    }
    context.check_cancelled();
    Eigen::SelfAdjointEigenSolver<Matrix> solver(gram);
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the eigenproblem of the samples' Gram matrix did not converge");
    const Vector& values = solver.eigenvalues();
    const double floor = 1e-14 * std::max(values.maxCoeff(), 0.0);
    Matrix coordinates(x.rows(), x.rows());
    Index used = 0;
    for (Index j = values.size() - 1; j >= 0; --j)
        if (values[j] > floor)
            coordinates.col(used++) = solver.eigenvectors().col(j) * std::sqrt(values[j]);
    if (used == 0) fail(Status::no_solution, "the predictors do not vary");
    return coordinates.leftCols(used);
}

// Groups in order of appearance, each sample's group number.
std::vector<int> group_numbers(const std::vector<int>& groups, Index n, int& num_groups) {
    std::vector<int> numbers(static_cast<std::size_t>(n));
    if (groups.empty()) {
        std::iota(numbers.begin(), numbers.end(), 0);
        num_groups = static_cast<int>(n);
        return numbers;
    }
    if (static_cast<Index>(groups.size()) != n)
        fail(Status::invalid_argument, "%zu group numbers for %lld samples", groups.size(),
             static_cast<long long>(n));
    std::vector<int> sorted(groups);
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    num_groups = static_cast<int>(sorted.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), groups[i]) -
                                      sorted.begin());
    return numbers;
}

/// Groups and their folds: fold_of_sample, and how many samples each fold holds out.
struct Folds {
    std::vector<int> group;  ///< per sample, 0 .. num_groups - 1
    int num_groups = 0;
    std::vector<int> of_sample;
    std::vector<Index> size;
};

Folds draw_folds(const CrossValidationOptions& options, Index n) {
    Folds folds;
    folds.group = group_numbers(options.groups, n, folds.num_groups);
    const int count = options.folds == 0 ? folds.num_groups : options.folds;
    if (folds.num_groups < 3 || count < 2 || count > folds.num_groups)
        fail(Status::invalid_argument,
             "%d folds of %d groups; cross-validation needs three groups or more and at most as "
             "many folds",
             count, folds.num_groups);
    std::vector<int> fold_of_group(static_cast<std::size_t>(folds.num_groups));
    std::iota(fold_of_group.begin(), fold_of_group.end(), 0);
    SplitMix random(options.seed);
    for (std::size_t i = fold_of_group.size(); i > 1; --i)
        std::swap(fold_of_group[i - 1], fold_of_group[random.below(i)]);
    for (int& f : fold_of_group) f %= count;
    folds.of_sample.resize(static_cast<std::size_t>(n));
    folds.size.assign(static_cast<std::size_t>(count), 0);
    for (std::size_t i = 0; i < folds.of_sample.size(); ++i) {
        folds.of_sample[i] = fold_of_group[static_cast<std::size_t>(folds.group[i])];
        ++folds.size[static_cast<std::size_t>(folds.of_sample[i])];
    }
    return folds;
}

/// Fits on all samples but those of one fold and writes the predictions of these, for 0 to
/// predictions.cols() - 1 components. `coordinates` has a row per sample.
void predict_fold(const Matrix& coordinates, const Vector& y, const CrossValidationOptions& options,
                  const Folds& folds, int fold, Matrix& predictions) {
    const Index n = y.size(), held = folds.size[static_cast<std::size_t>(fold)];
    const Index most = predictions.cols() - 1;
    Matrix train_x(n - held, coordinates.cols()), test_x(held, coordinates.cols());
    Matrix train_y(n - held, 1);
    Index a = 0, b = 0;
    for (Index i = 0; i < n; ++i) {
        if (folds.of_sample[static_cast<std::size_t>(i)] == fold) {
            test_x.row(b++) = coordinates.row(i);
        } else {
            train_y(a, 0) = y[i];
            train_x.row(a++) = coordinates.row(i);
        }
    }
    const double mean = train_y.mean();
    Matrix predicted = Matrix::Constant(held, most + 1, mean);
    if ((train_y.array() - mean).abs().maxCoeff() > 0) {
        PlsOptions fit_options;
        fit_options.method = options.method;
        fit_options.num_components = static_cast<int>(std::min(most, coordinates.cols()));
        fit_options.scale = options.scale;
        const PlsModel model = fit_pls(train_x, train_y, fit_options, Context());
        const Matrix scores = model.project(test_x);
        for (Index c = 1; c <= most; ++c) {
            predicted.col(c) = predicted.col(c - 1);
            if (c <= model.num_components())
                predicted.col(c) += scores.col(c - 1) * model.y_loadings(0, c - 1);
        }
    }
    b = 0;
    for (Index i = 0; i < n; ++i)
        if (folds.of_sample[static_cast<std::size_t>(i)] == fold)
            predictions.row(i) = predicted.row(b++);
}

/// Mean squared errors by number of components, their standard errors over the groups, the best
/// number and the one-standard-error rule's.
void judge_components(const Vector& y, const Folds& folds, CrossValidation& result) {
    const Index n = y.size(), most = result.predictions.cols() - 1;
    const int num_groups = folds.num_groups;
    result.mean_squared_error.resize(most + 1);
    result.standard_error.resize(most + 1);
    for (Index c = 0; c <= most; ++c) {
        Vector group_error = Vector::Zero(num_groups), group_count = Vector::Zero(num_groups);
        for (Index i = 0; i < n; ++i) {
            const double e = result.predictions(i, c) - y[i];
            group_error[folds.group[static_cast<std::size_t>(i)]] += e * e;
            group_count[folds.group[static_cast<std::size_t>(i)]] += 1.0;
        }
        result.mean_squared_error[c] = group_error.sum() / static_cast<double>(n);
        const Vector means = group_error.array() / group_count.array();
        result.standard_error[c] = std::sqrt((means.array() - means.mean()).square().sum() /
                                             (num_groups - 1.0) / num_groups);
    }
    Index best = 1;
    for (Index c = 2; c <= most; ++c)
        if (result.mean_squared_error[c] < result.mean_squared_error[best]) best = c;
    result.best_components = static_cast<int>(best);
    const double bound = result.mean_squared_error[best] + result.standard_error[best];
    Index fewest = 1;
    while (result.mean_squared_error[fewest] > bound) ++fewest;
    result.one_standard_error_components = static_cast<int>(fewest);
}

}  // namespace

double CrossValidation::r2(int components) const {
    if (components < 0 || components >= mean_squared_error.size())
        fail(Status::invalid_argument, "%d components were not cross-validated", components);
    return 1.0 - mean_squared_error[components] / mean_squared_error[0];
}

CrossValidation cross_validate_pls(const ConstMatrixRef& x, const Vector& y,
                                   const CrossValidationOptions& options, const Context& context) {
    const Index n = x.rows();
    if (y.size() != n)
        fail(Status::invalid_argument, "%lld samples of predictors, but %lld responses",
             static_cast<long long>(n), static_cast<long long>(y.size()));
    if (!x.allFinite() || !y.allFinite())
        fail(Status::invalid_argument, "a predictor or response is not finite; drop that sample");
    const Folds folds = draw_folds(options, n);
    if (options.max_components < 1)
        fail(Status::invalid_argument, "%d components; at least one", options.max_components);
    const Matrix shared = options.scale            ? Matrix(x)
                          : options.column_factors ? Matrix()
                                                   : principal_coordinates(x, {}, context);
    const Index smallest = n - *std::max_element(folds.size.begin(), folds.size.end());
    const Index most = std::min<Index>({options.max_components, smallest - 1, x.cols()});
    if (most < 1)
        fail(Status::invalid_argument, "training folds of %lld samples are too small",
             static_cast<long long>(smallest));

    CrossValidation result;
    result.fold = folds.of_sample;
    result.predictions = Matrix::Zero(n, most + 1);
    parallel_for(context, folds.size.size(), 1, [&](std::size_t begin, std::size_t) {
        const int fold = static_cast<int>(begin);
        Matrix own;
        if (options.column_factors && !options.scale) {
            std::vector<Index> training;
            for (Index i = 0; i < n; ++i)
                if (folds.of_sample[static_cast<std::size_t>(i)] != fold) training.push_back(i);
            own = principal_coordinates(x, options.column_factors(training), context);
        }
        predict_fold(own.size() > 0 ? own : shared, y, options, folds, fold, result.predictions);
    });
    judge_components(y, folds, result);
    return result;
}

}  // namespace mien
