#include "expression/noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
constexpr Index kMostFolds = 4;
constexpr Index kMaxFoldSubjects = 20;  ///< tested subjects per fold
constexpr Index kMaxFoldFaces = 420;    ///< tested faces per fold

/// A model without vertices: only what fit_face needs.
ExpressionModel coordinate_model(const Matrix& people, const Vector& people_deviations,
                                 const SmoothIdentity& smooth, const Matrix& expression,
                                 const Vector& expression_deviations, Matrix& modes) {
    Matrix identity(people.rows(), people.cols() + smooth.modes.cols());
    identity << people, smooth.modes;
    ExpressionModel model;
    model.identity_modes = {nullptr, 0, identity.cols()};
    model.expression_modes = {nullptr, 0, expression.cols()};
    model.identity_covariance = smooth.covariance;
    model.smooth_modes = smooth.modes.cols();
    model.identity_deviations = smooth.covariance.diagonal().cwiseSqrt();
    model.identity_deviations.head(people.cols()) = people_deviations;
    model.expression_deviations = expression_deviations;
    modes.resize(identity.rows(), identity.cols() + expression.cols());
    modes << identity, expression;
    model.gram = modes.transpose() * modes;
    return model;
}

void plan_with_noise(ExpressionModel& model, double noise) {
    model.map_noise_mm2 = model.mixture_noise_mm2 = noise;
    auto plan = std::make_shared<FitPlan>();
    const Index p = model.num_identity_modes(), q = model.num_expression_modes();
    const Vector variances = model.expression_deviations.array().square();
    plan->map = plan_part(model, model.gram, noise,
                          precision_given_person(p, variances.cwiseInverse().asDiagonal(), {}),
                          model.identity_precision(), Vector::Zero(q), 0.0);
    plan->components = component_parts(model, model.gram, noise);
    model.plan = std::move(plan);
}

struct Fold {
    ExpressionModel model;
    Matrix faces, truths;  ///< r x t, face - mean and true displacement in span coordinates
    Matrix modes;          ///< r x (p+q)
};

struct Scores {
    double map = 0, mixture = 0;
    std::vector<double> residuals;
};

/// Leaves people out. Folds go by the sorted subject ids, so that the order of the columns (shards)
/// does not matter.
class FoldMaker {
  public:
    FoldMaker(const ColumnSource& source, const JointSpan& span, const Matrix& expression_basis,
              const Matrix& expression_coordinates, Index identity_modes,
              const PriorOptions& options, const SmoothPrior& smooth)
        : source_(source),
          span_(span),
          basis_(expression_basis),
          coordinates_(expression_coordinates),
          identity_modes_(identity_modes),
          options_(options),
          smooth_(smooth) {
        for (Index k = 0; k < source.num_neutrals(); ++k)
            column_of_[source.neutral_subject[static_cast<std::size_t>(k)]] = k;
        for (const auto& [subject, column] : column_of_) {
            const Index rank = static_cast<Index>(rank_of_.size());
            rank_of_[subject] = rank;
        }
        for (Index k = 0; k < source.num_displacements(); ++k) faces_by_subject_.push_back(k);
        std::stable_sort(faces_by_subject_.begin(), faces_by_subject_.end(),
                         [&](Index a, Index b) { return rank_of_face(a) < rank_of_face(b); });
    }

    /// False when there is nothing to learn from or to test.
    bool make(Index fold_index, Index num_folds, Fold& fold) const {
        std::vector<Index> kept, tested_subjects, kept_faces, tested_faces;
        for (const auto& [subject, column] : column_of_) {
            const Index rank = rank_of_.at(subject);
            if (rank % num_folds != fold_index)
                kept.push_back(column);
            else if (rank / num_folds < kMaxFoldSubjects)
                tested_subjects.push_back(column);
        }
        for (const Index k : faces_by_subject_) {
            if (rank_of_face(k) % num_folds != fold_index)
                kept_faces.push_back(k);
            else if (rank_of_face(k) / num_folds < kMaxFoldSubjects &&
                     static_cast<Index>(tested_faces.size()) < kMaxFoldFaces)
                tested_faces.push_back(k);
        }
        if (kept_faces.empty() || tested_faces.empty()) return false;
        const Vector center = learn(kept, kept_faces, fold);
        const Index count = static_cast<Index>(tested_faces.size() + tested_subjects.size());
        fold.faces.resize(span_.neutrals.rows(), count);
        fold.truths = Matrix::Zero(span_.neutrals.rows(), count);
        Index place = 0;
        for (const Index k : tested_faces) {
            fold.truths.col(place) = span_.displacements.col(k);
            fold.faces.col(place++) =
                span_.neutrals.col(column_of_face(k)) + span_.displacements.col(k) - center;
        }
        for (const Index subject : tested_subjects)
            fold.faces.col(place++) = span_.neutrals.col(subject) - center;
        return true;
    }

  private:
    Index rank_of_face(Index face) const {
        return rank_of_.at(source_.displacement_subject[static_cast<std::size_t>(face)]);
    }
    Index column_of_face(Index face) const {
        return column_of_.at(source_.displacement_subject[static_cast<std::size_t>(face)]);
    }

    /// The fold's model from the people kept; returns their mean.
    Vector learn(const std::vector<Index>& kept, const std::vector<Index>& kept_faces,
                 Fold& fold) const {
        Matrix training(span_.neutrals.rows(), static_cast<Index>(kept.size()));
        for (std::size_t k = 0; k < kept.size(); ++k)
            training.col(static_cast<Index>(k)) = span_.neutrals.col(kept[k]);
        Vector center = training.rowwise().mean();
        training.colwise() -= center;
        Vector values;
        const Matrix identity =
            leading_eigenvectors(training * training.transpose(), identity_modes_, &values);
        values /= static_cast<double>(std::max<Index>(1, training.cols() - 1));

        const Index count = static_cast<Index>(kept_faces.size());
        Matrix coordinates(basis_.cols(), count), identities(identity.cols(), count);
        std::vector<int> expression;
        for (Index k = 0; k < count; ++k) {
            const Index face = kept_faces[static_cast<std::size_t>(k)];
            coordinates.col(k) = coordinates_.col(face);
            identities.col(k) =
                identity.transpose() * (span_.neutrals.col(column_of_face(face)) - center);
            expression.push_back(source_.displacement_expression[static_cast<std::size_t>(face)]);
        }
        const Vector deviations = (coordinates.rowwise().squaredNorm() / static_cast<double>(count))
                                      .cwiseSqrt()
                                      .cwiseMax(1e-6);
        SmoothIdentity smooth =
            smooth_identity(identity, identity, values.cwiseSqrt(), smooth_.gram,
                            smooth_.variance_mm2, smooth_.most_modes);
        fold.model =
            coordinate_model(identity, values.cwiseSqrt(), smooth, basis_, deviations, fold.modes);
        // Fewer people are left to follow; the question is what all of them are worth.
        PriorOptions options = options_;
        options.min_followers = options_.min_followers * static_cast<Index>(kept.size()) /
                                static_cast<Index>(column_of_.size());
        fold.model.components =
            expression_components(coordinates, expression, source_.expression_names, deviations,
                                  identities, values.cwiseSqrt(), options);
        fold.model.intensities = intensities_for(expression, options_);
        return center;
    }

    const ColumnSource& source_;
    const JointSpan& span_;
    const Matrix& basis_;
    const Matrix& coordinates_;
    Index identity_modes_;
    const PriorOptions& options_;
    const SmoothPrior& smooth_;
    std::map<int, Index> column_of_, rank_of_;
    std::vector<Index> faces_by_subject_;
};

/// The fold's faces neutralized with one noise level.
Scores score(const Fold& fold, double noise, const Matrix& expression_basis, double vertices) {
    ExpressionModel model = fold.model;
    plan_with_noise(model, noise);
    FitOptions options_map, options_mixture;
    options_map.method = FitMethod::map;
    Scores scores;
    for (Index k = 0; k < fold.faces.cols(); ++k) {
        FaceEvidence evidence;
        evidence.projection = fold.modes.transpose() * fold.faces.col(k);
        const auto error = [&](const FitResult& result) {
            const Vector moved = expression_basis * result.expression;
            return std::sqrt((moved - fold.truths.col(k)).squaredNorm() / vertices);
        };
        const FitResult mixture = fit_face(model, evidence, options_mixture);
        scores.map += error(fit_face(model, evidence, options_map));
        scores.mixture += error(mixture);
        Vector coordinates(mixture.identity.size() + mixture.expression.size());
        coordinates << mixture.identity, mixture.expression;
        // A person left out lies in the span of all training people, which smooth modes fill; a new
        // one does not. What the people's own modes leave is what to expect of a new person.
        coordinates.segment(model.num_people_modes(), model.smooth_modes).setZero();
        scores.residuals.push_back((fold.faces.col(k) - fold.modes * coordinates).squaredNorm() /
                                   vertices);
    }
    scores.map /= static_cast<double>(fold.faces.cols());
    scores.mixture /= static_cast<double>(fold.faces.cols());
    return scores;
}

}  // namespace

NoiseLevels estimate_noise(const Context& context, const ColumnSource& source,
                           const JointSpan& span, const Matrix& expression_basis,
                           const Matrix& expression_coordinates, Index identity_modes,
                           const PriorOptions& options, const SmoothPrior& smooth) {
    const Index m = source.num_neutrals(), s = source.num_displacements();
    NoiseLevels levels;
    if (m < kMostFolds) return levels;  // too few to leave some out: the defaults
    const FoldMaker maker(source, span, expression_basis, expression_coordinates, identity_modes,
                          options, smooth);
    std::vector<Fold> folds(static_cast<std::size_t>(kMostFolds));
    for (Index f = 0; f < kMostFolds; ++f)
        if (!maker.make(f, kMostFolds, folds[static_cast<std::size_t>(f)])) return levels;

    std::vector<Scores> scores(folds.size() * kNumNoises);
    const double vertices = static_cast<double>(source.num_vertices);
    parallel_for(context, scores.size(), 1, [&](std::size_t begin, std::size_t) {
        scores[begin] = score(folds[begin / kNumNoises], kNoiseGrid[begin % kNumNoises],
                              expression_basis, vertices);
    });
    levels.map_error_mm = levels.mixture_error_mm = std::numeric_limits<double>::infinity();
    for (std::size_t noise = 0; noise < kNumNoises; ++noise) {
        Scores mean;
        for (std::size_t fold = 0; fold < folds.size(); ++fold) {
            const Scores& own = scores[fold * kNumNoises + noise];
            mean.map += own.map / static_cast<double>(folds.size());
            mean.mixture += own.mixture / static_cast<double>(folds.size());
            mean.residuals.insert(mean.residuals.end(), own.residuals.begin(), own.residuals.end());
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

FollowChoice choose_following(const Context& context, const ColumnSource& source,
                              const JointSpan& span, const Matrix& expression_basis,
                              const Matrix& expression_coordinates, Index identity_modes,
                              const PriorOptions& options) {
    const auto with = [&](Index directions) {
        PriorOptions own = options;
        own.identity_directions = directions;
        return FollowChoice{directions,
                            estimate_noise(context, source, span, expression_basis,
                                           expression_coordinates, identity_modes, own, {})};
    };
    std::map<int, Index> faces;
    bool some_follow = false;
    for (const int expression : source.displacement_expression)
        some_follow = some_follow || ++faces[expression] >= options.min_followers;
    if (options.identity_directions == 0 || !some_follow) return with(options.identity_directions);
    FollowChoice follows = with(options.identity_directions);
    if (source.num_neutrals() < kMostFolds) return follows;
    FollowChoice stays = with(0);
    const bool better = follows.noise.mixture_error_mm <
                        (1.0 - options.least_follow_gain) * stays.noise.mixture_error_mm;
    return better ? follows : stays;
}

SmoothChoice choose_smooth_prior(const Context& context, const ColumnSource& source,
                                 const JointSpan& span, const Matrix& expression_basis,
                                 const Matrix& expression_coordinates, Index identity_modes,
                                 const PriorOptions& options, const SmoothIdentityOptions& smooth,
                                 const Matrix& gram, const NoiseLevels& without) {
    SmoothChoice choice;
    choice.noise = without;
    if (source.num_neutrals() < kMostFolds || smooth.modes < 1) return choice;
    std::vector<SmoothChoice> all;
    double least = std::numeric_limits<double>::infinity();
    for (const double variance : smooth.variances_mm2) {
        context.check_cancelled();
        SmoothChoice own;
        own.prior = {gram, variance, smooth.modes};
        own.noise = variance > 0.0
                        ? estimate_noise(context, source, span, expression_basis,
                                         expression_coordinates, identity_modes, options, own.prior)
                        : without;
        least = std::min(least, own.noise.mixture_error_mm);
        choice.tried.push_back({variance, own.noise.mixture_error_mm});
        all.push_back(std::move(own));
    }
    for (SmoothChoice& own : all)
        if (own.noise.mixture_error_mm * (1.0 - smooth.least_gain) <= least) {
            choice.prior = std::move(own.prior);
            choice.noise = own.noise;
            break;
        }
    return choice;
}

}  // namespace mien
