#include "expression/prior.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <map>

#include "base/error.hpp"

namespace mien {
namespace {

/// One expression's training faces.
struct Group {
    Matrix coordinates;  ///< q x count
    Matrix people;       ///< r x count, whitened identity coordinates
};

std::map<int, Group> group_by_expression(const Matrix& coordinates,
                                         const std::vector<int>& expression,
                                         const Matrix& identities,
                                         const Vector& identity_deviations, Index directions) {
    std::map<int, std::vector<Index>> members;
    for (Index k = 0; k < coordinates.cols(); ++k)
        members[expression[static_cast<std::size_t>(k)]].push_back(k);
    const Vector scale = identity_deviations.head(directions).cwiseInverse();
    std::map<int, Group> groups;
    for (const auto& [index, faces] : members) {
        Group& group = groups[index];
        const Index count = static_cast<Index>(faces.size());
        group.coordinates.resize(coordinates.rows(), count);
        group.people.resize(directions, count);
        for (Index k = 0; k < count; ++k) {
            const Index face = faces[static_cast<std::size_t>(k)];
            group.coordinates.col(k) = coordinates.col(face);
            group.people.col(k) = scale.asDiagonal() * identities.col(face).head(directions);
        }
    }
    return groups;
}

struct Moments {
    Vector mean;
    Matrix follows;  ///< q x r, per whitened coordinate
    Matrix scatter;  ///< of what mean and person leave open
    Index freedom = 0;
};

Moments moments_of(const Group& group, const PriorOptions& options) {
    const double count = static_cast<double>(group.coordinates.cols());
    Moments moments;
    moments.freedom = group.coordinates.cols() - 1;
    moments.mean = group.coordinates.rowwise().mean();
    Matrix rest = group.coordinates.colwise() - moments.mean;
    const Index r = group.people.rows();
    moments.follows = Matrix::Zero(group.coordinates.rows(), r);
    if (r > 0 && group.coordinates.cols() >= options.min_followers) {
        const Vector centre = group.people.rowwise().mean();
        const Matrix people = group.people.colwise() - centre;
        Matrix system = people * people.transpose();
        system.diagonal().array() += options.identity_ridge;
        const Eigen::LLT<Matrix> factor(system);
        if (factor.info() != Eigen::Success)
            fail(Status::no_solution, "an expression cannot be related to the training people");
        const Matrix weights = factor.solve(people);  // r x count
        moments.follows = rest * weights.transpose();
        rest -= moments.follows * people;
        moments.mean -= moments.follows * centre;
        const Vector leverage = (people.cwiseProduct(weights)).colwise().sum().transpose();
        for (Index k = 0; k < rest.cols(); ++k)
            rest.col(k) /=
                std::sqrt(1.0 - std::min(options.largest_leverage, leverage[k] + 1.0 / count));
        // The mean's own share of the leverage, which the freedom below counts.
        rest *= std::sqrt(1.0 - 1.0 / count);
    }
    moments.scatter = rest * rest.transpose();
    return moments;
}

}  // namespace

std::vector<double> intensities_for(const std::vector<int>& expression,
                                    const PriorOptions& options) {
    std::map<int, Index> count;
    for (const int index : expression)
        if (++count[index] >= options.min_followers) return options.intensities;
    return {1.0};
}

std::vector<ExpressionComponent> expression_components(
    const Matrix& coordinates, const std::vector<int>& expression,
    const std::vector<std::string>& names, const Vector& deviations, const Matrix& identities,
    const Vector& identity_deviations, const PriorOptions& options) {
    if (!(options.identity_ridge > 0.0) || options.identity_directions < 0 ||
        !(options.largest_leverage < 1.0))
        fail(Status::invalid_argument, "the prior's options are out of range");
    const Index q = coordinates.rows();
    const Index directions = std::min(options.identity_directions, identities.rows());
    const Matrix total = Vector(deviations.array().square()).asDiagonal();
    std::map<int, Moments> moments;
    Matrix pooled = Matrix::Zero(q, q);
    Index freedom = 0;
    for (const auto& [index, group] : group_by_expression(coordinates, expression, identities,
                                                          identity_deviations, directions)) {
        if (group.coordinates.cols() < options.min_samples) continue;
        Moments& own = moments[index] = moments_of(group, options);
        pooled += own.scatter;
        freedom += own.freedom;
    }
    if (freedom > 0) pooled /= static_cast<double>(freedom);
    std::vector<ExpressionComponent> components;
    components.push_back({"neutral", 1.0, Vector::Zero(q), options.neutral_share * total, {}});
    const Vector scale = identity_deviations.head(directions).cwiseInverse();
    for (const auto& [index, own] : moments) {
        ExpressionComponent component;
        component.name = names[static_cast<std::size_t>(index)];
        component.mean = own.mean;
        component.covariance = (own.scatter + options.pooled_samples * pooled) /
                                   (static_cast<double>(own.freedom) + options.pooled_samples) +
                               options.floor_share * total;
        if (!own.follows.isZero(0.0)) component.follows = own.follows * scale.asDiagonal();
        components.push_back(std::move(component));
    }
    components.push_back({"any", 1.0, Vector::Zero(q), total, {}});
    // As likely as all others together: where the data do not tell, a face stays as it is.
    components.front().weight = static_cast<double>(components.size() - 1);
    return components;
}

}  // namespace mien
