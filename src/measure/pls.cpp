#include "measure/pls.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

#include "base/error.hpp"

namespace mien {
namespace {

// The unit vector q that maximises |S q|: an m x m eigenproblem, m being small.
Vector dominant_right_vector(const Matrix& s) {
    if (s.cols() == 1) return Vector::Ones(1);
    Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix(s.transpose() * s));
    if (solver.info() != Eigen::Success)
        fail(Status::no_solution, "the eigenproblem of %lld responses did not converge",
             static_cast<long long>(s.cols()));
    Vector q = solver.eigenvectors().col(s.cols() - 1);
    Index largest;
    q.cwiseAbs().maxCoeff(&largest);
    if (q[largest] < 0) q = -q;
    return q;
}

void check_input(const ConstMatrixRef& x, const ConstMatrixRef& y, const PlsOptions& options) {
    if (x.rows() != y.rows())
        fail(Status::invalid_argument, "%lld samples of predictors, but %lld of responses",
             static_cast<long long>(x.rows()), static_cast<long long>(y.rows()));
    if (x.rows() < 2 || x.cols() < 1 || y.cols() < 1)
        fail(Status::invalid_argument,
             "partial least squares needs two samples, one predictor and one response or more");
    if (!x.allFinite() || !y.allFinite())
        fail(Status::invalid_argument, "a predictor or response is not finite; drop that sample");
    const Index most = std::min(x.rows() - 1, x.cols());
    if (options.num_components < 1 || options.num_components > most)
        fail(Status::invalid_argument,
             "%d components; %lld samples of %lld predictors allow 1 to %lld",
             options.num_components, static_cast<long long>(x.rows()),
             static_cast<long long>(x.cols()), static_cast<long long>(most));
}

// Remove what rounding left of earlier directions (twice is enough).
void orthogonalise(Vector& v, const Matrix& basis, Index count) {
    for (int pass = 0; pass < 2 && count > 0; ++pass)
        v -= basis.leftCols(count) * (basis.leftCols(count).transpose() * v);
}

/// The data while components are taken from them; columns of `model` are filled one by one.
struct Deflation {
    Matrix x, y;              ///< centred and scaled; deflated by NIPALS
    Matrix covariance;        ///< p x m, deflated by SIMPLS
    Matrix basis;             ///< SIMPLS: orthonormal basis of the loadings so far
    Matrix unit_scores;       ///< n x components
    double x_total, y_total;  ///< sums of squares at the start
};

/// Centres and scales; sets the model's means and scales and its columns' sizes.
Deflation begin_deflation(const ConstMatrixRef& x, const ConstMatrixRef& y,
                          const PlsOptions& options, PlsModel& model) {
    const Index n = x.rows(), p = x.cols(), m = y.cols(), most = options.num_components;
    model.method = options.method;
    model.num_samples = n;
    model.x_mean = x.colwise().mean().transpose();
    model.y_mean = y.colwise().mean().transpose();
    Deflation data;
    data.x = x.rowwise() - model.x_mean.transpose();
    data.y = y.rowwise() - model.y_mean.transpose();
    model.x_scale = Vector::Ones(p);
    if (options.scale)
        for (Index j = 0; j < p; ++j) {
            const double sd = data.x.col(j).norm() / std::sqrt(static_cast<double>(n - 1));
            if (sd > 1e-12 * std::max(std::fabs(model.x_mean[j]), 1e-300)) model.x_scale[j] = sd;
            data.x.col(j) /= model.x_scale[j];
        }
    data.x_total = data.x.squaredNorm();
    data.y_total = data.y.squaredNorm();
    if (!(data.x_total > 0) || !(data.y_total > 0))
        fail(Status::no_solution, "the %s do not vary; there is nothing to regress",
             data.x_total > 0 ? "responses" : "predictors");
    data.covariance = data.x.transpose() * data.y;
    data.basis.resize(p, options.method == PlsMethod::simpls ? most : 0);
    data.unit_scores.resize(n, most);
    model.weights.resize(p, most);
    model.rotations.resize(p, most);
    model.x_loadings.resize(p, most);
    model.y_loadings.resize(m, most);
    model.scores.resize(n, most);
    model.x_explained.resize(most);
    model.y_explained.resize(most);
    return data;
}

/// NIPALS (Wold): the component is taken off the data; `size` is the length of its scores t.
void take_nipals(const Vector& w, const Vector& t, double size, Index k, Deflation& data,
                 PlsModel& model) {
    model.weights.col(k) = w;
    model.scores.col(k) = t;
    model.x_loadings.col(k) = data.x.transpose() * data.unit_scores.col(k) / size;
    model.y_loadings.col(k) = data.y.transpose() * data.unit_scores.col(k) / size;
    data.x -= t * model.x_loadings.col(k).transpose();
    data.y -= t * model.y_loadings.col(k).transpose();
    model.x_explained[k] = size * size * model.x_loadings.col(k).squaredNorm() / data.x_total;
    model.y_explained[k] = size * size * model.y_loadings.col(k).squaredNorm() / data.y_total;
}

/// SIMPLS (de Jong): the component is taken off the covariance; `length` is that of x w.
void take_simpls(const Vector& w, double length, Index k, Deflation& data, PlsModel& model) {
    model.scores.col(k) = data.unit_scores.col(k);
    model.rotations.col(k) = w / length;
    model.weights.col(k) = model.rotations.col(k);
    model.x_loadings.col(k) = data.x.transpose() * data.unit_scores.col(k);
    model.y_loadings.col(k) = data.y.transpose() * data.unit_scores.col(k);
    Vector v = model.x_loadings.col(k);
    orthogonalise(v, data.basis, k);
    v.normalize();
    data.basis.col(k) = v;
    data.covariance -= v * (v.transpose() * data.covariance);
    if (k > 0)
        data.covariance -=
            data.basis.leftCols(k) * (data.basis.leftCols(k).transpose() * data.covariance);
    model.x_explained[k] = model.x_loadings.col(k).squaredNorm() / data.x_total;
    model.y_explained[k] = model.y_loadings.col(k).squaredNorm() / data.y_total;
}

/// Keeps the first `count` components; NIPALS gets its rotations.
void finish_model(Index count, PlsModel& model) {
    for (Matrix* columns :
         {&model.weights, &model.rotations, &model.x_loadings, &model.y_loadings, &model.scores})
        columns->conservativeResize(Eigen::NoChange, count);
    model.x_explained.conservativeResize(count);
    model.y_explained.conservativeResize(count);
    if (model.method != PlsMethod::nipals) return;
    // R = W (P'W)^-1; P'W is upper bidiagonal for one response, upper triangular in general.
    const Matrix pw = model.x_loadings.transpose() * model.weights;
    model.rotations = pw.transpose().partialPivLu().solve(model.weights.transpose()).transpose();
    if (!model.rotations.allFinite())
        fail(Status::no_solution, "P'W is singular; ask for fewer components");
}

}  // namespace

Matrix PlsModel::coefficients(Index components) const {
    if (components < 0 || components > num_components())
        fail(Status::invalid_argument, "%lld components, but the model has %lld",
             static_cast<long long>(components), static_cast<long long>(num_components()));
    Matrix b = rotations.leftCols(components) * y_loadings.leftCols(components).transpose();
    return (b.array().colwise() / x_scale.array()).matrix();
}

Matrix PlsModel::project(const ConstMatrixRef& x) const {
    if (x.cols() != x_mean.size())
        fail(Status::mismatch, "%lld predictors, but the model was fitted with %lld",
             static_cast<long long>(x.cols()), static_cast<long long>(x_mean.size()));
    const Matrix centred =
        (x.rowwise() - x_mean.transpose()).array().rowwise() / x_scale.transpose().array();
    return centred * rotations;
}

Matrix PlsModel::predict(const ConstMatrixRef& x, Index components) const {
    if (components < 0 || components > num_components())
        fail(Status::invalid_argument, "%lld components, but the model has %lld",
             static_cast<long long>(components), static_cast<long long>(num_components()));
    Matrix y = project(x).leftCols(components) * y_loadings.leftCols(components).transpose();
    y.rowwise() += y_mean.transpose();
    return y;
}

PlsModel fit_pls(const ConstMatrixRef& x, const ConstMatrixRef& y, const PlsOptions& options,
                 const Context& context) {
    check_input(x, y, options);
    const Index n = x.rows(), p = x.cols(), most = options.num_components;
    context.require_memory(static_cast<std::size_t>(p) * static_cast<std::size_t>(n + 4 * most) * 8,
                           "partial least squares");
    PlsModel model;
    Deflation data = begin_deflation(x, y, options, model);
    const double covariance_norm = data.covariance.norm();
    const bool nipals = options.method == PlsMethod::nipals;
    Index done = 0;
    for (; done < most; ++done) {
        context.check_cancelled();
        if (nipals && done > 0) data.covariance = data.x.transpose() * data.y;
        // Beyond this, the direction would be made of rounding.
        if (!(data.covariance.norm() > 1e-13 * covariance_norm)) break;
        Vector w = data.covariance * dominant_right_vector(data.covariance);
        w.normalize();
        if (nipals) {
            orthogonalise(w, model.weights, done);
            w.normalize();
        }
        Vector t = data.x * w;
        const double length = t.norm();
        if (!(length > 1e-13 * std::sqrt(data.x_total))) break;
        orthogonalise(t, data.unit_scores, done);
        const double size = t.norm();
        if (!(size > 1e-10 * length)) break;
        data.unit_scores.col(done) = t / size;
        if (nipals)
            take_nipals(w, t, size, done, data, model);
        else
            take_simpls(w, length, done, data, model);
    }
    if (done == 0)
        fail(Status::no_solution, "the predictors do not covary with the responses at all");
    finish_model(done, model);
    return model;
}

}  // namespace mien
