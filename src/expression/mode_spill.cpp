#include "expression/mode_spill.hpp"

#include <Eigen/Cholesky>

#include "base/error.hpp"

namespace mien {
namespace {

/// Of the mean variance of a predictor: steadies directions that the training faces hardly show.
constexpr double kRidgeShare = 1e-4;

/// The matrix A with A predictors ~ targets.
Matrix regress(const Matrix& predictors, const Matrix& targets) {
    Matrix gram = predictors * predictors.transpose();
    gram.diagonal().array() += kRidgeShare * gram.trace() / static_cast<double>(gram.rows());
    const Eigen::LLT<Matrix> factor(gram);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution,
             "identity and expression modes of the training cannot be related");
    return factor.solve(predictors * targets.transpose()).transpose();
}

}  // namespace

Vector ModeSpill::along_modes(const Vector& a, const Vector& b) const {
    Vector along(a.size() + b.size());
    along << a, b;
    if (empty()) return along;
    along.head(a.size()) += expression * b;
    along.tail(b.size()) += identity * a;
    return along;
}

Vector ModeSpill::pull_vector(const Vector& along) const {
    if (empty()) return along;
    const Index p = expression.rows(), q = identity.rows();
    Vector pulled = along;
    pulled.head(p) += identity.transpose() * along.tail(q);
    pulled.tail(q) += expression.transpose() * along.head(p);
    return pulled;
}

Matrix ModeSpill::pull_gram(const Matrix& gram) const {
    if (empty()) return gram;
    const Index p = expression.rows(), q = identity.rows();
    Matrix joint = Matrix::Identity(p + q, p + q);
    joint.topRightCorner(p, q) = expression;
    joint.bottomLeftCorner(q, p) = identity;
    const Matrix pulled = joint.transpose() * gram * joint;
    return 0.5 * (pulled + pulled.transpose());
}

ModeSpill learn_spill(const Matrix& neutrals_along_p, const Matrix& neutrals_along_q,
                      const Matrix& displacements_along_p, const Matrix& displacements_along_q) {
    return {regress(neutrals_along_p, neutrals_along_q),
            regress(displacements_along_q, displacements_along_p)};
}

}  // namespace mien
