#include "expression/prior.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <map>
#include <memory>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "expression/fit.hpp"
#include "expression/joint_pca.hpp"

namespace mien {
namespace {

constexpr double kNoiseGrid[] = {0.3, 1, 3, 10, 30, 100, 300, 1000, 3000};
constexpr std::size_t kNumNoises = sizeof kNoiseGrid / sizeof *kNoiseGrid;
constexpr Index kMaxFoldSubjects = 20;  ///< tested subjects per fold
constexpr Index kMaxFoldFaces = 420;    ///< tested faces per fold

/// A model without vertices: only what fit_face needs.
ExpressionModel coordinate_model(const Matrix& identity, const Vector& identity_deviations,
                                 const Matrix& expression, const Vector& expression_deviations) {
    ExpressionModel model;
    model.identity_modes = {nullptr, 0, identity.cols()};
    model.expression_modes = {nullptr, 0, expression.cols()};
    model.identity_deviations = identity_deviations;
    model.expression_deviations = expression_deviations;
    Matrix modes(identity.rows(), identity.cols() + expression.cols());
    modes << identity, expression;
    model.gram = modes.transpose() * modes;
    return model;
}

void plan_with_noise(ExpressionModel& model, double noise) {
    model.map_noise_mm2 = model.mixture_noise_mm2 = noise;
    auto plan = std::make_shared<FitPlan>();
    const Index q = model.num_expression_modes();
    const Vector variances = model.expression_deviations.array().square();
    plan->map = plan_part(model, model.gram, noise, variances.cwiseInverse().asDiagonal(),
                          Vector::Zero(q), 0.0);
    for (const ExpressionComponent& component : model.components)
        plan->components.push_back(plan_part(model, model.gram, noise,
                                             component.covariance.inverse(), component.mean,
                                             std::log(component.weight)));
    model.plan = std::move(plan);
}

struct Fold {
    ExpressionModel model;
    Matrix faces, truths;  ///< r x t, face - mean and true displacement in span coordinates
    Matrix modes;          ///< r x (p+q)
};

}  // namespace

std::vector<ExpressionComponent> expression_components(const Matrix& coordinates,
                                                       const std::vector<int>& expression,
                                                       const std::vector<std::string>& names,
                                                       const Vector& deviations,
                                                       const PriorOptions& options) {
    const Index q = coordinates.rows();
    const Vector variances = deviations.array().square();
    const Matrix total = variances.asDiagonal();
    struct Moments {
        Index count = 0;
        Vector sum;
        Matrix scatter;
    };
    std::map<int, Moments> moments;
    for (Index k = 0; k < coordinates.cols(); ++k) {
        Moments& own = moments[expression[static_cast<std::size_t>(k)]];
        if (own.count++ == 0) own.sum = Vector::Zero(q);
        own.sum += coordinates.col(k);
    }
    for (Index k = 0; k < coordinates.cols(); ++k) {
        Moments& own = moments[expression[static_cast<std::size_t>(k)]];
        if (own.scatter.size() == 0) own.scatter = Matrix::Zero(q, q);
        const Vector apart = coordinates.col(k) - own.sum / static_cast<double>(own.count);
        own.scatter.selfadjointView<Eigen::Lower>().rankUpdate(apart);
    }
    Matrix pooled = Matrix::Zero(q, q);
    Index freedom = 0;
    for (auto& [index, own] : moments) {
        own.scatter = Matrix(own.scatter.selfadjointView<Eigen::Lower>());
        if (own.count < options.min_samples) continue;
        pooled += own.scatter;
        freedom += own.count - 1;
    }
    std::vector<ExpressionComponent> components;
    components.push_back({"neutral", 1.0, Vector::Zero(q), options.neutral_share * total});
    if (freedom > 0) pooled /= static_cast<double>(freedom);
    for (const auto& [index, own] : moments) {
        if (own.count < options.min_samples) continue;
        ExpressionComponent component;
        component.name = names[static_cast<std::size_t>(index)];
        component.mean = own.sum / static_cast<double>(own.count);
        component.covariance = (own.scatter + options.pooled_samples * pooled) /
                                   (static_cast<double>(own.count - 1) + options.pooled_samples) +
                               options.floor_share * total;
        components.push_back(std::move(component));
    }
    components.push_back({"any", 1.0, Vector::Zero(q), total});
    // As likely as all others together: where the data do not tell, a face stays as it is.
    components.front().weight = static_cast<double>(components.size() - 1);
    return components;
}

NoiseLevels estimate_noise(const Context& context, const ColumnSource& source,
                           const JointSpan& span, const Matrix& expression_basis,
                           const Matrix& expression_coordinates, Index identity_modes,
                           const PriorOptions& options) {
    const Index m = source.num_neutrals(), s = source.num_displacements();
    NoiseLevels levels;
    const Index num_folds = std::min<Index>(4, m);
    if (m < 4) return levels;  // too few to leave some out: the defaults

    // Folds go by the sorted subject ids, so that the order of the columns (shards) does not
    // matter.
    std::map<int, Index> column_of, rank_of;
    for (Index k = 0; k < m; ++k)
        column_of[source.neutral_subject[static_cast<std::size_t>(k)]] = k;
    for (const auto& [subject, column] : column_of) {
        const Index rank = static_cast<Index>(rank_of.size());
        rank_of[subject] = rank;
    }
    auto subject_rank = [&](Index face) {
        return rank_of.at(source.displacement_subject[static_cast<std::size_t>(face)]);
    };
    std::vector<Index> faces_by_subject(static_cast<std::size_t>(s));
    for (Index k = 0; k < s; ++k) faces_by_subject[static_cast<std::size_t>(k)] = k;
    std::stable_sort(faces_by_subject.begin(), faces_by_subject.end(),
                     [&](Index a, Index b) { return subject_rank(a) < subject_rank(b); });

    std::vector<Fold> folds(static_cast<std::size_t>(num_folds));
    for (Index f = 0; f < num_folds; ++f) {
        Fold& fold = folds[static_cast<std::size_t>(f)];
        std::vector<Index> kept, tested_subjects;
        for (const auto& [subject, column] : column_of) {
            const Index rank = rank_of.at(subject);
            if (rank % num_folds != f)
                kept.push_back(column);
            else if (rank / num_folds < kMaxFoldSubjects)
                tested_subjects.push_back(column);
        }
        Matrix training(span.neutrals.rows(), static_cast<Index>(kept.size()));
        for (std::size_t k = 0; k < kept.size(); ++k)
            training.col(static_cast<Index>(k)) = span.neutrals.col(kept[k]);
        const Vector center = training.rowwise().mean();
        training.colwise() -= center;
        Vector values;
        const Matrix identity =
            leading_eigenvectors(training * training.transpose(), identity_modes, &values);
        values /= static_cast<double>(std::max<Index>(1, training.cols() - 1));

        std::vector<Index> kept_faces, tested_faces;
        for (Index k : faces_by_subject) {
            if (subject_rank(k) % num_folds != f)
                kept_faces.push_back(k);
            else if (subject_rank(k) / num_folds < kMaxFoldSubjects &&
                     static_cast<Index>(tested_faces.size()) < kMaxFoldFaces)
                tested_faces.push_back(k);
        }
        if (kept_faces.empty() || tested_faces.empty()) return levels;
        Matrix kept_coordinates(expression_basis.cols(), static_cast<Index>(kept_faces.size()));
        std::vector<int> kept_expression;
        for (std::size_t k = 0; k < kept_faces.size(); ++k) {
            kept_coordinates.col(static_cast<Index>(k)) = expression_coordinates.col(kept_faces[k]);
            kept_expression.push_back(
                source.displacement_expression[static_cast<std::size_t>(kept_faces[k])]);
        }
        const Vector deviations =
            (kept_coordinates.rowwise().squaredNorm() / static_cast<double>(kept_faces.size()))
                .cwiseSqrt()
                .cwiseMax(1e-6);
        fold.model = coordinate_model(identity, values.cwiseSqrt(), expression_basis, deviations);
        fold.model.components = expression_components(kept_coordinates, kept_expression,
                                                      source.expression_names, deviations, options);
        fold.modes.resize(identity.rows(), identity.cols() + expression_basis.cols());
        fold.modes << identity, expression_basis;

        const Index count = static_cast<Index>(tested_faces.size() + tested_subjects.size());
        fold.faces.resize(span.neutrals.rows(), count);
        fold.truths = Matrix::Zero(span.neutrals.rows(), count);
        Index place = 0;
        for (Index k : tested_faces) {
            const Index subject =
                column_of.at(source.displacement_subject[static_cast<std::size_t>(k)]);
            fold.truths.col(place) = span.displacements.col(k);
            fold.faces.col(place++) =
                span.neutrals.col(subject) + span.displacements.col(k) - center;
        }
        for (Index subject : tested_subjects) {
            fold.faces.col(place++) = span.neutrals.col(subject) - center;
        }
    }

    struct Scores {
        double map = 0, mixture = 0;
        std::vector<double> residuals;
    };
    std::vector<Scores> scores(folds.size() * kNumNoises);
    const double vertices = static_cast<double>(source.num_vertices);
    parallel_for(context, scores.size(), 1, [&](std::size_t begin, std::size_t) {
        const Fold& fold = folds[begin / kNumNoises];
        ExpressionModel model = fold.model;
        plan_with_noise(model, kNoiseGrid[begin % kNumNoises]);
        for (Index k = 0; k < fold.faces.cols(); ++k) {
            FaceEvidence evidence;
            evidence.projection = fold.modes.transpose() * fold.faces.col(k);
            auto error = [&](const FitResult& result) {
                const Vector moved = expression_basis * result.expression;
                return std::sqrt((moved - fold.truths.col(k)).squaredNorm() / vertices);
            };
            FitOptions options_map, options_mixture;
            options_map.method = FitMethod::map;
            const FitResult mixture = fit_face(model, evidence, options_mixture);
            scores[begin].map += error(fit_face(model, evidence, options_map));
            scores[begin].mixture += error(mixture);
            Vector coordinates(mixture.identity.size() + mixture.expression.size());
            coordinates << mixture.identity, mixture.expression;
            scores[begin].residuals.push_back(
                (fold.faces.col(k) - fold.modes * coordinates).squaredNorm() / vertices);
        }
        scores[begin].map /= static_cast<double>(fold.faces.cols());
        scores[begin].mixture /= static_cast<double>(fold.faces.cols());
    });
    levels.map_error_mm = levels.mixture_error_mm = std::numeric_limits<double>::infinity();
    for (std::size_t noise = 0; noise < kNumNoises; ++noise) {
        Scores mean;
        for (std::size_t fold = 0; fold < folds.size(); ++fold) {
            mean.map += scores[fold * kNumNoises + noise].map / static_cast<double>(folds.size());
            mean.mixture +=
                scores[fold * kNumNoises + noise].mixture / static_cast<double>(folds.size());
            const std::vector<double>& own = scores[fold * kNumNoises + noise].residuals;
            mean.residuals.insert(mean.residuals.end(), own.begin(), own.end());
        }
        context.log(LogLevel::debug, "noise %g mm2: cross-validated error map %.4f mixture %.4f mm",
                    kNoiseGrid[noise], mean.map, mean.mixture);
        if (mean.map < levels.map_error_mm) {
            levels.map_error_mm = mean.map;
            levels.map_mm2 = kNoiseGrid[noise];
        }
        if (mean.mixture < levels.mixture_error_mm) {
            levels.mixture_error_mm = mean.mixture;
            levels.mixture_mm2 = kNoiseGrid[noise];
            // What the span cut off belongs to the residual too.
            const double cut = span.neutral_energy_cut / static_cast<double>(m) +
                               span.displacement_energy_cut / static_cast<double>(s);
            std::sort(mean.residuals.begin(), mean.residuals.end());
            const std::size_t place = mean.residuals.size() * 95 / 100;
            levels.residual_mm = std::sqrt(mean.residuals[place] + cut / vertices);
        }
    }
    return levels;
}

}  // namespace mien
