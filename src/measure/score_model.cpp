#include "measure/score_model.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "geometry/curvature.hpp"
#include "geometry/rigid_zone.hpp"
#include "measure/area.hpp"
#include "measure/distributions.hpp"
#include "measure/pair_check.hpp"
#include "measure/score_direction.hpp"

namespace mien {
namespace {

Points align_face(const PointsRef& face, const PointsRef& mean, const TrianglesRef& triangles,
                  const std::vector<std::uint32_t>& stable_zone) {
    RigidZoneOptions options;
    options.tangential = 1.0;
    options.iterations = 6;
    const RigidZoneResult result = align_on_zone(face, mean, triangles, stable_zone, options);
    return result.motion.apply(face);
}

bool uses_curvature(const Vector& curvature_scale) {
    return curvature_scale.maxCoeff() > 0;
}

// Displacements of scaled vertices, then k1 and k2 of them; `row` has their number.
void features_of(const Points& aligned, const PointsRef& mean, const TrianglesRef& triangles,
                 const Vector& displacement_scale, const Vector& curvature_scale, double radius,
                 Eigen::Ref<Eigen::RowVectorXd> row) {
    Index next = 0;
    for (Index v = 0; v < aligned.rows(); ++v)
        if (displacement_scale[v] > 0) {
            row.segment<3>(next) = displacement_scale[v] * (aligned.row(v) - mean.row(v));
            next += 3;
        }
    if (!uses_curvature(curvature_scale)) return;
    CurvatureOptions options;
    options.radius_mm = radius;
    options.robust = false;  // fitted templates have no spikes
    const CurvatureField field = estimate_curvature(aligned, triangles, options, Context());
    const double bound = 1.0 / radius;  // what a fit over this radius can resolve
    for (Index v = 0; v < aligned.rows(); ++v)
        if (displacement_scale[v] > 0) {
            row[next++] = curvature_scale[v] * std::clamp(field.maximal[v], -bound, bound);
            row[next++] = curvature_scale[v] * std::clamp(field.minimal[v], -bound, bound);
        }
}

Index feature_count(const Vector& displacement_scale, const Vector& curvature_scale) {
    const Index vertices = (displacement_scale.array() > 0).count();
    return vertices * (uses_curvature(curvature_scale) ? 5 : 3);
}

void check_options(const ScoreOptions& options) {
    if (options.max_components < 1 || options.max_components > 50 || options.num_components < 0 ||
        options.num_components > 50 || options.folds < 0 || !(options.curvature_share >= 0) ||
        !std::isfinite(options.curvature_share) || !(options.curvature_radius_mm > 0) ||
        !std::isfinite(options.lowest) || !std::isfinite(options.highest) ||
        options.lowest > options.highest)
        fail(Status::invalid_argument,
             "score settings: components 1 to 50, folds 0 or more, curvature share %g (>= 0), "
             "radius %g "
             "mm (> 0), range %g to %g",
             options.curvature_share, options.curvature_radius_mm, options.lowest, options.highest);
}

void check_face(const ScoreModel& model, const PointsRef& face) {
    if (face.rows() != model.mean_face.rows())
        fail(Status::mismatch,
             "the face has %lld vertices, the score model %lld; fit it with the same template",
             static_cast<long long>(face.rows()), static_cast<long long>(model.mean_face.rows()));
    check_surface(face, model.triangles, "the face");
}

Vector latent_scores(const ScoreModel& model, const Points& aligned) {
    Eigen::RowVectorXd row(model.feature_mean.size());
    features_of(aligned, model.mean_face, model.triangles, model.displacement_scale,
                model.curvature_scale, model.curvature_radius_mm, row);
    return model.rotations.transpose() * (row.transpose() - model.feature_mean);
}

}  // namespace

ScoreModel train_score(const FaceDataset& faces, const Vector& grades, const ScoreOptions& options,
                       const Context& context) {
    check_options(options);
    if (grades.size() != faces.num_faces())
        fail(Status::mismatch,
             "%lld grades for %lld faces; give one per face, not-a-number for none",
             static_cast<long long>(grades.size()), static_cast<long long>(faces.num_faces()));
    std::vector<Index> used;
    for (Index k = 0; k < grades.size(); ++k)
        if (std::isfinite(grades[k])) used.push_back(k);
    const Index n = static_cast<Index>(used.size());
    if (n < 6)
        fail(Status::invalid_argument, "%lld graded faces; a score needs six or more",
             static_cast<long long>(n));
    const Index num_vertices = faces.num_vertices();
    check_zones({{"of interest", options.zone}, {"stable", options.stable_zone}}, num_vertices);

    ScoreModel model;
    model.triangles = faces.triangles();
    model.stable_zone = options.stable_zone;
    model.curvature_radius_mm = options.curvature_radius_mm;
    model.lowest = options.lowest;
    model.highest = options.highest;
    model.num_samples = n;
    // Mean of the faces aligned to the first one, then to that mean.
    Points face;
    faces.face(used.front(), face);
    Points reference = face;
    for (int round = 0; round < 2; ++round) {
        Points sum = Points::Zero(num_vertices, 3);
        for (Index k : used) {
            context.check_cancelled();
            faces.face(k, face);
            sum += align_face(face, reference, model.triangles, options.stable_zone);
        }
        reference = sum / static_cast<double>(n);
    }
    model.mean_face = reference;
    context.progress(Stage::training, 0.2);

    const std::vector<char> inside =
        options.zone.empty() ? std::vector<char>(static_cast<std::size_t>(num_vertices), 1)
                             : membership(options.zone, num_vertices);
    const Vector areas = vertex_areas(model.mean_face, model.triangles);
    model.displacement_scale = Vector::Zero(num_vertices);
    for (Index v = 0; v < num_vertices; ++v)
        if (inside[static_cast<std::size_t>(v)]) model.displacement_scale[v] = std::sqrt(areas[v]);
    if (!(model.displacement_scale.maxCoeff() > 0))
        fail(Status::invalid_argument, "the zone of interest has no area");
    model.curvature_scale =
        options.curvature_share > 0 ? model.displacement_scale : Vector(Vector::Zero(num_vertices));
    const Index p = feature_count(model.displacement_scale, model.curvature_scale);
    const Index p_displacement = (model.displacement_scale.array() > 0).count() * 3;
    context.require_memory(static_cast<std::size_t>(n) * static_cast<std::size_t>(3 * p + 15 * num_vertices) * 8,
                           "score features");
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(n, p);
    Matrix displacements(3 * num_vertices, n);
    parallel_for(context, static_cast<std::size_t>(n), 1, [&](std::size_t begin, std::size_t) {
        const Index i = static_cast<Index>(begin);
        Points own;
        faces.face(used[begin], own);
        const Points aligned =
            align_face(own, model.mean_face, model.triangles, options.stable_zone);
        const Points displacement = aligned - model.mean_face;
        displacements.col(i) = Eigen::Map<const Vector>(displacement.data(), displacement.size());
        Eigen::RowVectorXd row(p);
        features_of(aligned, model.mean_face, model.triangles, model.displacement_scale,
                    model.curvature_scale, model.curvature_radius_mm, row);
        rows.row(i) = row;
    });
    context.progress(Stage::training, 0.7);
    Matrix x = rows;
    if (p > p_displacement) {
        auto variance = [&](const auto& block) {
            return (block.rowwise() - block.colwise().mean()).squaredNorm();
        };
        const double spread = variance(x.leftCols(p_displacement));
        const double bending = variance(x.rightCols(p - p_displacement));
        const double scale =
            bending > 0 ? std::sqrt(options.curvature_share * spread / bending) : 0.0;
        x.rightCols(p - p_displacement) *= scale;
        model.curvature_scale *= scale;
    }
    Vector y(n);
    std::vector<int> subjects;
    for (Index i = 0; i < n; ++i) {
        y[i] = grades[used[static_cast<std::size_t>(i)]];
        subjects.push_back(faces.subject(used[static_cast<std::size_t>(i)]));
    }

    if ((y.array() == y[0]).all())
        fail(Status::no_solution, "all graded faces have the grade %g: there is nothing to learn", y[0]);
    displacements.colwise() -= displacements.rowwise().mean().eval();
    const ScoreDirection direction = score_direction(model.mean_face, displacements, areas, y, context);
    model.unit_displacement = Eigen::Map<const Points>(direction.displacement.data(), num_vertices, 3);

    CrossValidationOptions cv_options;
    cv_options.method = options.method;
    cv_options.max_components = std::max(options.max_components, options.num_components);
    cv_options.seed = options.seed;
    cv_options.groups = subjects;
    std::vector<int> distinct(subjects);
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    cv_options.folds =
        options.folds == 0 ? 0 : std::min<int>(options.folds, static_cast<int>(distinct.size()));
    // The focus of each vertex, repeated for its features in the order of features_of().
    const auto factors_of = [&](const Vector& focus) {
        Vector factors(p);
        Index next = 0;
        for (const Index repeats : {3, 2})
            for (Index v = 0; v < num_vertices && next < p; ++v)
                if (model.displacement_scale[v] > 0)
                    for (Index k = 0; k < repeats; ++k) factors[next++] = focus[v];
        return factors;
    };
    if (options.focus)
        cv_options.column_factors = [&](const std::vector<Index>& training) {
            Matrix own(displacements.rows(), static_cast<Index>(training.size()));
            Vector grades_of(own.cols());
            for (Index i = 0; i < own.cols(); ++i) {
                own.col(i) = displacements.col(training[static_cast<std::size_t>(i)]);
                grades_of[i] = y[training[static_cast<std::size_t>(i)]];
            }
            if ((grades_of.array() == grades_of[0]).all()) return Vector(Vector::Ones(p));
            return factors_of(focus_of(score_direction(model.mean_face, own, areas, grades_of, context)));
        };
    const CrossValidation cv = cross_validate_pls(x, y, cv_options, context);
    if (options.focus) {
        const Vector focus = focus_of(direction);
        model.focus_places = direction.places;
        x *= factors_of(focus).asDiagonal();
        model.displacement_scale.array() *= focus.array();
        model.curvature_scale.array() *= focus.array();
    }
    model.cv_error = cv.mean_squared_error;
    model.cv_standard_error = cv.standard_error;
    model.best_components = cv.best_components;
    model.one_se_components = cv.one_standard_error_components;
    PlsOptions pls_options;
    pls_options.method = options.method;
    pls_options.num_components =
        options.num_components > 0 ? options.num_components : cv.one_standard_error_components;
    const PlsModel pls = fit_pls(x, y, pls_options, context);
    const Index a = pls.num_components();
    const Index cv_column = std::min<Index>(a, cv.mean_squared_error.size() - 1);
    model.rmse = std::sqrt(model.cv_error[cv_column]);
    model.q2 = cv.r2(static_cast<int>(cv_column));
    model.cv_predictions = cv.predictions.col(cv_column);
    model.feature_mean = pls.x_mean;
    model.rotations = pls.rotations;
    model.y_loadings = pls.y_loadings.row(0).transpose();
    model.score_squares = pls.scores.colwise().squaredNorm().transpose();
    model.y_mean = pls.y_mean[0];

    // Displacement that goes with each latent variable.
    model.latent_pictures.resize(num_vertices, a);
    for (Index c = 0; c < a; ++c) {
        const double deviation = std::sqrt(model.score_squares[c] / static_cast<double>(n - 1));
        const Vector pattern =
            displacements * pls.scores.col(c) * (deviation / model.score_squares[c]);
        model.latent_pictures.col(c) =
            Eigen::Map<const Points>(pattern.data(), num_vertices, 3).rowwise().norm();
    }
    context.progress(Stage::training, 1.0);
    return model;
}

ScorePrediction predict_score(const ScoreModel& model, const PointsRef& face,
                              const Context& context) {
    check_face(model, face);
    context.check_cancelled();
    const Points aligned = align_face(face, model.mean_face, model.triangles, model.stable_zone);
    const Vector t = latent_scores(model, aligned);
    ScorePrediction result;
    result.score = model.y_mean + model.y_loadings.dot(t);
    result.leverage = (t.array().square() / model.score_squares.array()).sum();
    const double n = static_cast<double>(model.num_samples);
    const double a = static_cast<double>(model.num_components());
    result.extrapolates = result.leverage > 3.0 * (a + 1.0) / n;
    const double half = student_t_quantile(0.975, std::max(1.0, n - a - 1.0)) * model.rmse *
                        std::sqrt((1 + 1 / n + result.leverage) / (1 + (a + 1) / n));
    result.low95 = result.score - half;
    result.high95 = result.score + half;
    if (model.highest > model.lowest) {
        auto limit = [&](double v) { return std::clamp(v, model.lowest, model.highest); };
        result.score = limit(result.score);
        result.low95 = limit(result.low95);
        result.high95 = limit(result.high95);
    }
    return result;
}

Points simulate_score(const ScoreModel& model, const PointsRef& face, double target,
                      const Context& context) {
    check_face(model, face);
    context.check_cancelled();
    if (!std::isfinite(target)) fail(Status::invalid_argument, "the target score is not finite");
    RigidZoneOptions options;
    options.tangential = 1.0;
    options.iterations = 6;
    const RigidZoneResult pose =
        align_on_zone(face, model.mean_face, model.triangles, model.stable_zone, options);
    Points aligned = pose.motion.apply(face);
    const double own = model.y_mean + model.y_loadings.dot(latent_scores(model, aligned));
    aligned += (target - own) * model.unit_displacement;
    return pose.motion.inverse().apply(PointsRef(aligned));
}

}  // namespace mien
