#include "expression/joint_pca.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/scalar_math.hpp"

namespace mien {
namespace {

Matrix gram_of_rows(const Context& context, const Matrix& columns) {
    const Matrix transposed = columns.transpose();
    Matrix gram(columns.rows(), columns.rows());
    dense::weighted_gram(context, transposed, Vector(), gram);
    return gram;
}

/// Largest principal angle between the spans of two orthonormal bases. From the sine, which keeps
/// small angles that the cosine loses.
double largest_angle(const Matrix& a, const Matrix& b) {
    if (a.cols() != b.cols()) return 0.5 * kPi;
    const Matrix outside = b - a * (a.transpose() * b);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(Matrix(outside.transpose() * outside),
                                                      Eigen::EigenvaluesOnly);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "the angle between two subspaces of the training was not found");
    return std::asin(std::min(1.0, std::sqrt(std::max(0.0, eigen.eigenvalues().maxCoeff()))));
}

}  // namespace

Matrix leading_eigenvectors(const Matrix& symmetric, Index count, Vector* values) {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(symmetric);
    if (eigen.info() != Eigen::Success)
        fail(Status::no_solution, "an eigenproblem of the training did not converge");
    const Vector all = eigen.eigenvalues().reverse();
    Index rank = 0;
    while (rank < std::min(count, all.size()) && all[rank] > 1e-12 * all[0] && all[rank] > 0.0)
        ++rank;
    Matrix vectors = eigen.eigenvectors().rowwise().reverse().leftCols(rank);
    for (Index k = 0; k < rank; ++k) {
        Index place = 0;
        vectors.col(k).cwiseAbs().maxCoeff(&place);
        if (vectors(place, k) < 0.0) vectors.col(k) *= -1.0;
    }
    if (values != nullptr) *values = all.head(rank);
    return vectors;
}

JointPca joint_pca(const Context& context, const Matrix& neutrals, const Matrix& displacements,
                   const JointPcaOptions& options) {
    if (options.identity_modes < 1 || options.expression_modes < 1)
        fail(Status::invalid_argument, "an expression model needs at least one mode of each kind");
    if (!(options.lambda >= 0.0) || !std::isfinite(options.lambda) ||
        !(options.lambda_factor > 0.0) || !std::isfinite(options.lambda_factor))
        fail(Status::invalid_argument, "lambda must be positive and finite, or 0 for automatic");
    if (options.max_iterations < 1 || !(options.angle_tolerance_rad > 0.0))
        fail(Status::invalid_argument,
             "the quasi-orthogonal training needs at least one iteration and a positive angle");
    JointPca result;
    const Matrix identity_gram = gram_of_rows(context, neutrals);
    const Matrix expression_gram = gram_of_rows(context, displacements);
    Vector identity_values;
    result.identity = leading_eigenvectors(identity_gram, options.identity_modes, &identity_values);
    result.expression = leading_eigenvectors(expression_gram, options.expression_modes, nullptr);
    if (result.identity.cols() == 0 || result.expression.cols() == 0)
        fail(Status::invalid_argument,
             "the training faces do not differ: nothing can be learned from them");
    result.start_orthogonality = orthogonality_scores(result.identity, result.expression);
    if (options.method == TrainMethod::joint_pca) return result;

    result.k = static_cast<double>(displacements.cols()) / static_cast<double>(neutrals.cols());
    result.lambda = options.lambda > 0.0 ? options.lambda
                                         : options.lambda_factor * result.k * identity_values[0];
    result.converged = false;
    for (result.iterations = 0; result.iterations < options.max_iterations && !result.converged;) {
        context.check_cancelled();
        const Matrix identity =
            leading_eigenvectors(result.k * identity_gram - result.lambda * result.expression *
                                                                result.expression.transpose(),
                                 options.identity_modes, nullptr);
        const Matrix expression =
            leading_eigenvectors(expression_gram - result.lambda * identity * identity.transpose(),
                                 options.expression_modes, nullptr);
        result.last_angle_rad = std::max(largest_angle(result.identity, identity),
                                         largest_angle(result.expression, expression));
        result.identity = identity;
        result.expression = expression;
        ++result.iterations;
        result.converged = result.last_angle_rad < options.angle_tolerance_rad;
    }
    return result;
}

Vector orthogonality_scores(const Matrix& identity, const Matrix& expression) {
    const Matrix products = identity.transpose() * expression;
    Vector scores(std::min(identity.cols(), expression.cols()));
    for (Index count = 1; count <= scores.size(); ++count)
        scores[count - 1] = products.topLeftCorner(count, count).norm();
    return scores;
}

}  // namespace mien
