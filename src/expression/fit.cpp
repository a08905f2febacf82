#include "expression/fit.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>

#include "base/dense.hpp"
#include "base/error.hpp"
#include "base/json.hpp"

namespace mien {
namespace {

void check_options(const FitOptions& options) {
    if (options.max_sweeps < 1 || options.max_sweeps > 100000)
        fail(Status::invalid_argument, "max_sweeps is %d; give 1 to 100000", options.max_sweeps);
    if (!(options.tolerance >= 0.0) || !std::isfinite(options.tolerance))
        fail(Status::invalid_argument, "the sweep tolerance must be finite and not negative");
    if (!(options.noise_mm2 >= 0.0) || !std::isfinite(options.noise_mm2))
        fail(Status::invalid_argument,
             "noise_mm2 must be finite and not negative (0: the model's)");
}

/// Algorithm 2 in coordinates: P'P = I and Q'Q = I hold for full weights; with weights each half
/// step solves its own small normal system.
FitResult alternate(const ExpressionModel& model, const Matrix& gram, const Vector& projection,
                    const FitOptions& options) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    const Eigen::LDLT<Matrix> identity(Matrix(gram.topLeftCorner(p, p)));
    const Eigen::LDLT<Matrix> expression(Matrix(gram.bottomRightCorner(q, q)));
    if (identity.info() != Eigen::Success || expression.info() != Eigen::Success)
        fail(Status::no_solution, "too little of the face is visible for the alternating fit");
    const Matrix cross = gram.topRightCorner(p, q);
    FitResult result;
    result.identity = Vector::Zero(p);
    result.expression = Vector::Zero(q);
    result.converged = false;
    const double rows = static_cast<double>(3 * model.num_vertices());
    for (result.sweeps = 0; result.sweeps < options.max_sweeps && !result.converged;) {
        result.identity = identity.solve(projection.head(p) - cross * result.expression);
        const Vector next =
            expression.solve(projection.tail(q) - cross.transpose() * result.identity);
        const double moved = std::sqrt((next - result.expression).squaredNorm() / rows);
        result.expression = next;
        ++result.sweeps;
        result.converged = moved < options.tolerance;
    }
    return result;
}

/// Of the variance of all expressions, what a hardly shown expression may differ from its mean by;
/// 0 to 1. Not tuned: the size of PriorOptions::floor_share. On one fold of left-out people 3e-3
/// (with other intensities) was 5 to 7 % worse at a quarter and at half of an expression.
constexpr double kWeakFloorShare = 1e-3;

struct PartSolution {
    Vector coordinates;
    double log_evidence = 0;
};

PartSolution solve_part(const FitPlan::Part& part, const Vector& projection, double noise) {
    const Vector right = projection - part.gram_mean;
    const Vector offset = part.solve * right;
    PartSolution solution;
    solution.coordinates = offset + part.mean;
    solution.log_evidence =
        part.log_offset + (offset.dot(right) + 2.0 * projection.dot(part.mean)) / (2.0 * noise);
    return solution;
}

}  // namespace

Vector project_modes(const Context& context, const ModesView& modes, const Vector& displacement) {
    return dense::project(context, modes.map(), displacement);
}

void add_modes(const Context& context, const ModesView& modes, const Vector& coordinates,
               Eigen::Ref<Vector> out) {
    dense::add_product(context, modes.map(), coordinates, out);
}

void check_face(const ExpressionModel& model, const PointsRef& vertices, const Vector& weights) {
    const Index n = model.num_vertices();
    if (vertices.rows() != n)
        fail(Status::mismatch, "the face has %lld vertices, the model %lld",
             static_cast<long long>(vertices.rows()), static_cast<long long>(n));
    if (weights.size() != 0 && weights.size() != n)
        fail(Status::mismatch, "%lld weights for %lld vertices",
             static_cast<long long>(weights.size()), static_cast<long long>(n));
    for (Index i = 0; i < n; ++i) {
        if (weights.size() != 0) {
            if (!(weights[i] >= 0.0) || !std::isfinite(weights[i]))
                fail_at(Status::invalid_argument, i,
                        "the weight of vertex %lld is negative or not finite",
                        static_cast<long long>(i));
            if (weights[i] == 0.0) continue;
        }
        if (!vertices.row(i).allFinite())
            fail_at(Status::invalid_mesh, i, "vertex %lld of the face is not finite",
                    static_cast<long long>(i));
    }
}

Vector mode_coordinates(const ExpressionModel& model, FitMethod method, const Vector& identity,
                        const Vector& expression) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    const Vector a = identity.size() != 0 ? identity : Vector(Vector::Zero(p));
    const Vector b = expression.size() != 0 ? expression : Vector(Vector::Zero(q));
    const bool with_prior = method == FitMethod::mixture || method == FitMethod::map;
    return with_prior ? model.spill.along_modes(a, b) : ModeSpill().along_modes(a, b);
}

Matrix mode_gram(const Context& context, const ExpressionModel& model, const Vector& weights) {
    const Index n = model.num_vertices(), p = model.num_identity_modes(),
                q = model.num_expression_modes();
    Matrix gram = Matrix::Zero(p + q, p + q), part(p + q, p + q), block;
    Vector row_weights;
    constexpr Index kBlock = 3 * 4096;
    for (Index first = 0; first < 3 * n; first += kBlock) {
        const Index size = std::min(kBlock, 3 * n - first);
        block.resize(size, p + q);
        block.leftCols(p) = model.identity_modes.map().middleRows(first, size).cast<double>();
        block.rightCols(q) = model.expression_modes.map().middleRows(first, size).cast<double>();
        row_weights.resize(size);
        for (Index row = 0; row < size; ++row) row_weights[row] = weights[(first + row) / 3];
        dense::weighted_gram(context, block, row_weights, part);
        gram += part;
    }
    return gram;
}

FaceEvidence gather_evidence(const Context& context, const ExpressionModel& model,
                             const PointsRef& vertices, const Vector& weights) {
    const Index n = model.num_vertices(), p = model.num_identity_modes();
    const Index q = model.num_expression_modes();
    check_face(model, vertices, weights);
    Vector displacement(3 * n);
    for (Index i = 0; i < n; ++i) {
        const double weight = weights.size() != 0 ? weights[i] : 1.0;
        if (weight == 0.0)  // a vertex without data may hold anything, even what is not finite
            displacement.segment<3>(3 * i).setZero();
        else
            displacement.segment<3>(3 * i) = weight * (vertices.row(i) - model.mean.row(i));
    }
    FaceEvidence evidence;
    evidence.projection.resize(p + q);
    evidence.projection.head(p) = project_modes(context, model.identity_modes, displacement);
    evidence.projection.tail(q) = project_modes(context, model.expression_modes, displacement);
    if (weights.size() == 0) return evidence;

    evidence.gram = mode_gram(context, model, weights);
    return evidence;
}

Matrix precision_given_person(Index identity_modes, const Matrix& expression_precision,
                              const Matrix& follows) {
    const Index p = identity_modes, q = expression_precision.rows(), r = follows.cols();
    Matrix precision = Matrix::Zero(p + q, p + q);
    precision.bottomRightCorner(q, q) = expression_precision;
    if (r == 0) return precision;
    const Matrix across = expression_precision * follows;
    precision.block(p, 0, q, r) = -across;
    precision.block(0, p, r, q) = -across.transpose();
    const Matrix own = follows.transpose() * across;
    precision.topLeftCorner(r, r) = 0.5 * (own + own.transpose());
    return precision;
}

FitPlan::Part plan_part(const ExpressionModel& model, const Matrix& gram, double noise,
                        const Matrix& precision, const Matrix& identity_precision,
                        const Vector& expression_mean, double log_weight) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    FitPlan::Part part;
    part.prior_precision = precision;
    part.mean = Vector::Zero(p + q);
    part.mean.tail(q) = expression_mean;
    part.gram_mean = gram * part.mean;
    Matrix system = gram + noise * precision;
    system.topLeftCorner(p, p) += noise * identity_precision;
    const Eigen::LLT<Matrix> factor(system);
    const Eigen::LLT<Matrix> prior(Matrix(precision.bottomRightCorner(q, q)));
    if (factor.info() != Eigen::Success || prior.info() != Eigen::Success)
        fail(Status::no_solution, "a prior of the expression model is not positive definite");
    part.solve = factor.solve(Matrix::Identity(p + q, p + q));
    part.solve = (0.5 * (part.solve + part.solve.transpose())).eval();
    const double log_det_system = 2.0 * factor.matrixLLT().diagonal().array().log().sum() -
                                  static_cast<double>(p + q) * std::log(noise);
    part.log_det_prior = 2.0 * prior.matrixLLT().diagonal().array().log().sum();
    part.log_offset = log_weight - 0.5 * log_det_system + 0.5 * part.log_det_prior -
                      part.mean.dot(part.gram_mean) / (2.0 * noise);
    return part;
}

std::vector<FitPlan::Part> component_parts(const ExpressionModel& model, const Matrix& gram,
                                           double noise) {
    const Matrix total = Vector(model.expression_deviations.array().square()).asDiagonal();
    const Matrix identity = model.identity_precision();
    std::vector<FitPlan::Part> parts;
    for (std::size_t k = 0; k < model.components.size(); ++k) {
        const ExpressionComponent& component = model.components[k];
        const bool trained = component.name != "neutral" && component.name != "any";
        const std::vector<double> intensities =
            trained ? model.intensities : std::vector<double>{1.0};
        for (const double t : intensities) {
            const Matrix covariance =
                t * t * component.covariance + std::max(0.0, 1.0 - t * t) * kWeakFloorShare * total;
            const Eigen::LLT<Matrix> factor(covariance);
            if (factor.info() != Eigen::Success)
                fail(Status::corrupt,
                     "the covariance of the component '%s' is not positive definite",
                     shown_name(component.name).c_str());
            const Matrix inverse =
                factor.solve(Matrix::Identity(covariance.rows(), covariance.cols()));
            const double weight = component.weight / static_cast<double>(intensities.size());
            parts.push_back(plan_part(model, gram, noise,
                                      precision_given_person(model.num_identity_modes(),
                                                             0.5 * (inverse + inverse.transpose()),
                                                             t * component.follows),
                                      identity, t * component.mean, std::log(weight)));
            parts.back().weight = weight;
            parts.back().component = k;
            parts.back().intensity = t;
        }
    }
    return parts;
}

namespace {

/// The joint least squares without a prior.
FitResult solve_exactly(const ExpressionModel& model, const Matrix& gram,
                        const Vector& projection) {
    const Eigen::LDLT<Matrix> factor(gram);
    const Vector pivots = factor.vectorD();
    if (factor.info() != Eigen::Success ||
        !(pivots.minCoeff() > 1e-12 * std::max(pivots.maxCoeff(), 0.0)))
        fail(Status::no_solution,
             "the joint fit is singular: too few vertices are visible; use the fits 'map' or "
             "'mixture'");
    const Vector coordinates = factor.solve(projection);
    FitResult result;
    result.identity = coordinates.head(model.num_identity_modes());
    result.expression = coordinates.tail(model.num_expression_modes());
    return result;
}

/// The posterior mean over all components and its covariance. `solves` holds the inverse systems.
FitResult blend(const ExpressionModel& model, const std::vector<PartSolution>& solutions,
                const std::vector<const Matrix*>& solves, double noise) {
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    double best = -std::numeric_limits<double>::infinity();
    for (const PartSolution& solution : solutions) best = std::max(best, solution.log_evidence);
    if (!std::isfinite(best))
        fail(Status::no_solution, "the face is too far from anything the model knows");
    FitResult result;
    double total = 0.0;
    for (const PartSolution& solution : solutions) {
        result.part_probabilities.push_back(std::exp(solution.log_evidence - best));
        total += result.part_probabilities.back();
    }
    Vector mean = Vector::Zero(p + q);
    result.component_probabilities.assign(model.components.size(), 0.0);
    for (std::size_t k = 0; k < solutions.size(); ++k) {
        result.part_probabilities[k] /= total;
        result.component_probabilities[model.plan->components[k].component] +=
            result.part_probabilities[k];
        mean += result.part_probabilities[k] * solutions[k].coordinates;
    }
    const auto likeliest =
        static_cast<std::size_t>(std::max_element(result.component_probabilities.begin(),
                                                  result.component_probabilities.end()) -
                                 result.component_probabilities.begin());
    double intensity = 0.0;
    for (std::size_t k = 0; k < solutions.size(); ++k)
        if (model.plan->components[k].component == likeliest)
            intensity += result.part_probabilities[k] * model.plan->components[k].intensity;
    result.intensity = intensity / result.component_probabilities[likeliest];
    result.identity = mean.head(p);
    result.expression = mean.tail(q);
    result.covariance = Matrix::Zero(p + q, p + q);
    for (std::size_t k = 0; k < solutions.size(); ++k) {
        const double weight = result.part_probabilities[k];
        if (weight < 1e-9) continue;  // far below what a double sum of the others would show
        const Vector apart = solutions[k].coordinates - mean;
        result.covariance += weight * noise * *solves[k];
        result.covariance += weight * apart * apart.transpose();
    }
    return result;
}

}  // namespace

FitResult fit_face(const ExpressionModel& model, const FaceEvidence& evidence,
                   const FitOptions& options) {
    check_options(options);
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    const bool own_gram = evidence.gram.size() == 0;
    const Matrix& plain_gram = own_gram ? model.gram : evidence.gram;
    if (options.method == FitMethod::alternating)
        return alternate(model, plain_gram, evidence.projection, options);
    if (options.method == FitMethod::exact)
        return solve_exactly(model, plain_gram, evidence.projection);

    const bool mixture = options.method == FitMethod::mixture && !model.components.empty();
    const double model_noise = mixture ? model.mixture_noise_mm2 : model.map_noise_mm2;
    const double noise = options.noise_mm2 > 0.0 ? options.noise_mm2 : model_noise;
    const bool planned = own_gram && noise == model_noise && model.plan;
    const Matrix gram = planned ? Matrix() : model.spill.pull_gram(plain_gram);
    const Vector projection = model.spill.pull_vector(evidence.projection);
    const std::size_t count = mixture ? model.plan->components.size() : 1;
    const Matrix identity = planned ? Matrix() : model.identity_precision();
    std::vector<PartSolution> solutions(count);
    std::vector<Matrix> made(planned ? 0 : count);
    std::vector<const Matrix*> solves(count);
    for (std::size_t k = 0; k < count; ++k) {
        const FitPlan::Part& known = mixture ? model.plan->components[k] : model.plan->map;
        solves[k] = &known.solve;
        if (planned) {
            solutions[k] = solve_part(known, projection, noise);
            continue;
        }
        FitPlan::Part part = plan_part(model, gram, noise, known.prior_precision, identity,
                                       known.mean.tail(q), std::log(known.weight));
        solutions[k] = solve_part(part, projection, noise);
        made[k] = std::move(part.solve);
        solves[k] = &made[k];
    }
    if (mixture) return blend(model, solutions, solves, noise);
    FitResult result;
    result.identity = solutions[0].coordinates.head(p);
    result.expression = solutions[0].coordinates.tail(q);
    result.covariance = noise * *solves[0];
    return result;
}

}  // namespace mien
