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
    const Index n = x.rows(), p = x.cols(), m = y.cols(), most = options.num_components;
    context.require_memory(static_cast<std::size_t>(p) * static_cast<std::size_t>(n + 4 * most) * 8,
                           "partial least squares");
    PlsModel model;
    model.method = options.method;
    model.num_samples = n;
    model.x_mean = x.colwise().mean().transpose();
    model.y_mean = y.colwise().mean().transpose();
    Matrix x0 = x.rowwise() - model.x_mean.transpose();
    Matrix y0 = y.rowwise() - model.y_mean.transpose();
    model.x_scale = Vector::Ones(p);
    if (options.scale)
        for (Index j = 0; j < p; ++j) {
            const double sd = x0.col(j).norm() / std::sqrt(static_cast<double>(n - 1));
            if (sd > 1e-12 * std::max(std::fabs(model.x_mean[j]), 1e-300)) model.x_scale[j] = sd;
            x0.col(j) /= model.x_scale[j];
        }
    const double x_total = x0.squaredNorm(), y_total = y0.squaredNorm();
    if (!(x_total > 0) || !(y_total > 0))
        fail(Status::no_solution, "the %s do not vary; there is nothing to regress",
             x_total > 0 ? "responses" : "predictors");

    model.weights.resize(p, most);
    model.rotations.resize(p, most);
    model.x_loadings.resize(p, most);
    model.y_loadings.resize(m, most);
    model.scores.resize(n, most);
    model.x_explained.resize(most);
    model.y_explained.resize(most);
    Matrix covariance = x0.transpose() * y0;  // p x m, deflated by SIMPLS
    const double covariance_norm = covariance.norm();
    Matrix basis(p, options.method == PlsMethod::simpls ? most : 0);
    Matrix unit_scores(n, most);
    Index done = 0;
    for (; done < most; ++done) {
        context.check_cancelled();
        if (options.method == PlsMethod::nipals && done > 0) covariance = x0.transpose() * y0;
        // Beyond this, the direction would be made of rounding.
        if (!(covariance.norm() > 1e-13 * covariance_norm)) break;
        Vector w = covariance * dominant_right_vector(covariance);
        w.normalize();
        Vector t;
        if (options.method == PlsMethod::nipals) {
            orthogonalise(w, model.weights, done);
            w.normalize();
            t = x0 * w;
        } else {
            t = x0 * w;
        }
        const double t_norm = t.norm();
        if (!(t_norm > 1e-13 * std::sqrt(x_total))) break;
        orthogonalise(t, unit_scores, done);
        const double size = t.norm();
        if (!(size > 1e-10 * t_norm)) break;
        unit_scores.col(done) = t / size;
        if (options.method == PlsMethod::nipals) {
            model.weights.col(done) = w;
            model.scores.col(done) = t;
            model.x_loadings.col(done) = x0.transpose() * unit_scores.col(done) / size;
            model.y_loadings.col(done) = y0.transpose() * unit_scores.col(done) / size;
            x0 -= t * model.x_loadings.col(done).transpose();
            y0 -= t * model.y_loadings.col(done).transpose();
            model.x_explained[done] =
                size * size * model.x_loadings.col(done).squaredNorm() / x_total;
            model.y_explained[done] =
                size * size * model.y_loadings.col(done).squaredNorm() / y_total;
        } else {
            model.scores.col(done) = unit_scores.col(done);
            model.rotations.col(done) = w / t_norm;
            model.weights.col(done) = model.rotations.col(done);
            model.x_loadings.col(done) = x0.transpose() * unit_scores.col(done);
            model.y_loadings.col(done) = y0.transpose() * unit_scores.col(done);
            Vector v = model.x_loadings.col(done);
            orthogonalise(v, basis, done);
            v.normalize();
            basis.col(done) = v;
            covariance -= v * (v.transpose() * covariance);
            if (done > 0)
                covariance -=
                    basis.leftCols(done) * (basis.leftCols(done).transpose() * covariance);
            model.x_explained[done] = model.x_loadings.col(done).squaredNorm() / x_total;
            model.y_explained[done] = model.y_loadings.col(done).squaredNorm() / y_total;
        }
    }
    if (done == 0)
        fail(Status::no_solution, "the predictors do not covary with the responses at all");
    for (Matrix* columns :
         {&model.weights, &model.rotations, &model.x_loadings, &model.y_loadings, &model.scores})
        columns->conservativeResize(Eigen::NoChange, done);
    model.x_explained.conservativeResize(done);
    model.y_explained.conservativeResize(done);
    if (options.method == PlsMethod::nipals) {
        // R = W (P'W)^-1; P'W is upper bidiagonal for one response, upper triangular in general.
        const Matrix pw = model.x_loadings.transpose() * model.weights;
        model.rotations =
            pw.transpose().partialPivLu().solve(model.weights.transpose()).transpose();
        if (!model.rotations.allFinite())
            fail(Status::no_solution, "P'W is singular; ask for fewer components");
    }
    return model;
}

}  // namespace mien
