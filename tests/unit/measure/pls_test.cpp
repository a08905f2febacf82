#include "measure/pls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Dense>
#include <set>

#include "base/error.hpp"
#include "base/thread_pool.hpp"
#include "measure/random.hpp"
#include "shapes.hpp"

namespace mien {
namespace {

Matrix wave_predictors() {
    Matrix x(14, 6);
    for (int i = 0; i < 14; ++i)
        for (int j = 0; j < 6; ++j)
            x(i, j) = std::sin(0.7 * i + 1.3 * j * j) + 0.3 * std::cos(0.9 * i * j) + 0.05 * j;
    return x;
}

Matrix wave_responses(const Matrix& x) {
    Matrix y(14, 2);
    for (int i = 0; i < 14; ++i) {
        y(i, 0) = x(i, 0) - 0.5 * x(i, 2) + 0.2 * std::sin(3.1 * i);
        y(i, 1) = 0.4 * x(i, 1) + x(i, 5) + 0.3 * std::cos(2.3 * i) + 1;
    }
    return y;
}

PlsOptions options_of(PlsMethod method, int components, bool scale = false) {
    PlsOptions options;
    options.method = method;
    options.num_components = components;
    options.scale = scale;
    return options;
}

template <std::size_t N>
void expect_values(const Matrix& values, const double (&expected)[N]) {
    ASSERT_EQ(values.size(), static_cast<Index>(N));
    for (std::size_t i = 0; i < N; ++i)
        EXPECT_NEAR(values.data()[i], expected[i], 1e-8 * std::max(1.0, std::fabs(expected[i])))
            << i;
}

Matrix random_matrix(Index rows, Index cols, std::uint64_t seed) {
    SplitMix random(seed);
    Matrix m(rows, cols);
    for (Index j = 0; j < cols; ++j)
        for (Index i = 0; i < rows; ++i) m(i, j) = random.normal();
    return m;
}

// Expected values of the next four tests: R 4.2.2 with package pls 2.8-1 (kernelpls and oscorespls
// are NIPALS' regression, simpls is SIMPLS), printed with 17 digits.
TEST(Pls, NipalsWithTwoResponsesMatchesR) {
    const Matrix x = wave_predictors(), y = wave_responses(x);
    const PlsModel model = fit_pls(x, y, options_of(PlsMethod::nipals, 3), {});
    const double coefficients[] = {0.68090003502271279,  0.29245440305681325,  -0.35737821138018466,
                                   0.34971566021123246,  0.033037148918345936, 0.025879990282226317,
                                   0.15686924602705116,  0.36457054979820425,  0.23849812689609051,
                                   -0.23941323175946011, 0.20372114703024397,  0.88669683224268536};
    expect_values(model.coefficients(3), coefficients);
    const double explained[] = {0.6674139082058077, 0.27938516514147438, 0.022992662283428434};
    expect_values(model.x_explained, explained);
}

TEST(Pls, SimplsWithTwoResponsesMatchesR) {
    const Matrix x = wave_predictors(), y = wave_responses(x);
    const PlsModel model = fit_pls(x, y, options_of(PlsMethod::simpls, 3), {});
    const double coefficients[] = {0.68010354120195071, 0.29225877687741941,  -0.35633637558540143,
                                   0.35049205794815474, 0.034275743357946871, 0.026315629844645139,
                                   0.15710308734624051, 0.36460703535364347,  0.23826303041648861,
                                   -0.2401327533916226, 0.20288614159392987,  0.88677185066234077};
    expect_values(model.coefficients(3), coefficients);
    const double explained[] = {0.66741390820580782, 0.27937674374070015, 0.023019048096714189};
    expect_values(model.x_explained, explained);
}

TEST(Pls, ScaledPredictionsMatchR) {
    const Matrix x = wave_predictors(), y = wave_responses(x).col(0);
    const double predicted[] = {0.59369600871435624,  1.1502789372093334,    1.2215442165216248,
                                0.58796034701027688,  -0.010923031697042049, -0.31674488983250315,
                                -0.59674903288196512, -0.53702116169307701,  0.12757686931903151,
                                0.78470290760500594,  0.93532564604389223,   0.98045367534241623,
                                0.82902159590726732,  0.17176348729755597};
    for (PlsMethod method : {PlsMethod::nipals, PlsMethod::simpls})
        expect_values(fit_pls(x, y, options_of(method, 4, true), {}).predict(x, 4), predicted);
}

TEST(Pls, LeaveOneOutErrorMatchesR) {
    const Matrix x = wave_predictors();
    CrossValidationOptions options;
    options.max_components = 4;
    const double mse[] = {0.41365312556062828, 0.15419819366120979, 0.057371924279339286,
                          0.017342732441262616, 0.011459893118343991};
    for (PlsMethod method : {PlsMethod::nipals, PlsMethod::simpls}) {
        options.method = method;
        const CrossValidation cv = cross_validate_pls(x, wave_responses(x).col(0), options, {});
        expect_values(cv.mean_squared_error, mse);
        EXPECT_EQ(cv.best_components, 4);
    }
}

TEST(Pls, MethodsAgreeForOneResponseAndManyPredictors) {
    const Matrix x = random_matrix(40, 700, 3),
                 y = x.leftCols(5).rowwise().sum() + random_matrix(40, 1, 4);
    const PlsModel a = fit_pls(x, y, options_of(PlsMethod::nipals, 12), {});
    const PlsModel b = fit_pls(x, y, options_of(PlsMethod::simpls, 12), {});
    for (Index c = 0; c <= 12; ++c)
        EXPECT_LT((a.coefficients(c) - b.coefficients(c)).norm(),
                  1e-8 * (1e-3 + b.coefficients(c).norm()))
            << c;
    EXPECT_LT((a.scores.transpose() * a.scores -
               Matrix((a.scores.transpose() * a.scores).diagonal().asDiagonal()))
                  .norm(),
              1e-8 * a.scores.squaredNorm());
    EXPECT_LT((a.project(x) - a.scores).norm(), 1e-8 * a.scores.norm());
}

TEST(Pls, WithAllComponentsIsLeastSquares) {
    const Matrix x = random_matrix(30, 5, 1), y = random_matrix(30, 2, 2);
    const Matrix x0 = x.rowwise() - x.colwise().mean(), y0 = y.rowwise() - y.colwise().mean();
    const Matrix truth = (x0.transpose() * x0).inverse() * x0.transpose() * y0;
    for (PlsMethod method : {PlsMethod::nipals, PlsMethod::simpls}) {
        const PlsModel model = fit_pls(x, y, options_of(method, 5), {});
        EXPECT_LT((model.coefficients(5) - truth).norm(), 1e-10);
        EXPECT_NEAR(model.x_explained.sum(), 1.0, 1e-12);
    }
}

TEST(Pls, StopsWhenTheCovarianceIsUsedUp) {
    Matrix x = Matrix::Zero(20, 4);
    x.leftCols(2) = random_matrix(20, 2, 8);
    const Matrix y = x.col(0) - 2 * x.col(1);
    const PlsModel model = fit_pls(x, y, options_of(PlsMethod::nipals, 4), {});
    EXPECT_LE(model.num_components(), 2);
    EXPECT_LT((model.predict(x, model.num_components()) - y).norm(), 1e-10);
}

TEST(Pls, RefusesInputItCannotUse) {
    const Matrix x = random_matrix(6, 3, 5), y = random_matrix(6, 1, 6);
    auto status = [&](const Matrix& a, const Matrix& b, int components) {
        return test::status_of(
            [&] { fit_pls(a, b, options_of(PlsMethod::nipals, components), {}); });
    };
    EXPECT_EQ(status(x, y, 4), Status::invalid_argument);
    EXPECT_EQ(status(x, y, 0), Status::invalid_argument);
    EXPECT_EQ(status(x, y.topRows(5), 1), Status::invalid_argument);
    EXPECT_EQ(status(x, Matrix::Ones(6, 1), 1), Status::no_solution);
    EXPECT_EQ(status(Matrix::Ones(6, 3), y, 1), Status::no_solution);
    Matrix bad = x;
    bad(2, 2) = std::nan("");
    EXPECT_EQ(status(bad, y, 1), Status::invalid_argument);
    const PlsModel model = fit_pls(x, y, options_of(PlsMethod::nipals, 2), {});
    EXPECT_EQ(test::status_of([&] { model.predict(Matrix::Ones(1, 4), 1); }), Status::mismatch);
    EXPECT_EQ(test::status_of([&] { model.predict(x, 3); }), Status::invalid_argument);
}

TEST(CrossValidation, ChoosesFewComponentsForOneHiddenDirection) {
    // One strong direction decides the response; everything after it fits noise.
    const Matrix hidden = random_matrix(80, 1, 11);
    const Matrix x = 5.0 * hidden * random_matrix(1, 300, 12) + random_matrix(80, 300, 13);
    const Vector y = hidden.col(0) + 0.3 * random_matrix(80, 1, 14).col(0);
    CrossValidationOptions options;
    options.folds = 10;
    const CrossValidation cv = cross_validate_pls(x, y, options, {});
    EXPECT_EQ(cv.one_standard_error_components, 1);
    EXPECT_LE(cv.one_standard_error_components, cv.best_components);
    EXPECT_GT(cv.r2(cv.one_standard_error_components), 0.8);
}

TEST(CrossValidation, KeepsGroupsTogetherAndIsTheSameForAnyThreadCount) {
    const Matrix x = random_matrix(30, 50, 21), noise = random_matrix(30, 1, 22);
    const Vector y = x.col(0) + noise.col(0);
    CrossValidationOptions options;
    options.folds = 4;
    for (int i = 0; i < 30; ++i) options.groups.push_back(100 - i / 3);
    const CrossValidation one = cross_validate_pls(x, y, options, {});
    std::set<int> used;
    for (int i = 0; i < 30; ++i) {
        EXPECT_EQ(one.fold[static_cast<std::size_t>(i)],
                  one.fold[static_cast<std::size_t>(i / 3 * 3)]);
        used.insert(one.fold[static_cast<std::size_t>(i)]);
    }
    EXPECT_EQ(used.size(), 4u);
    ThreadPool pool(3);
    Context context;
    context.pool = &pool;
    EXPECT_TRUE(cross_validate_pls(x, y, options, context).predictions == one.predictions);
    options.folds = 11;
    EXPECT_EQ(test::status_of([&] { cross_validate_pls(x, y, options, {}); }),
              Status::invalid_argument);
}

TEST(CrossValidation, LearnsColumnFactorsFromTheTrainingSamplesOfEachFold) {
    const Matrix x = random_matrix(30, 50, 21);
    const Vector y = x.col(0) + 0.1 * random_matrix(30, 1, 22).col(0);
    CrossValidationOptions options;
    options.folds = 5;
    const double without = cross_validate_pls(x, y, options, {}).r2(1);
    std::vector<std::vector<Index>> asked;
    options.column_factors = [&](const std::vector<Index>& training) {
        asked.push_back(training);
        Vector factors = Vector::Constant(50, 0.01);
        factors[0] = 1;  // the column that decides
        return factors;
    };
    const CrossValidation cv = cross_validate_pls(x, y, options, {});
    EXPECT_GT(cv.r2(1), 0.9);
    EXPECT_LT(without, 0.5);
    ASSERT_EQ(asked.size(), 5u);
    for (int fold = 0; fold < 5; ++fold)
        for (const Index i : asked[static_cast<std::size_t>(fold)])
            EXPECT_NE(cv.fold[static_cast<std::size_t>(i)], fold);
}

TEST(CrossValidation, PredictsHeldOutSamplesWithoutHavingSeenThem) {
    // Pure noise: an honest cross-validation cannot beat the mean by much.
    const Matrix x = random_matrix(60, 400, 31);
    const Vector y = random_matrix(60, 1, 32).col(0);
    const CrossValidation cv = cross_validate_pls(x, y, {}, {});
    EXPECT_LT(cv.r2(cv.best_components), 0.15);
    // By hand for sample 7 and two components.
    Matrix train_x(59, 400), train_y(59, 1);
    train_x << x.topRows(7), x.bottomRows(52);
    train_y << y.head(7), y.tail(52);
    const PlsModel model = fit_pls(train_x, train_y, options_of(PlsMethod::nipals, 2), {});
    EXPECT_NEAR(model.predict(x.row(7), 2)(0, 0), cv.predictions(7, 2), 1e-9);
}

}  // namespace
}  // namespace mien
