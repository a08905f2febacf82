#include "expression/series.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>

#include "base/error.hpp"

namespace mien {
namespace {

/// Quadratic form in (a, b_1 .. b_K) without the expression priors.
struct JointSystem {
    Index p = 0, q = 0, scans = 0;
    Matrix data;   ///< (p + K q)^2, with the identity prior
    Vector right;  ///< p + K q
};

/// Weight of scan k at vertex i, the changing zone included.
Matrix scan_weights(const std::vector<SeriesScan>& scans, Index n, const SeriesOptions& options,
                    double scan_noise) {
    Matrix weights = Matrix::Ones(static_cast<Index>(scans.size()), n);
    for (std::size_t k = 0; k < scans.size(); ++k)
        if (scans[k].weights.size() != 0)
            weights.row(static_cast<Index>(k)) = scans[k].weights.transpose();
    // The zone's vertices change together, as a swelling does: all of them are one observation.
    const double change = options.expected_change_mm * options.expected_change_mm *
                          static_cast<double>(options.changing_zone.size());
    for (std::uint32_t vertex : options.changing_zone)
        weights.col(vertex) *= scan_noise / (scan_noise + change);
    return weights;
}

Matrix coupling(const Vector& weights, double scan_noise, double noise) {
    const Vector precision = weights / scan_noise;
    Matrix c = precision.asDiagonal();
    c -= precision * precision.transpose() / (1.0 / noise + precision.sum());
    return c;
}

/// sum_i c_i B_i' B_i with c of one sign per call (weighted_gram takes no negative weights).
Matrix coupled_gram(const Context& context, const ExpressionModel& model, const Vector& c) {
    const double sign = c.sum() < 0.0 ? -1.0 : 1.0;
    return model.spill.pull_gram(sign * mode_gram(context, model, (sign * c).cwiseMax(0.0)));
}

JointSystem build_system(const Context& context, const ExpressionModel& model,
                         const std::vector<Points>& placed, const std::vector<SeriesScan>& scans,
                         const SeriesOptions& options, double noise) {
    JointSystem system;
    const Index n = model.num_vertices(), K = static_cast<Index>(placed.size());
    system.p = model.num_identity_modes();
    system.q = model.num_expression_modes();
    system.scans = K;
    const Index p = system.p, q = system.q, size = p + K * q;
    system.data = Matrix::Zero(size, size);
    system.right = Vector::Zero(size);
    const bool uniform = options.changing_zone.empty() &&
                         std::all_of(scans.begin(), scans.end(),
                                     [](const SeriesScan& s) { return s.weights.size() == 0; });
    const double scan_noise = options.scan_noise_share * noise;
    const Matrix weights = uniform ? Matrix() : scan_weights(scans, n, options, scan_noise);
    const Matrix constant = coupling(Vector::Ones(K), scan_noise, noise);
    std::vector<Matrix> c_of(static_cast<std::size_t>(uniform ? 0 : n));
    for (Index i = 0; i < static_cast<Index>(c_of.size()); ++i)
        c_of[static_cast<std::size_t>(i)] = coupling(weights.col(i), scan_noise, noise);

    const Matrix gram_of_ones = model.spill.pull_gram(model.gram);
    auto add_gram = [&](Index k, Index l, const Matrix& gram) {
        system.data.topLeftCorner(p, p) += gram.topLeftCorner(p, p);
        system.data.block(0, p + l * q, p, q) += gram.topRightCorner(p, q);
        system.data.block(p + k * q, p + l * q, q, q) += gram.bottomRightCorner(q, q);
    };
    Vector displacement(3 * n);
    for (Index k = 0; k < K; ++k)
        for (Index l = 0; l < K; ++l) {
            context.check_cancelled();
            const Points& face = placed[static_cast<std::size_t>(l)];
            if (uniform) {
                add_gram(k, l, constant(k, l) * gram_of_ones);
            } else if (l >= k) {
                Vector c(n);
                for (Index i = 0; i < n; ++i) c[i] = c_of[static_cast<std::size_t>(i)](k, l);
                const Matrix gram = coupled_gram(context, model, c);
                add_gram(k, l, gram);
                if (l != k) add_gram(l, k, gram);
            }
            for (Index i = 0; i < n; ++i) {
                const double c = uniform ? constant(k, l) : c_of[static_cast<std::size_t>(i)](k, l);
                if (c == 0.0)
                    displacement.segment<3>(3 * i).setZero();
                else
                    displacement.segment<3>(3 * i) = c * (face.row(i) - model.mean.row(i));
            }
            Vector along(p + q);
            along << project_modes(context, model.identity_modes, displacement),
                project_modes(context, model.expression_modes, displacement);
            const Vector evidence = model.spill.pull_vector(along);
            system.right.head(p) += evidence.head(p);
            system.right.segment(p + k * q, q) += evidence.tail(q);
        }
    system.data.bottomLeftCorner(K * q, p) = system.data.topRightCorner(p, K * q).transpose();
    system.data.diagonal().head(p) += model.identity_deviations.array().square().inverse().matrix();
    return system;
}

struct JointSolution {
    Vector coordinates;
    double log_evidence = -std::numeric_limits<double>::infinity();
};

/// `parts` holds the prior of each scan's expression.
JointSolution solve_joint(const JointSystem& system, const std::vector<const FitPlan::Part*>& parts,
                          const std::vector<double>& log_weights) {
    const Index p = system.p, q = system.q;
    Matrix matrix = system.data;
    Vector right = system.right;
    double offset = 0.0;
    for (Index k = 0; k < system.scans; ++k) {
        const FitPlan::Part& part = *parts[static_cast<std::size_t>(k)];
        matrix.block(p + k * q, p + k * q, q, q) += part.prior_precision;
        const Vector pull = part.prior_precision * part.mean.tail(q);
        right.segment(p + k * q, q) += pull;
        const Eigen::LLT<Matrix> prior(part.prior_precision);
        offset += log_weights[static_cast<std::size_t>(k)] - 0.5 * part.mean.tail(q).dot(pull) +
                  prior.matrixLLT().diagonal().array().log().sum();
    }
    const Eigen::LLT<Matrix> factor(matrix);
    if (factor.info() != Eigen::Success)
        fail(Status::no_solution, "the joint fit of the series is singular: too little is visible");
    JointSolution solution;
    solution.coordinates = factor.solve(right);
    solution.log_evidence = offset + 0.5 * solution.coordinates.dot(right) -
                            factor.matrixLLT().diagonal().array().log().sum();
    return solution;
}

}  // namespace

SeriesResult neutralize_series(const Context& context, const ExpressionModel& model,
                               const std::vector<SeriesScan>& scans, const SeriesOptions& options) {
    if (scans.empty()) fail(Status::invalid_argument, "a series needs at least one scan");
    if (options.method != FitMethod::mixture && options.method != FitMethod::map)
        fail(Status::invalid_argument, "a series is fitted with a prior: mixture or map");
    if (!(options.scan_noise_share > 0.0) || !(options.noise_mm2 >= 0.0) ||
        !(options.expected_change_mm > 0.0) || !std::isfinite(options.expected_change_mm))
        fail(Status::invalid_argument, "the series' noise and change must be positive");
    const Index n = model.num_vertices(), q = model.num_expression_modes();
    for (std::uint32_t vertex : options.changing_zone)
        if (vertex >= static_cast<std::uint64_t>(n))
            fail(Status::invalid_argument, "the changing zone names vertex %u of %lld", vertex,
                 static_cast<long long>(n));
    const bool mixture = options.method == FitMethod::mixture && !model.components.empty();
    const double noise = options.noise_mm2 > 0.0 ? options.noise_mm2
                         : mixture               ? model.mixture_noise_mm2
                                                 : model.map_noise_mm2;

    // Each scan by itself first: pose, and which expressions come into question.
    Context quiet = context;
    quiet.progress_function = nullptr;
    SeriesResult result;
    std::vector<Points> placed;
    std::vector<std::vector<std::size_t>> candidates;
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < scans.size(); ++k) {
        NeutralizeOptions single;
        single.fit.method = options.method;
        single.pose = options.pose;
        const NeutralizationResult alone =
            neutralize(quiet, model, scans[k].vertices, scans[k].weights, single);
        result.poses.push_back(alone.pose);
        result.residuals_mm.push_back(alone.residual_rms_mm);
        placed.push_back(alone.pose.inverse().apply(PointsRef(scans[k].vertices)));
        std::vector<std::size_t> order(alone.component_probabilities.size());
        for (std::size_t c = 0; c < order.size(); ++c) order[c] = c;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return alone.component_probabilities[a] > alone.component_probabilities[b];
        });
        order.resize(std::min<std::size_t>(order.size(), 5));
        if (!order.empty()) {
            chosen.push_back(order[0]);
            // "neutral" and "any" always come into question.
            for (std::size_t c : {std::size_t(0), model.components.size() - 1})
                if (std::find(order.begin(), order.end(), c) == order.end()) order.push_back(c);
        }
        candidates.push_back(std::move(order));
        context.progress(Stage::neutralizing,
                         0.4 * static_cast<double>(k + 1) / static_cast<double>(scans.size()));
    }

    const JointSystem system = build_system(context, model, placed, scans, options, noise);
    auto solve_with = [&](const std::vector<std::size_t>& choice) {
        std::vector<const FitPlan::Part*> parts;
        std::vector<double> log_weights;
        for (std::size_t k = 0; k < scans.size(); ++k) {
            parts.push_back(mixture ? &model.plan->components[choice[k]] : &model.plan->map);
            log_weights.push_back(mixture ? std::log(model.components[choice[k]].weight) : 0.0);
        }
        return solve_joint(system, parts, log_weights);
    };
    JointSolution best = solve_with(chosen);
    for (int round = 0; mixture && round < 3; ++round) {
        bool improved = false;
        for (std::size_t k = 0; k < scans.size(); ++k)
            for (std::size_t candidate : candidates[k]) {
                context.check_cancelled();
                if (candidate == chosen[k]) continue;
                std::vector<std::size_t> trial = chosen;
                trial[k] = candidate;
                JointSolution solution = solve_with(trial);
                if (solution.log_evidence <= best.log_evidence) continue;
                best = std::move(solution);
                chosen = std::move(trial);
                improved = true;
            }
        if (!improved) break;
    }

    result.identity = best.coordinates.head(model.num_identity_modes());
    const Matrix weights = scan_weights(scans, n, options, options.scan_noise_share * noise);
    std::vector<Points> neutrals;
    Points sum = Points::Zero(n, 3);
    Vector total = Vector::Zero(n);
    for (std::size_t k = 0; k < scans.size(); ++k) {
        const Vector expression =
            best.coordinates.segment(model.num_identity_modes() + static_cast<Index>(k) * q, q);
        const Vector moved = expression_displacement(context, model, expression);
        neutrals.push_back(placed[k] - Eigen::Map<const Points>(moved.data(), n, 3));
        const Points& neutral = neutrals.back();
        for (Index i = 0; i < n; ++i) {
            const double weight = weights(static_cast<Index>(k), i);
            if (weight == 0.0) continue;
            sum.row(i) += weight * neutral.row(i);
            total[i] += weight;
        }
        result.expressions.push_back(expression);
        if (mixture) result.components.push_back(model.components[chosen[k]].name);
    }
    result.identity_vertices = synthesize_face(context, model, result.identity, Vector());
    for (Index i = 0; i < n; ++i)
        if (total[i] > 0.0) result.identity_vertices.row(i) = sum.row(i) / total[i];
    std::vector<char> changing(static_cast<std::size_t>(n), 0);
    for (std::uint32_t vertex : options.changing_zone) changing[vertex] = 1;
    for (std::size_t k = 0; k < scans.size(); ++k) {
        double squares = 0.0, seen = 0.0;
        for (Index i = 0; i < n; ++i) {
            const double weight = scans[k].weights.size() != 0 ? scans[k].weights[i] : 1.0;
            if (weight != 0.0 && !changing[static_cast<std::size_t>(i)]) {
                squares +=
                    weight * (neutrals[k].row(i) - result.identity_vertices.row(i)).squaredNorm();
                seen += weight;
            }
            if (!neutrals[k].row(i).allFinite())
                neutrals[k].row(i) = result.identity_vertices.row(i);
        }
        result.distances_mm.push_back(seen > 0.0 ? std::sqrt(squares / seen) : 0.0);
        result.neutral_vertices.push_back(result.poses[k].apply(PointsRef(neutrals[k])));
    }
    context.progress(Stage::neutralizing, 1.0);
    return result;
}

std::vector<std::string> series_warnings(const ExpressionModel& model, const SeriesResult& result,
                                         std::size_t k) {
    std::vector<std::string> warnings;
    const double expected = model.expected_residual_mm;
    if (expected > 0.0 && result.residuals_mm[k] > 1.5 * expected)
        warnings.push_back(
            "the face lies farther from the model than faces of new people do: it was fitted "
            "badly, or is "
            "unlike the training faces");
    if (expected > 0.0 && result.distances_mm[k] > expected)
        warnings.push_back(
            "without its expression the face still differs from the others: it was fitted badly, "
            "shows an "
            "expression that the model does not know, or is another person");
    if (!result.components.empty() && result.components[k] == "any")
        warnings.push_back("the expression is none of the trained ones");
    return warnings;
}

}  // namespace mien
